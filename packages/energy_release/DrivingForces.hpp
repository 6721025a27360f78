#pragma once
/// What drives crack fronts on, in every step, for who lets them grow.

#include "energy_release/Contour.hpp"
#include "energy_release/InternalAcceleration.hpp"

#include <vector>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::energy_release
{

/// Measures CrackFront::driving by the domain integrals, with CrackSet::drivingContours. Radii shrink where
/// the surface, another front or another crack is near, and are looked at anew when a front has moved on.
class DrivingForces
{
public:
  /// J of every front that is one still.
  void measureRelease(State<2>& state);

  /// Stress intensities of the fronts that are about to advance.
  void measureIntensities(State<2>& state);

  /// Saves or loads where the radii were found.
  void keep(Archive& archive);

private:
  struct Contours
  {
    Vector<2> at{{0.0, 0.0}}; ///< place of the front for which the radii were found [m]
    double cell = 0.0;        ///< edge of the cells there [m]; 0: not found yet
    ContourRadii release{0.0, 0.0}, intensity{0.0, 0.0};
  };
  const Contours& contoursOf(const State<2>& state, std::size_t front);

  std::vector<Contours> contours_;
  NodalAcceleration<2> acceleration_;
};

} // namespace Rhegma::energy_release
