/// Damped front springs of nodes that move in substeps: the velocity of each substep acts.

#include "Bars.hpp"
#include "state/EnergySums.hpp"

namespace Rhegma
{
namespace Test
{

namespace
{

/// What damping takes from a bar with a crack that opens and closes, over its energy.
double takenOf(int levels, bool subCycled)
{
  const auto crack = [](Teuchos::ParameterList& scene)
  {
    scene.sublist("Cracks").sublist("Split").set(
        "Points", Teuchos::Array<double>(Teuchos::tuple(0.0, 1.07, 0.5 * length + 0.06, 1.07)));
  };
  Rhegma::Run<2> run = bar<2>(levels, subCycled, 0.3, 0.0, "GIMP", crack);
  State<2>& state = run.state();
  const HostParticles<2> particles(state);
  for (int p = 0; p < particles.size; ++p)
    particles.velocity(p, 1) =
        amplitude * std::cos(pi * particles.position(p, 0) / length) * (particles.position(p, 1) - 1.0);
  particles.store(state);
  measureEnergy(state);
  const double first = state.energy.kinetic;
  const double end = 4.0 * length;
  while (state.clock.time < end)
    run.step(end, false);
  return state.energy.stabilised / first;
}

} // namespace

class DampedSprings : public testing::TestWithParam<int>
{
};

TEST_P(DampedSprings, TakeTheSameAsInShortStepsOnly)
{
  const double sub = takenOf(GetParam(), true), all = takenOf(GetParam(), false);
  std::printf("%d levels: taken %.5f of the energy, in substeps only %.5f\n", GetParam(), sub, all);
  EXPECT_GT(all, 1e-3);
  // The coarse cells take longer steps: the error of their motion goes with the square of the CFL number,
  // 0.1.
  EXPECT_NEAR(sub, all, 0.05 * all);
}

INSTANTIATE_TEST_SUITE_P(SubCycling, DampedSprings, testing::Values(1, 2));

} // namespace Test
} // namespace Rhegma
