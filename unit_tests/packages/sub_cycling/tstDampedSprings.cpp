/// Damped front springs of nodes that move in substeps: the velocity of each substep acts.

#include "Bars.hpp"
#include "state/EnergySums.hpp"

namespace Rhegma
{
namespace Test
{

namespace
{

/// What damping takes from a bar with a crack that opens and closes, over its energy, and by how much the
/// energy changes beyond that.
struct Loss
{
  double taken = 0.0, open = 0.0;
};

Loss opens(int levels, bool subCycled)
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
  double mean = 0.0;
  const int last = 8; // means over the time that waves need to cross the bar's height and back
  for (int k = 0; k < 12; ++k)
  {
    while (state.clock.time < 4.0 * (k + 1))
      run.step(4.0 * (k + 1), false);
    measureEnergy(state);
    if (k >= last)
      mean += (state.energy.kinetic + state.energy.strain + state.energy.stabilised) / (12 - last);
  }
  return {state.energy.stabilised / first, mean / first - 1.0};
}

} // namespace

class DampedSprings : public testing::TestWithParam<int>
{
};

TEST_P(DampedSprings, TakeTheSameAsInShortStepsOnly)
{
  const Loss sub = opens(GetParam(), true), all = opens(GetParam(), false);
  std::printf("%d levels: taken %.5f of the energy, in substeps only %.5f; open by %+.1e, %+.1e\n",
              GetParam(), sub.taken, all.taken, sub.open, all.open);
  EXPECT_GT(all.taken, 1e-3);
  EXPECT_NEAR(sub.taken, all.taken, 0.02 * all.taken);
  EXPECT_NEAR(sub.open, all.open, 0.05 * all.taken);
}

INSTANTIATE_TEST_SUITE_P(SubCycling, DampedSprings, testing::Values(1, 2));

} // namespace Test
} // namespace Rhegma
