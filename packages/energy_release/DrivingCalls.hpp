#pragma once
/// What drives fronts that grow, measured in every step.

#include "archive/Archive.hpp"
#include "plan/Effect.hpp"
#include "plan/LastStage.hpp"

#include <memory>

namespace Rhegma::energy_release
{

/// Adds the calls that measure what drives the fronts of a scene in which they grow.
/// \param driving DrivingForces in 2D, FrontDriving in 3D
template <int D, class Driving>
void addDrivingCalls(Effect<D>& effect, const Teuchos::ParameterList& scene,
                     const std::shared_ptr<Driving>& driving)
{
  effect.call(
      {lastStage(scene),
       "driving forces of crack fronts",
       {quantity::particleStress, quantity::particleVelocity, quantity::crackGeometry,
        quantity::enrichedFields, ifWritten(quantity::springForce), ifWritten(quantity::facePressure)},
       {quantity::drivingForces},
       {},
       [driving](State<D>& state) { driving->measureRelease(state); }});
  effect.call({lastStage(scene),
               "intensities at fronts that advance",
               {quantity::drivingForces, quantity::advancingFronts},
               {quantity::stressIntensities},
               {},
               [driving](State<D>& state) { driving->measureIntensities(state); }});
}

/// Saves or loads the samples and what drives the fronts.
template <class Samples, class Driving>
void keepBoth(Samples& samples, Driving& driving, Archive& archive)
{
  keep(samples, archive);
  const Archive::Group group(archive, "driving forces");
  driving.keep(archive);
}

} // namespace Rhegma::energy_release
