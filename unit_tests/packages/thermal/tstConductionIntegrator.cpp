/// Super time stepping and implicit conduction: heat is kept, steady fields are those of explicit steps, the
/// order in time is what it should be, and cracks insulate or conduct as they do in substeps.

#include "packages/thermal/HeatedBars.hpp"
#include "state/EnergySums.hpp"
#include "step/CoreStep.hpp"
#include "thermal/ConductionIntegrator.hpp"

#include <algorithm>
#include <iostream>

namespace Rhegma
{
namespace Test
{

namespace
{

const std::string sts = "Super Time Stepping", implicit = "Implicit";

void conductBy(Teuchos::ParameterList& scene, const std::string& method, double ratio)
{
  scene.sublist("Thermal").set("Conduction", method);
  scene.sublist("Thermal").set("Step Ratio", ratio);
}

void cutBar(Teuchos::ParameterList& scene, double at)
{
  scene.sublist("Cracks").sublist("Cut").set("Points", numbers({at, -1.0, at, 3.0}));
}

template <int D>
void checkThatHeatIsKept(const std::string& method, const std::string& shape)
{
  Teuchos::ParameterList scene = bar<D>(1.0, shape);
  scene.sublist("Materials").sublist("Solid").set("Specific Heat", std::string("250:1.5, 350:2.5"));
  scene.sublist("Materials").sublist("Solid").set("Conductivity", std::string("250:1, 350:2"));
  conductBy(scene, method, 20.0);
  Run<D> run(validated(scene));
  run.initialize();
  randomTemperature(run.state());
  const auto before = heatOf(run.state());
  steps(run, 40);
  EXPECT_EQ(run.state().failure, "");
  EXPECT_NEAR(heatOf(run.state()).first, before.first, 1e-13 * before.second) << method;
  EXPECT_EQ(run.state().energy.heat, 0.0);
}

/// Between two held columns, with a crack of conductance h at x = 3.3 where h > 0.
template <int D>
void checkSteadyField(const std::string& method, int level, double h)
{
  Teuchos::ParameterList scene = bar<D>(1.0);
  hold<D>(scene, "Cold", 1.0, 1.0, 320.0);
  hold<D>(scene, "Hot", 5.0, 5.0, 400.0);
  if (level > 0)
    refineMiddle<D>(scene, level);
  if (h > 0.0)
  {
    cutBar(scene, 3.3);
    Teuchos::ParameterList& faces = scene.sublist("Thermal").sublist("Crack Faces").sublist("Cut");
    faces.set("Conduction", "Always");
    if (h < 1e9)
      faces.set("Conductance", h);
  }
  conductBy(scene, method, 20.0);
  Run<D> run(validated(scene));
  run.initialize();
  steps(run, 150 << (2 * level));
  EXPECT_EQ(run.state().failure, "");
  const double resistance = h > 0.0 && h < 1e9 ? 1.0 / h : 0.0, flux = 80.0 / (2.0 + resistance);
  const double worst = worstBetween<D>(
      run.state(), [&](const Vector<D>& position)
      { return 320.0 + 0.5 * flux * (position[0] - 1.0) + (position[0] < 3.3 ? 0.0 : flux * resistance); });
  EXPECT_LT(worst, 1e-5) << method << " level " << level << " h " << h;
}

/// Temperatures of a bar with two modes after 1 s, in steps of dt.
std::vector<double> temperatures(const std::string& method, double dt)
{
  Teuchos::ParameterList scene = bar<2>(0.0625, "GIMP", 6.0, 0.25);
  scene.sublist("Bodies").sublist("Bar").set("Temperature Field",
                                             std::string("300 + 10 * cos(pi * x / 6) + 5 * cos(pi * x / 2)"));
  scene.sublist("Time").set("Final Time", 1e3);
  const double shortest = 0.35 * 0.0625 * 0.0625;
  conductBy(scene, method, std::max(1.0, dt / shortest));
  Run<2> run(validated(scene));
  run.initialize();
  while (run.state().clock.time < 1.0)
    run.step(1.0, false);
  std::vector<double> all;
  forEach<2>(run.state(), [&](const Vector<2>&, double T) { all.push_back(T); });
  return all;
}

double apart(const std::vector<double>& one, const std::vector<double>& other)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < one.size(); ++k)
    sum += (one[k] - other[k]) * (one[k] - other[k]);
  return std::sqrt(sum / one.size());
}

} // namespace

TEST(ConductionIntegrator, KeepHeat)
{
  for (const std::string& method : {sts, implicit})
  {
    checkThatHeatIsKept<2>(method, "GIMP");
    checkThatHeatIsKept<2>(method, "Linear");
    checkThatHeatIsKept<3>(method, "GIMP");
  }
}

/// No limit of explicit steps is there then; stages divided by what it asked for.
TEST(ConductionIntegrator, WhereNothingConducts)
{
  for (const std::string& method : {sts, implicit})
  {
    Teuchos::ParameterList scene = bar<2>(1.0);
    scene.sublist("Materials").sublist("Solid").set("Conductivity", 0.0);
    conductBy(scene, method, 20.0);
    Rhegma::Run<2> run(validated(scene));
    run.initialize();
    randomTemperature(run.state());
    std::vector<double> before, after;
    forEach<2>(run.state(), [&](const Vector<2>&, double T) { before.push_back(T); });
    steps(run, 5);
    EXPECT_EQ(run.state().failure, "");
    forEach<2>(run.state(), [&](const Vector<2>&, double T) { after.push_back(T); });
    std::sort(before.begin(), before.end()); // particles change positions
    std::sort(after.begin(), after.end());
    EXPECT_LT(apart(after, before), 1e-10) << method;
  }
}

TEST(ConductionIntegrator, EndInTheSteadyField)
{
  for (const std::string& method : {sts, implicit})
  {
    checkSteadyField<2>(method, 0, 0.0);
    checkSteadyField<3>(method, 0, 0.0);
    checkSteadyField<2>(method, 1, 0.0);
  }
  for (const double h : {0.1, 2.0, 1e9})
    checkSteadyField<2>(implicit, 0, h);
  checkSteadyField<2>(implicit, 1, 2.0);
}

/// Against far smaller steps of the same kind: second order, and first.
TEST(ConductionIntegrator, HaveTheirOrderInTime)
{
  const std::vector<double> exact = temperatures(sts, 1.0 / 128);
  const double coarse = apart(temperatures(sts, 1.0 / 4), exact),
               fine = apart(temperatures(sts, 1.0 / 8), exact);
  EXPECT_NEAR(coarse / fine, 4.0, 0.8) << coarse << " " << fine;
  const std::vector<double> settled = temperatures(implicit, 1.0 / 256);
  const double rough = apart(temperatures(implicit, 1.0 / 8), settled),
               smooth = apart(temperatures(implicit, 1.0 / 16), settled);
  EXPECT_NEAR(rough / smooth, 2.0, 0.2) << rough << " " << smooth;
  std::cout << "super time stepping " << coarse << " " << fine << ", implicit " << rough << " " << smooth
            << " K\n";
}

TEST(ConductionIntegrator, ACrackInsulates)
{
  for (const std::string& method : {sts, implicit})
  {
    Teuchos::ParameterList scene = bar<2>(0.5);
    scene.sublist("Bodies").sublist("Bar").set("Temperature Field", std::string("x < 3.1 ? 400 : 300"));
    cutBar(scene, 3.1);
    conductBy(scene, method, 20.0);
    Rhegma::Run<2> run(validated(scene));
    run.initialize();
    steps(run, 75);
    forEach<2>(run.state(), [&](const Vector<2>& x, double T)
               { EXPECT_NEAR(T, x[0] < 3.1 ? 400.0 : 300.0, 1e-8) << method; });
  }
}

/// A body that conducts well cools as a whole; steps are longer than convection alone allows.
TEST(ConductionIntegrator, ConvectionCools)
{
  for (const std::string& method : {sts, implicit})
  {
    Teuchos::ParameterList scene = bar<2>(0.5, "GIMP", 2.0, 2.0);
    Teuchos::ParameterList& face = scene.sublist("Boundaries").sublist("Air");
    face.set("Type", "Convection");
    face.set("Body", "Bar");
    face.set("From", numbers({0.0, 0.0}));
    face.set("To", numbers({2.0, 0.0}));
    face.set("Coefficient", 0.002);
    face.set("Ambient Temperature", 200.0);
    conductBy(scene, method, 40.0);
    Rhegma::Run<2> run(validated(scene));
    run.initialize();
    const double time = 1000.0;
    while (run.state().clock.time < time)
      run.step(time, false);
    const double rise = 100.0 * std::exp(-0.002 * time / (2.0 * 2.0));
    forEach<2>(run.state(),
               [&](const Vector<2>&, double T) { EXPECT_NEAR(T, 200.0 + rise, 0.004 * 100.0) << method; });
    measureEnergy(run.state());
    EXPECT_NEAR(run.state().energy.heat, heatOf(run.state()).first, 1e-11 * heatOf(run.state()).second);
  }
}

/// Stages grow with the root of the step: s^2 + s - 2 is at least four times its ratio to the explicit one.
TEST(ConductionIntegrator, StagesGrowWithTheRootOfTheStep)
{
  for (const double ratio : {1.0, 2.5, 20.0, 100.0, 1000.0})
  {
    const int s = thermal::ConductionIntegrator<2>::stages(ratio, 1.0);
    EXPECT_GE(0.25 * (s * s + s - 2), ratio);
    EXPECT_LE(s, 2.0 * std::sqrt(ratio) + 3.0);
    EXPECT_EQ(s % 2, 1);
  }
}

} // namespace Test
} // namespace Rhegma
