#pragma once
/// A cracked plate with held edges in which temperature strains the body and changes its moduli.

#include "src/step/Bodies.hpp"

#include <cmath>
#include <cstdio>
#include <string>

namespace Rhegma
{
namespace Test
{

constexpr double heldCell = 0.125, heldHalf = 1.0, heldPoisson = 0.25, heldExpansion = 1e-3;

/// The scene of a plate from -1 to 1 m along y whose edges there are held, all components of them, E = rho =
/// 1 at 300 K, damped; without its crack. \param length along x \param depth along z, of no meaning in 2D [m]
template <int D>
Teuchos::ParameterList heldPlate(double length, double depth, const std::string& temperature,
                                 const std::string& young)
{
  const auto corner = [&](double x, double y, double z)
  {
    Vector<D> v;
    const double at[] = {x, y, z};
    for (int d = 0; d < D; ++d)
      v[d] = at[d];
    return v;
  };
  const double margin = 2.0 * heldCell;
  Teuchos::ParameterList scene = emptyScene<D>(corner(-0.5, -heldHalf - margin, -margin),
                                               corner(length + 0.5, heldHalf + margin, depth + margin),
                                               heldCell, "MUSL", "GIMP", "Stress");
  addMaterial(scene, "Linear Elastic", heldPoisson);
  Teuchos::ParameterList& material = scene.sublist("Materials").sublist("Solid");
  if (!young.empty())
    material.set("Young Modulus", young);
  material.set("Specific Heat", 1e6); // straining does not change the temperature
  material.set("Conductivity", 0.0);
  material.set("Thermal Expansion", heldExpansion);
  addBox<D>(scene, "Plate", corner(0.0, -heldHalf, 0.0), corner(length, heldHalf, depth))
      .set("Temperature Field", temperature);
  Teuchos::ParameterList& edges = scene.sublist("Boundaries").sublist("Edges");
  edges.set("Type", "Velocity");
  edges.set("Nodes", "Outside");
  edges.set("Lower Corner", array(corner(-10.0, -heldHalf, -10.0)));
  edges.set("Upper Corner", array(corner(10.0, heldHalf, 10.0)));
  edges.set("Value", array(all<D>(0.0)));
  scene.sublist("Thermal").set("Initial Temperature", 300.0);
  scene.sublist("Damping").set("Mass Rate", 2.0);
  return scene;
}

/// Runs until it is at rest.
template <int D>
Rhegma::Run<D> atRest(const Teuchos::ParameterList& scene, double time)
{
  Rhegma::Run<D> run(validated(scene));
  run.initialize();
  while (run.state().clock.time < time)
    run.step(1e30, false);
  return run;
}

/// Green's strain [1] of a plate that is 10 K colder and held: of 1 / theta, theta = 1 + alpha dT.
inline double cooledStrain()
{
  const double stretch = 1.0 / (1.0 - heldExpansion * 10.0);
  return 0.5 * (stretch * stretch - 1.0);
}

/// J is what it should be in three rings. \param release J of an inner and an outer radius [cells]
template <class Release>
void expectRelease(const Release& release, double expected, double tolerance)
{
  for (const double inner : {2.0, 3.0, 4.0})
  {
    const double J = release(inner, inner + 3.0);
    std::printf("cooled, ring of %g to %g cells: J off by %+.2f %%\n", inner, inner + 3.0,
                100.0 * (J / expected - 1.0));
    EXPECT_NEAR(J, expected, tolerance * expected);
  }
}

/// J is the same in any ring, and would not be without what a shift does to the energy at fixed strain.
/// \param without fraction by which it would differ at least
template <int D, class Release>
void expectAnyRingGivesTheSame(State<D>& state, const Release& release, double tolerance, double without)
{
  const double near = release(1.5, 3.5), middle = release(3.0, 5.0), far = release(5.0, 7.0);
  Kokkos::deep_copy(state.particles.template real<D>(fields::temperatureGradient), 0.0);
  const double nearWithout = release(1.5, 3.5), farWithout = release(5.0, 7.0);
  std::printf("J of near, middle and far rings: %g %g %g; without the terms: %g ... %g\n", near, middle, far,
              nearWithout, farWithout);
  EXPECT_NEAR(middle / near, 1.0, tolerance);
  EXPECT_NEAR(far / near, 1.0, tolerance);
  EXPECT_GT(std::fabs(farWithout / nearWithout - 1.0), without);
}

} // namespace Test
} // namespace Rhegma
