/// Conduction on the nodes: heat is conserved, a linear field stays one on any cells and wherever the
/// particles are, and the solutions of textbooks come out.

#include "adaptivity/Splitting.hpp"
#include "packages/thermal/HeatedBars.hpp"
#include "state/EnergySums.hpp"
#include "step/CoreStep.hpp"
#include "thermal/HeatNodes.hpp"
#include "transfer/Stencils.hpp"

#include <functional>

namespace Rhegma
{
namespace Test
{

namespace
{

template <int D>
void checkThatHeatIsKept(const std::string& shape)
{
  Teuchos::ParameterList scene = bar<D>(1.0, shape);
  scene.sublist("Materials").sublist("Solid").set("Specific Heat", std::string("250:1.5, 350:2.5"));
  scene.sublist("Materials").sublist("Solid").set("Conductivity", std::string("250:1, 350:2"));
  Run<D> run(validated(scene));
  run.initialize();
  randomTemperature(run.state());
  const auto before = heatOf(run.state());
  double spread = 0.0;
  forEach<D>(run.state(),
             [&](const Vector<D>&, double T) { spread = std::max(spread, std::fabs(T - 300.0)); });
  EXPECT_GT(spread, 90.0);
  steps(run, 200);
  EXPECT_NEAR(heatOf(run.state()).first, before.first, 1e-13 * before.second);
  EXPECT_EQ(run.state().energy.heat, 0.0);
}

template <int D>
void checkThatRestStays()
{
  Teuchos::ParameterList scene = bar<D>();
  scene.sublist("Materials").sublist("Solid").remove("Conductivity");
  scene.sublist("Time").set("Final Time", 1e3);
  Run<D> run(validated(scene));
  run.initialize();
  run.step(1e3, false); // sorts the particles
  randomTemperature(run.state());
  std::vector<double> before;
  forEach<D>(run.state(), [&](const Vector<D>&, double T) { before.push_back(T); });
  for (int s = 0; s < 50; ++s)
    run.step(1e3, false);
  std::size_t p = 0;
  forEach<D>(run.state(), [&](const Vector<D>&, double T) { EXPECT_NEAR(T, before[p++], 1e-13 * T); });
}

/// A steady field between two columns of nodes that are held.
template <int D>
void checkSteadyField(const std::string& shape, int level)
{
  Teuchos::ParameterList scene = bar<D>(1.0, shape);
  hold<D>(scene, "Cold", 1.0, 1.0, 320.0);
  hold<D>(scene, "Hot", 5.0, 5.0, 400.0);
  if (level > 0)
    refineMiddle<D>(scene, level);
  Run<D> run(validated(scene));
  run.initialize();
  steps(run, 1000 << (2 * level));
  const double worst =
      worstBetween<D>(run.state(), [](const Vector<D>& position) { return 300.0 + 20.0 * position[0]; });
  // Of 20 K a cell.
  EXPECT_LT(worst, 1e-8) << shape << " level " << level;
}

/// A linear field on particles that have drifted anywhere, and have split as they touched smaller cells, is
/// that of all nodes, and no heat flows into a node inside the body: the patch test.
template <int D>
void checkPatch(const std::string& shape, int level, const Vector<D>& shift)
{
  const Vector<D> size = all<D>(6.0);
  Teuchos::ParameterList scene = bar<D>(1.0, shape, 6.0, 6.0);
  Teuchos::ParameterList& adaptivity = scene.sublist("Adaptivity");
  adaptivity.set("Maximum Level", level);
  adaptivity.sublist("Middle").set("Lower Corner", array(all<D>(2.0)));
  adaptivity.sublist("Middle").set("Upper Corner", array(all<D>(4.0)));
  adaptivity.sublist("Middle").set("Level", level);
  Run<D> run(validated(scene));
  run.initialize();
  State<D>& state = run.state();
  const auto linear = [](const auto& position)
  {
    double T = 300.0;
    for (int d = 0; d < D; ++d)
      T += (20.0 - 7.0 * d) * position[d];
    return T;
  };
  const auto x = onHost(state.particles.template real<D>(fields::position));
  const auto g = onHost(state.particles.template real<D>(fields::temperatureGradient));
  const auto T = onHost(state.particles.scalar(fields::temperature));
  for (int p = 0; p < state.particles.size(); ++p)
  {
    Vector<D> position;
    for (int d = 0; d < D; ++d)
    {
      position[d] = x(p, d) = x(p, d) + shift[d];
      g(p, d) = 20.0 - 7.0 * d;
    }
    T(p) = linear(position);
  }
  Kokkos::deep_copy(state.particles.template real<D>(fields::position), x);
  Kokkos::deep_copy(state.particles.template real<D>(fields::temperatureGradient), g);
  Kokkos::deep_copy(state.particles.scalar(fields::temperature), T);
  const int before = state.particles.size();
  adaptivity::splitParticles(state);
  EXPECT_NE(state.particles.size(), before);
  sortState(state);
  storeStencils(state);
  forEach<D>(state,
             [&](const Vector<D>& position, double found) { EXPECT_NEAR(found, linear(position), 1e-11); });
  thermal::HeatNodes<D> nodes;
  nodes.clear(state);
  thermal::heatToNodes(state, nodes);
  thermal::findTemperature(state, nodes);
  thermal::fluxToNodes(state, nodes, View<double*>());
  const auto sums = onHost(nodes.sums);
  const auto value = onHost(nodes.value);
  const auto rate = onHost(nodes.rate);
  const auto active = onHost(state.mesh.nodes.active);
  const NodePositions<D> positions = nodePositions(state);
  int inside = 0;
  for (int i = 0; i < static_cast<int>(active.extent(0)); ++i)
  {
    const int n = active(i);
    const Vector<D> position = positions(n);
    if (!(sums(n, 0) > 0.0))
      continue;
    // Lighter nodes have a sum of small numbers at large distances.
    EXPECT_NEAR(value(n, 0), linear(position), sums(n, 0) > 1e-6 ? 1e-9 : 1e-4) << sums(n, 0);
    bool in = true;
    for (int d = 0; d < D; ++d)
      in = in && position[d] - 1.0 > shift[d] && position[d] + 1.0 < size[d] + shift[d];
    if (!in)
      continue;
    ++inside;
    // Of 40 W through the face of a cell: k = 2, 20 K/m.
    EXPECT_NEAR(rate(n, 0), 0.0, 1e-9);
  }
  EXPECT_GE(inside, D == 2 ? 16 : 64);
}

/// Largest error of a mode cos(pi x / L) after a time, over its amplitude at the start.
double errorOfMode(double cell)
{
  const double length = 6.0, time = 2.0, k = 3.14159265358979323846 / length;
  Teuchos::ParameterList scene = bar<2>(cell, "GIMP", length, 2.0);
  scene.sublist("Bodies").sublist("Bar").set("Temperature Field", std::string("300 + 10 * cos(pi * x / 6)"));
  Run<2> run(validated(scene));
  run.initialize();
  while (run.state().clock.time < time)
    run.step(time, false);
  double worst = 0.0;
  forEach<2>(run.state(),
             [&](const Vector<2>& x, double T) {
               worst = std::max(worst,
                                std::fabs(T - 300.0 - 10.0 * std::exp(-k * k * time) * std::cos(k * x[0])));
             });
  return 0.1 * worst;
}

} // namespace

TEST(Conduction, KeepsHeatInAnInsulatedBody)
{
  checkThatHeatIsKept<2>("GIMP");
  checkThatHeatIsKept<2>("Linear");
  checkThatHeatIsKept<3>("GIMP");
}

TEST(Conduction, LeavesAFieldAloneThatDoesNotConduct)
{
  checkThatRestStays<2>();
  checkThatRestStays<3>();
}

TEST(Conduction, KeepsALinearField)
{
  checkSteadyField<2>("GIMP", 0);
  checkSteadyField<2>("Linear", 0);
  checkSteadyField<3>("GIMP", 0);
  checkSteadyField<2>("GIMP", 1);
}

TEST(Conduction, PassesThePatchTestOnRefinedCellsAfterADrift)
{
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> anywhere(-0.9, 0.9);
  for (int drift = 0; drift < 10; ++drift)
  {
    Vector<2> flat{{anywhere(engine), anywhere(engine)}};
    checkPatch<2>("GIMP", 1 + drift % 2, flat);
    if (drift > 2)
      continue;
    Vector<3> solid{{anywhere(engine), anywhere(engine), anywhere(engine)}};
    checkPatch<3>("GIMP", 1, solid);
  }
}

TEST(Conduction, ConvergesWithTheSquareOfTheCells)
{
  const double coarse = errorOfMode(0.5), middle = errorOfMode(0.25), fine = errorOfMode(0.125);
  EXPECT_LT(fine, 1e-3);
  EXPECT_NEAR(coarse / middle, 4.0, 0.6);
  EXPECT_NEAR(middle / fine, 4.0, 0.6);
}

/// Conductivity k0 (1 + b (T - 300)): by Kirchhoff's transformation the steady T solves (T - 300) + b (T -
/// 300)^2 / 2 = x / L times its value at the hot end.
TEST(Conduction, FollowsKirchhoffsTransformation)
{
  Teuchos::ParameterList scene = bar<2>(0.5);
  scene.sublist("Materials").sublist("Solid").set("Conductivity", std::string("300:1, 500:3"));
  hold<2>(scene, "Cold", -1.0, 0.0, 300.0);
  hold<2>(scene, "Hot", 6.0, 7.0, 500.0);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  steps(run, 4000);
  const double b = 0.01, end = 200.0 + 0.5 * b * 200.0 * 200.0;
  forEach<2>(run.state(),
             [&](const Vector<2>& x, double T)
             {
               const double rise = (std::sqrt(1.0 + 2.0 * b * end * x[0] / 6.0) - 1.0) / b;
               EXPECT_NEAR(T - 300.0, rise, 0.01 * 200.0) << x[0];
             });
}

/// Ratios turn with the body: along its first axis, which lies across the bar of cells, heat flows four times
/// as fast.
TEST(Conduction, OrthotropicAlongTheAxesOfTheBody)
{
  const auto amplitude = [](double rotation)
  {
    Teuchos::ParameterList scene = bar<2>(0.5, "GIMP", 6.0, 6.0);
    scene.sublist("Materials").sublist("Solid").set("Conductivity Ratios", numbers({0.5, 2.0}));
    scene.sublist("Bodies").sublist("Bar").set("Rotation", rotation);
    scene.sublist("Bodies").sublist("Bar").set("Temperature Field",
                                               std::string("300 + 10 * cos(pi * x / 6)"));
    Rhegma::Run<2> run(validated(scene));
    run.initialize();
    while (run.state().clock.time < 2.0)
      run.step(2.0, false);
    double most = 0.0;
    forEach<2>(run.state(), [&](const Vector<2>& x, double T)
               { most = std::max(most, (T - 300.0) / std::cos(3.14159265358979323846 / 6.0 * x[0])); });
    return most;
  };
  const double k = 3.14159265358979323846 / 6.0;
  EXPECT_NEAR(amplitude(0.0), 10.0 * std::exp(-0.5 * k * k * 2.0), 0.1);
  EXPECT_NEAR(amplitude(90.0), 10.0 * std::exp(-2.0 * k * k * 2.0), 0.1);
}

/// A crack from side to side keeps the halves apart; without it they would have met at 350 K.
TEST(Conduction, ACrackInsulates)
{
  for (const bool cracked : {true, false})
  {
    Teuchos::ParameterList scene = bar<2>(0.5);
    scene.sublist("Bodies").sublist("Bar").set("Temperature Field", std::string("x < 3.1 ? 400 : 300"));
    if (cracked)
      scene.sublist("Cracks").sublist("Cut").set("Points", numbers({3.1, -1.0, 3.1, 3.0}));
    Rhegma::Run<2> run(validated(scene));
    run.initialize();
    steps(run, 1500);
    forEach<2>(run.state(),
               [&](const Vector<2>& x, double T)
               {
                 if (cracked)
                   EXPECT_NEAR(T, x[0] < 3.1 ? 400.0 : 300.0, 1e-9);
                 else
                   EXPECT_NEAR(T, 300.0 + 100.0 * 3.25 / 6.0, 5.0);
               });
  }
}

/// A body that conducts well cools as a whole: exp(-h A t / (rho c V)), and the energy balance has what left
/// it.
TEST(Conduction, ConvectionCools)
{
  Teuchos::ParameterList scene = bar<2>(0.5, "GIMP", 2.0, 2.0);
  Teuchos::ParameterList& face = scene.sublist("Boundaries").sublist("Air");
  face.set("Type", "Convection");
  face.set("Body", "Bar");
  face.set("From", numbers({0.0, 0.0}));
  face.set("To", numbers({2.0, 0.0}));
  face.set("Coefficient", 0.002);
  face.set("Ambient Temperature", 200.0);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  const double time = 1000.0;
  while (run.state().clock.time < time)
    run.step(time, false);
  // Biot number h L / k = 0.002: so uneven is the temperature.
  const double rise = 100.0 * std::exp(-0.002 * time / (2.0 * 2.0));
  forEach<2>(run.state(), [&](const Vector<2>&, double T) { EXPECT_NEAR(T, 200.0 + rise, 0.004 * 100.0); });
  measureEnergy(run.state());
  EXPECT_NEAR(run.state().energy.heat, heatOf(run.state()).first, 1e-11 * heatOf(run.state()).second);
}

/// A body that has the temperature of its surroundings takes and gives rounding alone, which is no energy
/// that a run has made or lost.
TEST(Conduction, RoundingIsNoEnergyThatIsMade)
{
  Teuchos::ParameterList scene = bar<2>();
  hold<2>(scene, "Surroundings", -1.0, 0.0, start);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  EnergyBalance& energy = run.state().energy;
  measureEnergy(run.state());
  energy.thermalStart += energy.thermal;
  EnergyWatch watch;
  for (int s = 0; s < 200; ++s)
  {
    run.step(1e30, false);
    measureEnergy(run.state());
    watch.sample(energy);
  }
  EXPECT_EQ(watch.warning(false, run.state().clock.step), "") << energy.residual();
  EXPECT_GT(energy.roundOff, std::fabs(energy.residual()));
}

/// With heat alone there is neither velocity nor stress, and no kernel of motion is planned.
TEST(Conduction, AloneHasNoMechanics)
{
  Rhegma::Run<2> run(validated(bar<2>()));
  run.initialize();
  steps(run, 3);
  for (const std::string& name :
       {fields::velocity, fields::stress, fields::history, fields::rate, fields::side})
    EXPECT_FALSE(run.state().particles.has(name)) << name;
  std::vector<std::string> labels;
  for (const auto& stage : run.plan().calls)
    for (const Call<2>& call : stage)
      labels.push_back(call.label);
  EXPECT_EQ(labels, (std::vector<std::string>{"sort particles", "stencils", "conduction", "temperatures"}));
  EXPECT_DOUBLE_EQ(run.state().clock.dt, 0.35);
}

} // namespace Test
} // namespace Rhegma
