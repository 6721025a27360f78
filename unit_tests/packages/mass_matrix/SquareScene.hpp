#pragma once
/// A small body askew to the lattice, with each type of mass matrix.

#include "../../src/step/Bodies.hpp"

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace Rhegma
{
namespace Test
{

/// A square of 5 cells that lies askew to the lattice, with random velocities: every mode of the particles
/// moves.
inline Teuchos::ParameterList squareScene(const std::string& scheme, const std::string& shape,
                                          double rotation)
{
  Teuchos::ParameterList scene =
      emptyScene<2>(Vector<2>{{-8.0, -8.0}}, Vector<2>{{8.0, 8.0}}, 1.0, scheme, shape);
  addMaterial(scene, "Linear Elastic", 0.3);
  addBox<2>(scene, "Square", Vector<2>{{-2.37, -2.19}}, Vector<2>{{2.63, 2.81}}).set("Rotation", rotation);
  scene.sublist("Time").set("CFL", 0.3);
  return scene;
}

inline void shake(State<2>& state, double speed)
{
  HostParticles<2> particles(state);
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> number(-speed, speed);
  for (int p = 0; p < particles.size; ++p)
    for (int d = 0; d < 2; ++d)
      particles.velocity(p, d) = number(generator);
  particles.store(state);
}

struct Case
{
  const char* name;
  const char* type;
  const char* update;
  int order;
};

const std::vector<Case> cases = {{"Lumped", "Lumped", "FLIP", 0},     {"Full", "Full", "FLIP", 0},
                                 {"FullPic", "Full", "PIC", 0},       {"Fmpm2", "FMPM", "FLIP", 2},
                                 {"Fmpm4", "FMPM", "FLIP", 4},        {"Xpic2", "Lumped", "XPIC", 2},
                                 {"FmpmUpdate", "Lumped", "FMPM", 2}, {"Partial", "Partial", "FLIP", 0},
                                 {"PartialPic", "Partial", "PIC", 0}};

inline Teuchos::ParameterList withMass(Teuchos::ParameterList scene, const Case& c)
{
  Teuchos::ParameterList& list = scene.sublist("Mass Matrix");
  list.set("Type", c.type);
  list.set("Velocity Update", c.update);
  if (c.order > 0 && std::string(c.type) == "FMPM")
    list.set("Order", c.order);
  if (std::string(c.type) != "Partial")
    return scene;
  // Half of the square is unlumped, around the front of a crack that ends in its middle.
  list.set("Radius", 1.5);
  list.set("Transition Width", 1.0);
  const double angle = 17.0 * M_PI / 180.0;
  scene.sublist("Cracks").sublist("Slit").set(
      "Points", Teuchos::Array<double>(std::vector<double>{0.13 - 2.5 * std::cos(angle),
                                                           0.31 - 2.5 * std::sin(angle), 0.13, 0.31}));
  return scene;
}

} // namespace Test
} // namespace Rhegma
