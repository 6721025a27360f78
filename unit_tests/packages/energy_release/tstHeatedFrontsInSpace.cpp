/// J along a straight front in 3D where temperature strains the body and changes its moduli.

#include "energy_release/FrontIntegral.hpp"
#include "src/step/Bodies.hpp"

#include <cmath>

namespace Rhegma
{
namespace Test
{

namespace
{

using namespace energy_release;
using Reals = Teuchos::Array<double>;

constexpr double cell = 0.125, half = 1.0, length = 7.0, depth = 0.25, poisson = 0.25, expansion = 1e-3;

/// A plate of half height 1 m between two planes of symmetry, its edges held, a crack along half of it, E =
/// rho = 1 at 300 K, which comes to rest: plane strain.
Rhegma::Run<3> heldPlate(const std::string& temperature, const std::string& young)
{
  Teuchos::ParameterList scene =
      emptyScene<3>(Vector<3>{-0.5, -half - 2.0 * cell, -2.0 * cell},
                    Vector<3>{length + 0.5, half + 2.0 * cell, depth + 2.0 * cell}, cell, "MUSL", "GIMP");
  addMaterial(scene, "Linear Elastic", poisson);
  Teuchos::ParameterList& material = scene.sublist("Materials").sublist("Solid");
  if (!young.empty())
    material.set("Young Modulus", young);
  material.set("Specific Heat", 1e6); // straining does not change the temperature
  material.set("Conductivity", 0.0);
  material.set("Thermal Expansion", expansion);
  addBox<3>(scene, "Plate", Vector<3>{0.0, -half, 0.0}, Vector<3>{length, half, depth});
  scene.sublist("Bodies").sublist("Plate").set("Temperature Field", temperature);
  Teuchos::ParameterList& edges = scene.sublist("Boundaries").sublist("Edges");
  edges.set("Type", "Velocity");
  edges.set("Nodes", "Outside");
  edges.set("Lower Corner", Reals(Teuchos::tuple(-10.0, -half, -10.0)));
  edges.set("Upper Corner", Reals(Teuchos::tuple(10.0, half, 10.0)));
  edges.set("Value", Reals(Teuchos::tuple(0.0, 0.0, 0.0)));
  for (const double position : {0.0, depth})
  {
    Teuchos::ParameterList& mirror = scene.sublist("Boundaries").sublist(position > 0.0 ? "Far" : "Near");
    mirror.set("Type", "Symmetry");
    mirror.set("Axis", "z");
    mirror.set("Position", position);
  }
  const double tip = 0.5 * length;
  scene.sublist("Cracks").sublist("Notch").set(
      "Points", Reals(Teuchos::tuple(0.0, 0.0, 0.0, tip, 0.0, 0.0, tip, 0.0, depth, 0.0, 0.0, depth)));
  scene.sublist("Energy Release");
  scene.sublist("Thermal").set("Initial Temperature", 300.0);
  scene.sublist("Damping").set("Mass Rate", 2.0);
  Rhegma::Run<3> run(validated(scene));
  run.initialize();
  while (run.state().time < 25.0)
    run.step(1e30, false);
  return run;
}

/// At the station in the middle of the front.
double J(const State<3>& state, double inner, double outer)
{
  const FrontLine line = lineOf(state.cracks.fronts.at(0));
  NodalAcceleration<3> acceleration;
  const std::vector<double> all =
      integrateAlongFront(state, 0, line, {{inner * cell, outer * cell}, 2.0 * cell}, acceleration);
  return all.at(all.size() / 2);
}

} // namespace

/// Cooled evenly, the plate holds 3 E e^2 / (2 (1 - 2 nu)) ahead of the crack, where it can shrink nowhere,
/// and E e^2 / (1 - nu) behind it; e is Green's strain of 1 / theta, theta = 1 + alpha dT.
TEST(HeatedFrontsInSpace, CooledPlateHasTheEnergyThatItLosesAlongTheCrack)
{
  const Rhegma::Run<3> run = heldPlate("290", "");
  const double stretch = 1.0 / (1.0 - expansion * 10.0), strain = 0.5 * (stretch * stretch - 1.0);
  const double expected =
      2.0 * half * strain * strain * (1.5 / (1.0 - 2.0 * poisson) - 1.0 / (1.0 - poisson));
  for (const double inner : {2.0, 3.0, 4.0})
  {
    std::printf("cooled plate, tube of %g to %g cells: J off by %+.2f %%\n", inner, inner + 3.0,
                100.0 * (J(run.state(), inner, inner + 3.0) / expected - 1.0));
    // As for a strip that is pulled, 8 cells a half height; the ends, 3.5 heights away, are in it.
    EXPECT_NEAR(J(run.state(), inner, inner + 3.0), expected, 0.02 * expected);
  }
}

/// Temperature and with it the modulus change along the crack: J is that of any tube, and would not be
/// without what a shift does to the energy at fixed strain.
TEST(HeatedFrontsInSpace, AnyTubeGivesTheSameWhereTemperatureChanges)
{
  Rhegma::Run<3> run = heldPlate("290 + 2*(x - 3.5)", "280:1.5, 300:0.5");
  State<3>& state = run.state();
  const double near = J(state, 1.5, 3.5), middle = J(state, 3.0, 5.0), far = J(state, 5.0, 7.0);
  Kokkos::deep_copy(state.particles.real<3>(fields::temperatureGradient), 0.0);
  const double nearWithout = J(state, 1.5, 3.5), farWithout = J(state, 5.0, 7.0);
  std::printf("J of near, middle and far tubes: %g %g %g; without the terms: %g ... %g\n", near, middle, far,
              nearWithout, farWithout);
  EXPECT_NEAR(middle / near, 1.0, 0.015);
  EXPECT_NEAR(far / near, 1.0, 0.015);
  EXPECT_GT(std::fabs(farWithout / nearWithout - 1.0), 0.04);
}

} // namespace Test
} // namespace Rhegma
