/// Heat of burning that goes into the faces, and autoignition of faces or in a box.

#include "../../src/step/Bodies.hpp"

#include "base/ReadList.hpp"
#include "state/EnergySums.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace Rhegma
{
namespace Test
{
namespace
{

constexpr double conductivity = 0.5, start = 300.0, length = 200.0;

/// A column of unit density and specific heat with a crack right across, and so much gas at rest in it that
/// neither its pressure nor, unless it burns, its temperature changes.
template <int D>
Teuchos::ParameterList cutColumn(double at)
{
  Vector<D> upper = all<D>(3.0), domain = all<D>(5.0);
  upper[D - 1] = 40.0;
  domain[D - 1] = 42.0;
  Teuchos::ParameterList scene = emptyScene<D>(all<D>(-2.0), domain, 1.0, "MUSL", "GIMP");
  addMaterial(scene, "Linear Elastic", 0.0);
  for (const std::string& name : sublistNames(scene.sublist("Materials")))
  {
    scene.sublist("Materials").sublist(name).set("Specific Heat", 1.0);
    scene.sublist("Materials").sublist(name).set("Conductivity", conductivity);
  }
  addBox<D>(scene, "Column", all<D>(0.0), upper);
  scene.sublist("Thermal").set("Initial Temperature", start);
  std::vector<double> points;
  if (D == 2)
    points = {-1.0, at, 4.0, at};
  else
    points = {-1.0, -1.0, at, 4.0, -1.0, at, 4.0, 4.0, at, -1.0, 4.0, at};
  scene.sublist("Cracks").sublist("Cut").set("Points", Teuchos::Array<double>(points));
  Teuchos::ParameterList& burning = scene.sublist("Combustion").sublist("Cut");
  burning.set("Burn Law", "Vieille");
  burning.set("Burn Coefficient", 0.0);
  burning.set("Burn Exponent", 0.0);
  burning.set("Gas Constant", 1.0);
  burning.set("Heat Capacity Ratio", 1.25);
  burning.set("Flame Temperature", 2e5);
  burning.set("Initial Temperature", start);
  burning.set("Initial Pressure", 1e-5);
  burning.set("Outside Pressure", 1e-5);
  burning.set("Cavity Volume", 1e12);
  return scene;
}

template <int D>
nlohmann::json summaryOf(const Rhegma::Run<D>& run)
{
  nlohmann::json summary = nlohmann::json::object();
  for (const Effect<D>& effect : run.plan().effects)
    if (effect.report)
      effect.report(run.state(), summary);
  return summary;
}

template <int D>
nlohmann::json gasOf(const Rhegma::Run<D>& run)
{
  return summaryOf(run).at("cracks").at(0).at("gas");
}

/// Temperature of a half space's surface under a constant flux q [K] (Carslaw and Jaeger, Conduction of Heat
/// in Solids, 1959, section 2.9, eq. 7).
double underFlux(double q, double t)
{
  return start + 2.0 * q * std::sqrt(t / (std::acos(-1.0) * conductivity));
}

/// The same under a gas at T (section 2.7, eq. 1).
double underGas(double h, double T, double t)
{
  const double z = h * std::sqrt(t / conductivity);
  return start + (T - start) * (1.0 - std::exp(z * z) * std::erfc(z));
}

template <int D>
void run(Rhegma::Run<D>& it, double until)
{
  it.initialize();
  while (it.state().clock.time < until && it.state().failure.empty())
    it.step(until, false);
  ASSERT_EQ(it.state().failure, "");
}

/// Half of the heat of burning goes into the faces, where the crack lies on faces of cells or in their
/// middle. The nodes' lumped capacity makes a layer of half a cell out of the surface, so that it lags by rho
/// c h / 6k of flux at most.
template <int D>
void checkFraction(double at)
{
  Teuchos::ParameterList scene = cutColumn<D>(at);
  Teuchos::ParameterList& burning = scene.sublist("Combustion").sublist("Cut");
  burning.set("Burn Coefficient", 1e-6);
  burning.set("Wall Heat Fraction", 0.5);
  Rhegma::Run<D> it(validated(scene));
  run(it, length);
  const nlohmann::json gas = gasOf(it);
  const double q = 0.5 * 1e-6 * 4.0 * 2e5; // fraction, rate, c_v, flame temperature
  const double rise = gas.at("hottest_face").get<double>() - start,
               exact = underFlux(q, it.state().clock.time) - start;
  std::printf("%dD, crack at %g: face warmed by %.4f, closed form %.4f (%+.2f %%)\n", D, at, rise, exact,
              100.0 * (rise / exact - 1.0));
  EXPECT_NEAR(rise, exact, 0.03 * exact);
  // What the faces took is half of what was released, and what the bodies have got.
  const double wall = gas.at("wall_heat").get<double>(), released = gas.at("released").get<double>();
  EXPECT_NEAR(wall, 0.5 * released, 1e-10 * released);
  EXPECT_NEAR(gas.at("energy_kept").get<double>(), 1.0, 1e-10);
  EXPECT_NEAR(it.state().energy.heat, wall, 1e-10 * wall);
  measureEnergy(it.state());
  // Of the heat in the bodies, that of what burnt has gone back into the gas.
  EXPECT_NEAR(it.state().energy.thermal, wall, 2e-4 * wall);
}

} // namespace

TEST(FaceHeat, WarmsFacesAsAConstantFluxDoesIn2D)
{
  checkFraction<2>(20.0);
  checkFraction<2>(20.5);
}
TEST(FaceHeat, WarmsFacesAsAConstantFluxDoesIn3D) { checkFraction<3>(20.0); }

/// Gas whose temperature does not change warms the faces by convection, and what it loses they gain.
TEST(FaceHeat, WarmsFacesByConvection)
{
  const double h = 0.1, T = 1000.0;
  Teuchos::ParameterList scene = cutColumn<2>(20.5);
  Teuchos::ParameterList& burning = scene.sublist("Combustion").sublist("Cut");
  burning.set("Initial Temperature", T);
  burning.set("Heat Transfer Coefficient", h);
  Rhegma::Run<2> it(validated(scene));
  run(it, length);
  const nlohmann::json gas = gasOf(it);
  const double rise = gas.at("hottest_face").get<double>() - start,
               exact = underGas(h, T, it.state().clock.time) - start;
  std::printf("face warmed by %.3f, closed form %.3f (%+.2f %%)\n", rise, exact,
              100.0 * (rise / exact - 1.0));
  EXPECT_NEAR(rise, exact, 0.03 * exact);
  const double wall = gas.at("wall_heat").get<double>();
  EXPECT_NEAR(gas.at("energy_kept").get<double>(), 1.0, 1e-10);
  EXPECT_NEAR(it.state().energy.heat, wall, 1e-10 * wall);
}

/// A little gas comes to the temperature that it and the column have together, whatever the coefficient, and
/// passes it at no time.
TEST(FaceHeat, BringsGasAndFacesTogether)
{
  Teuchos::ParameterList scene = cutColumn<2>(20.0);
  Teuchos::ParameterList& burning = scene.sublist("Combustion").sublist("Cut");
  burning.set("Initial Temperature", 1000.0);
  burning.set("Cavity Volume", 1e6);
  burning.set("Heat Transfer Coefficient", 1e6);
  Rhegma::Run<2> it(validated(scene));
  it.initialize();
  double least = 1e300;
  for (int k = 0; k < 50; ++k)
  {
    it.step(1e9, false);
    least = std::min(least, gasOf(it).at("temperature").get<double>());
  }
  const nlohmann::json gas = gasOf(it);
  EXPECT_GT(least, start - 1e-9);
  EXPECT_NEAR(gas.at("temperature").get<double>(), gas.at("hottest_face").get<double>(), 0.5);
  EXPECT_NEAR(it.state().energy.heat, gas.at("wall_heat").get<double>(), 1e-9);
}

/// Faces under hot gas ignite when the closed form reaches the ignition temperature: the rise is 2/7 of the
/// difference, z = h sqrt(t / k) with exp(z^2) erfc(z) = 5/7.
TEST(FaceHeat, LightsFacesThatAreHotEnough)
{
  Teuchos::ParameterList scene = cutColumn<2>(20.5);
  Teuchos::ParameterList& burning = scene.sublist("Combustion").sublist("Cut");
  burning.set("Burn Coefficient", 1e-9);
  burning.set("Initial Temperature", 1000.0);
  burning.set("Heat Transfer Coefficient", 0.02);
  burning.set("Ignition Temperature", 500.0);
  Rhegma::Run<2> it(validated(scene));
  it.initialize();
  while (it.state().clock.time < length && gasOf(it).at("burning_area").get<double>() == 0.0)
    it.step(1e9, false);
  double lower = 0.0, upper = length;
  for (int k = 0; k < 60; ++k)
    (underGas(0.02, 1000.0, 0.5 * (lower + upper)) < 500.0 ? lower : upper) = 0.5 * (lower + upper);
  std::printf("lit at %.2f, closed form %.2f\n", it.state().clock.time, lower);
  // The face is off by less than 3 % of its rise, which goes as the root of time.
  EXPECT_NEAR(it.state().clock.time, lower, 0.06 * lower + 2.0 * it.state().clock.dt);
  EXPECT_NEAR(gasOf(it).at("burning_area").get<double>(), 2.0 * 3.0, 1e-9);
}

/// Only the faces that a source has warmed burn, and they go on when it is cold again.
TEST(FaceHeat, LightsFacesWhereTheyAreHot)
{
  Teuchos::ParameterList scene = cutColumn<2>(20.0);
  Teuchos::ParameterList& source = scene.sublist("Thermal").sublist("Sources").sublist("Spark");
  source.set("Type", "Box");
  source.set("Lower Corner", Teuchos::Array<double>(Teuchos::tuple(0.0, 20.0)));
  source.set("Upper Corner", Teuchos::Array<double>(Teuchos::tuple(1.0, 21.0)));
  source.set("Power Density", 200.0);
  source.set("History", "0:1, 2:1, 2.1:0");
  Teuchos::ParameterList& burning = scene.sublist("Combustion").sublist("Cut");
  burning.set("Burn Coefficient", 1e-9);
  burning.set("Ignition Temperature", 450.0);
  Rhegma::Run<2> it(validated(scene));
  run(it, 3.0);
  const double lit = gasOf(it).at("burning_area").get<double>();
  EXPECT_GE(lit, 2.0 * 0.5 - 1e-9);
  EXPECT_LE(lit, 2.0 * 2.0 + 1e-9);
  while (it.state().clock.time < 100.0)
    it.step(1e9, false);
  EXPECT_LT(gasOf(it).at("hottest_face").get<double>(), 450.0);
  EXPECT_NEAR(gasOf(it).at("burning_area").get<double>(), lit, 1e-3 * lit);
}

/// The faces in a box burn from the time on, and no others.
TEST(FaceHeat, LightsFacesInABox)
{
  Teuchos::ParameterList scene = cutColumn<2>(20.0);
  Teuchos::ParameterList& burning = scene.sublist("Combustion").sublist("Cut");
  burning.set("Burn Coefficient", 1e-9);
  burning.set("Ignition Time", 5.0);
  burning.set("Ignition Lower Corner", Teuchos::Array<double>(Teuchos::tuple(1.0, 19.0)));
  burning.set("Ignition Upper Corner", Teuchos::Array<double>(Teuchos::tuple(2.0, 21.0)));
  Rhegma::Run<2> it(validated(scene));
  run(it, 4.9);
  EXPECT_EQ(gasOf(it).at("burning_area").get<double>(), 0.0);
  while (it.state().clock.time < 10.0)
    it.step(1e9, false);
  EXPECT_NEAR(gasOf(it).at("burning_area").get<double>(), 2.0 * 1.0, 1e-6);
}

} // namespace Test
} // namespace Rhegma
