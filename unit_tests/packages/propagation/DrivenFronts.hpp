#pragma once
/// Fronts whose driving forces a test sets itself.

#include "plan/Effect.hpp"

#include <vector>

namespace Rhegma::Test
{

/// The effect that stands for Energy Release in the plan: it declares the driving forces, which the test
/// writes between steps.
template <int D>
std::vector<Effect<D>> drivenByTest()
{
  Effect<D> effect;
  effect.name = "driving forces of the test";
  effect.call({Stage::OnParticles,
               "driving forces of the test",
               {},
               {quantity::drivingForces, quantity::stressIntensities},
               {},
               [](State<D>&) {}});
  return {effect};
}

} // namespace Rhegma::Test
