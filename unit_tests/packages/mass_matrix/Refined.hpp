#pragma once
/// Bodies with a mass matrix in cells that are refined in a box.

#include "../../src/step/Vibration.hpp"

#include <random>

namespace Rhegma
{
namespace Test
{

/// Has cells refined in a box.
template <int D>
void refine(Teuchos::ParameterList& scene, const Vector<D>& lower, const Vector<D>& upper, int level)
{
  Teuchos::ParameterList& adaptivity = scene.sublist("Adaptivity");
  adaptivity.set("Maximum Level", level);
  Teuchos::ParameterList& box = adaptivity.sublist("Box");
  box.set("Lower Corner", array(lower));
  box.set("Upper Corner", array(upper));
  box.set("Level", level);
}

/// A square of 5 cells that lies askew to the lattice, with a corner in cells of two levels.
inline Teuchos::ParameterList askewSquare(const std::string& shape, double rotation = 17.0,
                                          const Vector<2>& offset = Vector<2>{{0.13, 0.31}})
{
  Teuchos::ParameterList scene =
      emptyScene<2>(Vector<2>{{-8.0, -8.0}}, Vector<2>{{8.0, 8.0}}, 1.0, "MUSL", shape);
  addMaterial(scene, "Linear Elastic", 0.3);
  addBox<2>(scene, "Square", Vector<2>{{offset[0] - 2.5, offset[1] - 2.5}},
            Vector<2>{{offset[0] + 2.5, offset[1] + 2.5}})
      .set("Rotation", rotation);
  scene.sublist("Time").set("CFL", 0.3);
  refine(scene, Vector<2>{{0.5, 0.5}}, Vector<2>{{2.5, 2.5}}, 2);
  return scene;
}

/// Gives every particle a velocity of its own, `speed` at most along each axis. \return the sum of |m v|
inline double shake(State<2>& state, double speed)
{
  const HostParticles<2> particles(state);
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> number(-speed, speed);
  double size = 0.0;
  for (int p = 0; p < particles.size; ++p)
  {
    for (int d = 0; d < 2; ++d)
      particles.velocity(p, d) = number(generator);
    size += particles.mass(p) * std::hypot(particles.velocity(p, 0), particles.velocity(p, 1));
  }
  particles.store(state);
  return size;
}

} // namespace Test
} // namespace Rhegma
