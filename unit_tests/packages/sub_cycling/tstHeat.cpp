/// Bars whose motion heats and cools them while the fine cells in their middle take substeps.

#include "Bars.hpp"
#include "state/EnergySums.hpp"

#include <algorithm>

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
  const auto id = onHost(state.particles.integer(fields::id));
  const auto value = onHost(state.particles.scalar(fields::temperature));
  std::vector<double> rises(value.extent(0));
  for (int p = 0; p < state.particles.size(); ++p)
    rises[id(p)] = value(p) - 300.0;
  return rises;
}

/// A block of E = rho = 1 with fine cells in a box, whose left side cannot move across.
Teuchos::ParameterList block(const Vector<2>& size, const Vector<2>& from, const Vector<2>& to, int levels)
{
  Teuchos::ParameterList scene =
      emptyScene<2>(Vector<2>{{-4.0, -4.0}}, size + Vector<2>{{4.0, 4.0}}, 1.0, "MUSL", "GIMP");
  addMaterial(scene, "Linear Elastic", 0.3);
  addBox<2>(scene, "Block", Vector<2>{{0.0, 0.0}}, size);
  Teuchos::ParameterList& adaptivity = scene.sublist("Adaptivity");
  adaptivity.set("Maximum Level", levels);
  adaptivity.set("Interval", 1000000);
  Teuchos::ParameterList& box = adaptivity.sublist("Box");
  box.set("Lower Corner", array(from));
  box.set("Upper Corner", array(to));
  box.set("Level", levels);
  scene.sublist("Sub-Cycling").set("Levels", levels);
  Teuchos::ParameterList& wall = scene.sublist("Boundaries").sublist("Wall");
  wall.set("Type", "Symmetry");
  wall.set("Axis", "x");
  wall.set("Position", 0.0);
  wall.set("Side", "Lower");
  scene.sublist("Thermal").set("Initial Temperature", 300.0);
  return scene;
}

/// Residual of the energy balance of a run, at most, and the most of kinetic and strain energy, of the change
/// of strain energy in a step and of that of heat [J].
struct OpenBalances
{
  double residual = 0.0, energy = 0.0, step = 0.0, heat = 0.0;
};

constexpr double shear = 0.2, bulk = 0.1; // viscosities [Pa s]

/// Adds up what viscosity would take in steps by the change of the rates of strain from step to step.
struct ViscousChange
{
  std::vector<double> last; ///< rates of strain, by id
  double sum = 0.0;         ///< [J]

  void add(const State<2>& state)
  {
    const auto copy = [](const auto& view) { return onHost(view); };
    const auto rate = copy(state.particles.table(fields::rate));
    const auto volume = copy(state.particles.scalar(fields::volume));
    const auto id = copy(state.particles.integer(fields::id));
    last.resize(3 * volume.extent(0));
    for (std::size_t p = 0; p < volume.extent(0); ++p)
    {
      double* const old = &last[3 * id(p)];
      const double now[3] = {rate(p, 0), rate(p, 3), 0.5 * (rate(p, 1) + rate(p, 2))};
      const double x = now[0] - old[0], y = now[1] - old[1], xy = now[2] - old[2];
      sum += state.clock.dt * volume(p) *
             (2.0 * shear * (x * x + y * y + 2.0 * xy * xy) + bulk * (x + y) * (x + y));
      std::copy(now, now + 3, old);
    }
  }
};

OpenBalances openBalances(const Teuchos::ParameterList& scene, double end, ViscousChange* viscous = nullptr)
{
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  State<2>& state = run.state();
  measureEnergy(state);
  state.energy.start = state.energy.kinetic + state.energy.strain;
  state.energy.thermalStart += state.energy.thermal;
  OpenBalances most;
  double before = state.energy.strain, cold = state.energy.thermal;
  while (state.clock.time < end && state.failure.empty())
  {
    run.step(end, false);
    measureEnergy(state);
    if (viscous != nullptr)
      viscous->add(state);
    most.residual = std::max(most.residual, std::fabs(state.energy.residual()));
    most.energy = std::max(most.energy, state.energy.kinetic + state.energy.strain);
    most.step = std::max(most.step, std::fabs(state.energy.strain - before));
    most.heat = std::max(most.heat, std::fabs(state.energy.thermal - cold));
    before = state.energy.strain;
    cold = state.energy.thermal;
  }
  EXPECT_EQ(state.failure, "");
  return most;
}

class SubcycledHeat : public testing::TestWithParam<int>
{
};

} // namespace

TEST_P(SubcycledHeat, keepsEnergyOverTenPeriods)
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

TEST_P(SubcycledHeat, keepsTheEnergyOfAnEntropicRubber)
{
  const Outcome o = vibrate<2>(GetParam(), true, Start::Smooth, 0.4, 10, "GIMP", addWarmRubber);
  std::printf("%d levels, rubber: energy kept %.6f, most %.6f, momentum %.1e\n", GetParam(), o.kept, o.most,
              o.momentum);
  EXPECT_NEAR(o.kept, 1.0, 1e-3);
  EXPECT_LT(o.momentum, 1e-12);
}

/// The motion after a period, damped by what conducts, and temperatures during it are those of the same bar
/// in substeps only.
TEST_P(SubcycledHeat, movesAndWarmsAsInSmallStepsOnly)
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
    while (state.clock.time < 0.3 * period)
      run.step(0.3 * period, false);
    temperature[subCycled] = risesOf(state);
    while (state.clock.time < period)
      run.step(period, false);
    mode[subCycled] = fractionOfMode(state);
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

/// Fine cells are heated and cooled, and their stresses with them, once a step. The balance is accurate to
/// half of the work of stresses in a step, since velocities are half a step behind.
TEST_P(SubcycledHeat, theBalanceKnowsWhatHeatDoesToStresses)
{
  Teuchos::ParameterList scene =
      block(Vector<2>{{16.0, 8.0}}, Vector<2>{{6.0, 2.0}}, Vector<2>{{10.0, 6.0}}, GetParam());
  Teuchos::ParameterList& material = scene.sublist("Materials").sublist("Solid");
  material.set("Specific Heat", 60.0);
  material.set("Conductivity", 0.01);
  material.set("Thermal Expansion", 1e-4);
  Teuchos::ParameterList& lamp = scene.sublist("Thermal").sublist("Sources").sublist("Lamp");
  lamp.set("Type", "Ball");
  lamp.set("Centre", array(Vector<2>{{8.0, 4.0}}));
  lamp.set("Radius", 1.0);
  lamp.set("Power", 2.0);
  lamp.set("History", std::string("sin(0.7*t)"));
  const OpenBalances most = openBalances(scene, 30.0);
  std::printf("%d levels: open %.3f of what moves and strains, half a step %.3f\n", GetParam(),
              most.residual / most.energy, 0.5 * most.step / most.energy);
  EXPECT_LT(most.residual, 0.5 * most.step);
}

/// A block whose modulus without heat flow is 2.7 times that at constant temperature meets a wall with its
/// fine cells. At strains of half a percent the temperature to which straining brings a particle is not that
/// of small strain by as much; stresses that lag by it would double the energy.
TEST_P(SubcycledHeat, aStrongCouplingIsNoSourceOfEnergy)
{
  Teuchos::ParameterList scene =
      block(Vector<2>{{8.0, 4.0}}, Vector<2>{{-1.0, -1.0}}, Vector<2>{{3.0, 9.0}}, GetParam());
  Teuchos::ParameterList& material = scene.sublist("Materials").sublist("Solid");
  // T (3 K alpha)^2 / (rho c M) = 1.7, M = K + 4/3 mu.
  const double capacity = 0.6, bulk = 1.0 / 1.2, modulus = 0.7 / (1.3 * 0.4);
  material.set("Specific Heat", capacity);
  material.set("Conductivity", 0.0);
  material.set("Thermal Expansion", std::sqrt(1.7 * modulus * capacity / 300.0) / (3.0 * bulk));
  scene.sublist("Bodies").sublist("Block").set("Velocity", array(Vector<2>{{-3e-3, 0.0}}));
  const OpenBalances most = openBalances(scene, 60.0);
  std::printf("%d levels, strong coupling: open %.3f of what moves and strains, half a step %.3f\n",
              GetParam(), most.residual / most.energy, 0.5 * most.step / most.energy);
  EXPECT_LT(most.residual, 0.5 * most.step);
}

/// Viscosity turns what it takes from motion into heat, in fine cells too. In a step the stress of its start,
/// of the rates D1, acts on the mean of D1 and D2: what it takes is a dt D1 (D1 + D2) / 2. With a fraction s
/// of the first force, recorded are a dt (s D1 D2 / 2 + (1 - s / 2) D2 D2), which is more by a dt ((3
/// - s) / 4 (D2^2 - D1^2) + (1 - s) / 4 (D2 - D1)^2): the first adds up to a part of one step's work, the
/// second is of second order.
TEST_P(SubcycledHeat, theHeatOfViscosityIsAllThere)
{
  Teuchos::ParameterList scene =
      block(Vector<2>{{8.0, 4.0}}, Vector<2>{{-1.0, -1.0}}, Vector<2>{{3.0, 9.0}}, GetParam());
  Teuchos::ParameterList& material = scene.sublist("Materials").sublist("Solid");
  material.set("Specific Heat", 60.0);
  material.set("Conductivity", 0.0);
  scene.sublist("Damping").set("Shear Viscosity", shear);
  scene.sublist("Damping").set("Bulk Viscosity", bulk);
  scene.sublist("Bodies").sublist("Block").set("Velocity", array(Vector<2>{{-3e-3, 0.0}}));
  scene.sublist("Time").set("Final Time", 3.0);
  const double fraction = std::pow(0.5, GetParam());
  ViscousChange viscous;
  const OpenBalances most = openBalances(scene, 3.0, &viscous);
  const double bound =
      0.5 * most.step + 0.25 * (3.0 - fraction) * most.heat + 0.25 * (1.0 - fraction) * viscous.sum;
  std::printf("%d levels, viscous: open %.4f of what moves and strains, bound %.4f, of which %.4f by changes "
              "of rates\n",
              GetParam(), most.residual / most.energy, bound / most.energy,
              0.25 * (1.0 - fraction) * viscous.sum / most.energy);
  EXPECT_GT(most.heat, 0.0);
  EXPECT_LT(most.residual, bound);
}

INSTANTIATE_TEST_SUITE_P(SubCycling, SubcycledHeat, testing::Values(1, 2, 3));

TEST(SubcycledHeat3D, keepsEnergy)
{
  const Outcome o = vibrate<3>(2, true, Start::Smooth, 0.4, 2, "GIMP",
                               [](Teuchos::ParameterList& scene) { addHeat(scene, 0.0); });
  EXPECT_NEAR(o.kept, 1.0, 1e-3);
  EXPECT_LT(o.momentum, 1e-12);
}

} // namespace Test
} // namespace Rhegma
