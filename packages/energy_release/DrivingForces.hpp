#pragma once
/// Driving forces of the nodes of crack fronts, in every step, for effects that let fronts grow.

#include "energy_release/FrontIntegral.hpp"
#include "energy_release/FrontTube.hpp"
#include "energy_release/InternalAcceleration.hpp"
#include "plan/Effect.hpp"

#include <memory>
#include <vector>

namespace Rhegma::energy_release
{

/// Computes FrontNode::driving by domain integrals, in 2D with CrackSet::drivingContours. Tubes shrink where
/// a surface, another front or another crack is near, and are fitted anew when a front has moved on.
template <int D>
class DrivingForces
{
public:
  /// J at the nodes of all fronts that have neither ended nor stopped, or that it can't be computed
  /// (DrivingForce::lost).
  void computeRelease(State<D>& state);

  /// Stress intensities at the nodes of fronts of which any node is about to advance.
  void computeIntensities(State<D>& state);

  /// Saves or loads where the tubes were fitted.
  void serialize(Archive& archive);

private:
  struct Fitted
  {
    std::vector<double> at; ///< positions then of the front's nodes and of those of fronts near it [m]
    double cell = 0.0;      ///< edge of the cells there [m]
    FrontTube release, intensity;
    BlocksInReach<D> blocks{}; ///< around the front
  };
  const Fitted& tubesOf(const State<D>& state, std::size_t front);

  std::vector<Fitted> fitted_;
  FrontRowTable<D> rows_; ///< of one front after the other
  InternalAcceleration<D> acceleration_;
};

/// Adds the calls that compute the driving forces, of a scene with fronts that grow.
template <int D>
void addDrivingCalls(Effect<D>& effect, const Teuchos::ParameterList& scene,
                     const std::shared_ptr<DrivingForces<D>>& driving);

} // namespace Rhegma::energy_release
