#pragma once
/// What drives the front nodes of 3D fronts on, in every step, for who lets them grow.

#include "energy_release/FrontTube.hpp"
#include "energy_release/InternalAcceleration.hpp"

#include <vector>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::energy_release
{

/// Measures FrontNode::driving: J by FrontIntegral.hpp, intensities by FrontOpening.hpp.
/// Tubes are fitted anew when a front has moved on by a cell or has other front nodes.
class FrontDriving
{
public:
  /// J at every front node of the fronts that are fronts still.
  void measureRelease(State<3>& state);

  /// Stress intensities at the front nodes of fronts of which any is about to advance.
  void measureIntensities(State<3>& state);

  /// Saves or loads where the tubes were fitted.
  void keep(Archive& archive);

private:
  struct Fitted
  {
    std::vector<double> at; ///< places of the front nodes then, one after the other [m]
    FrontTube tube{{0.0, 0.0}, 0.0};
  };
  const FrontTube& tubeOf(const State<3>& state, std::size_t front, const FrontLine& line);

  std::vector<Fitted> fitted_;
  NodalAcceleration<3> acceleration_;
};

} // namespace Rhegma::energy_release
