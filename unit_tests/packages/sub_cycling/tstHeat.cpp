/// Bars whose motion heats and cools them while the small cells in their middle take short steps.

#include "Bars.hpp"

namespace Rhegma
{
namespace Test
{

namespace
{

/// Straining without heat flow is stiffer by T (3 K alpha)^2 / (rho c E), here 5 %.
void addHeat(Teuchos::ParameterList& scene, double conductivity)
{
  Teuchos::ParameterList& list = scene.sublist("Materials").sublist("Solid");
  list.set("Specific Heat", 0.6);
  list.set("Conductivity", conductivity);
  list.set("Thermal Expansion", 0.01);
  scene.sublist("Thermal").set("Initial Temperature", 300.0);
}

/// An entropic rubber: moduli that are tables, so that stress, energy and temperature are found together.
void addWarmRubber(Teuchos::ParameterList& scene)
{
  Teuchos::ParameterList& list = scene.sublist("Materials").sublist("Solid");
  list.set("Entropic", true);
  list.set("Specific Heat", 0.6);
  list.set("Conductivity", 0.0);
  scene.sublist("Thermal").set("Initial Temperature", 300.0);
}

/// Rise of the temperature of every particle, by id.
std::vector<double> risesOf(const State<2>& state)
{
  const auto id =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.particles.integer(fields::id));
  const auto value =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.particles.scalar(fields::temperature));
  std::vector<double> rises(value.extent(0));
  for (int p = 0; p < state.particles.size(); ++p)
    rises[id(p)] = value(p) - 300.0;
  return rises;
}

class HeatInShortSteps : public testing::TestWithParam<int>
{
};

} // namespace

TEST_P(HeatInShortSteps, keepsEnergyOverTenPeriods)
{
  for (const Start kind : {Start::Smooth, Start::Random})
  {
    const Outcome o = vibrate<2>(GetParam(), true, kind, 0.4, 10, "GIMP",
                                 [](Teuchos::ParameterList& scene) { addHeat(scene, 0.0); });
    std::printf("%d levels, %s: energy kept %.6f, most %.6f, momentum %.1e\n", GetParam(),
                kind == Start::Smooth ? "smooth" : "random", o.kept, o.most, o.momentum);
    EXPECT_NEAR(o.kept, 1.0, kind == Start::Smooth ? 1e-3 : 0.03);
    EXPECT_LT(o.momentum, 1e-12);
  }
}

TEST_P(HeatInShortSteps, keepsTheEnergyOfAnEntropicRubber)
{
  const Outcome o = vibrate<2>(GetParam(), true, Start::Smooth, 0.4, 10, "GIMP", addWarmRubber);
  std::printf("%d levels, rubber: energy kept %.6f, most %.6f, momentum %.1e\n", GetParam(), o.kept, o.most,
              o.momentum);
  EXPECT_NEAR(o.kept, 1.0, 1e-3);
  EXPECT_LT(o.momentum, 1e-12);
}

/// The motion after a period, damped by what conducts, and temperatures on the way are those of the same bar
/// in short steps only.
TEST_P(HeatInShortSteps, movesAndWarmsAsInShortStepsOnly)
{
  const double period = 2.0 * length;
  std::vector<double> temperature[2];
  double mode[2] = {};
  for (const bool subCycled : {false, true})
  {
    Rhegma::Run<2> run = bar<2>(GetParam(), subCycled, 0.4, 0.0, "GIMP",
                                [](Teuchos::ParameterList& scene) { addHeat(scene, 0.3); });
    State<2>& state = run.state();
    start(state, Start::Smooth);
    while (state.time < 0.3 * period)
      run.step(0.3 * period, false);
    temperature[subCycled] = risesOf(state);
    while (state.time < period)
      run.step(period, false);
    mode[subCycled] = shareOfMode(state);
  }
  double most = 0.0, differs = 0.0;
  for (std::size_t p = 0; p < temperature[0].size(); ++p)
  {
    most = std::max(most, std::fabs(temperature[0][p]));
    differs = std::max(differs, std::fabs(temperature[1][p] - temperature[0][p]));
  }
  std::printf("%d levels: mode %.6f %.6f, warmest %.3e K, differs by %.3f of it\n", GetParam(), mode[1],
              mode[0], most, differs / most);
  EXPECT_NEAR(mode[1], mode[0], 0.002);
  EXPECT_LT(differs, 0.02 * most); // the velocity is that of half a step before
}

INSTANTIATE_TEST_SUITE_P(SubCycling, HeatInShortSteps, testing::Values(1, 2, 3));

TEST(HeatInShortStepsInSpace, keepsEnergy)
{
  const Outcome o = vibrate<3>(2, true, Start::Smooth, 0.4, 2, "GIMP",
                               [](Teuchos::ParameterList& scene) { addHeat(scene, 0.0); });
  EXPECT_NEAR(o.kept, 1.0, 1e-3);
  EXPECT_LT(o.momentum, 1e-12);
}

} // namespace Test
} // namespace Rhegma
