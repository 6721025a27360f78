/// J where temperature strains the body and changes its moduli.

#include "energy_release/DomainIntegral.hpp"
#include "src/step/Bodies.hpp"

#include <cmath>

namespace Rhegma
{
namespace Test
{

namespace
{

using energy_release::DomainIntegral;
using energy_release::integrateDomain;
using Reals = Teuchos::Array<double>;

constexpr double cell = 0.125, half = 1.0, length = 6.0, poisson = 0.25, expansion = 1e-3, start = 300.0;

/// A strip of half height 1 m with its edges held, a crack along half of it, E = rho = 1 at 300 K, which
/// comes to rest. Plane stress.
Rhegma::Run<2> heldStrip(const std::string& temperature, const std::string& young)
{
  Teuchos::ParameterList scene =
      emptyScene<2>(Vector<2>{{-0.5, -half - 2.0 * cell}}, Vector<2>{{length + 0.5, half + 2.0 * cell}}, cell,
                    "MUSL", "GIMP");
  scene.sublist("Domain").set<std::string>("Plane", "Stress");
  addMaterial(scene, "Linear Elastic", poisson);
  Teuchos::ParameterList& material = scene.sublist("Materials").sublist("Solid");
  if (!young.empty())
    material.set("Young Modulus", young);
  material.set("Specific Heat", 1e6); // straining does not change the temperature
  material.set("Conductivity", 0.0);
  material.set("Thermal Expansion", expansion);
  addBox<2>(scene, "Strip", Vector<2>{{0.0, -half}}, Vector<2>{{length, half}});
  scene.sublist("Bodies").sublist("Strip").set("Temperature Field", temperature);
  Teuchos::ParameterList& edges = scene.sublist("Boundaries").sublist("Edges");
  edges.set("Type", "Velocity");
  edges.set("Nodes", "Outside");
  edges.set("Lower Corner", Reals(Teuchos::tuple(-10.0, -half)));
  edges.set("Upper Corner", Reals(Teuchos::tuple(10.0, half)));
  edges.set("Value", Reals(Teuchos::tuple(0.0, 0.0)));
  scene.sublist("Cracks").sublist("Notch").set("Points", Reals(Teuchos::tuple(-0.1, 0.0, 0.5 * length, 0.0)));
  scene.sublist("Energy Release").set("Crack Closure", false);
  scene.sublist("Thermal").set("Initial Temperature", start);
  scene.sublist("Damping").set("Mass Rate", 2.0);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  while (run.state().time < 30.0)
    run.step(1e30, false);
  return run;
}

double J(const State<2>& state, double inner, double outer)
{
  return integrateDomain(state, state.cracks.fronts[0], {inner * cell, outer * cell}).J;
}

} // namespace

/// Cooled evenly, the strip holds E e^2 / (1 - nu) ahead of the crack and E e^2 / 2 behind it, for it can't
/// shrink along the edges there either; e is Green's strain of 1 / theta, theta = 1 + alpha dT.
TEST(HeatedCracks, CooledStripHasTheEnergyThatItLosesAlongTheCrack)
{
  const Rhegma::Run<2> run = heldStrip("290", "");
  const double stretch = 1.0 / (1.0 - expansion * 10.0), strain = 0.5 * (stretch * stretch - 1.0);
  const double expected = half * strain * strain * (1.0 + poisson) / (1.0 - poisson);
  for (const double inner : {2.0, 3.0, 4.0})
  {
    std::printf("cooled strip, contour of %g to %g cells: J off by %+.2f %%\n", inner, inner + 3.0,
                100.0 * (J(run.state(), inner, inner + 3.0) / expected - 1.0));
    // As for a strip that is pulled, 8 cells a half height; the ends, 3 heights away, are in it.
    EXPECT_NEAR(J(run.state(), inner, inner + 3.0), expected, 0.01 * expected);
  }
}

/// Temperature and with it the modulus change along the crack: J is that of any contour, and would not be
/// without what a shift does to the energy at fixed strain.
TEST(HeatedCracks, AnyContourGivesTheSameWhereTemperatureChanges)
{
  Rhegma::Run<2> run = heldStrip("290 + 2*(x - 3)", "280:1.5, 300:0.5");
  State<2>& state = run.state();
  const double near = J(state, 1.5, 3.5), middle = J(state, 3.0, 5.0), far = J(state, 5.0, 7.0);
  Kokkos::deep_copy(state.particles.real<2>(fields::temperatureGradient), 0.0);
  const double nearWithout = J(state, 1.5, 3.5), farWithout = J(state, 5.0, 7.0);
  std::printf("J of near, middle and far contours: %g %g %g; without the terms: %g ... %g\n", near, middle,
              far, nearWithout, farWithout);
  EXPECT_NEAR(middle / near, 1.0, 0.01);
  EXPECT_NEAR(far / near, 1.0, 0.01);
  EXPECT_GT(std::fabs(farWithout / nearWithout - 1.0), 0.05);
}

} // namespace Test
} // namespace Rhegma
