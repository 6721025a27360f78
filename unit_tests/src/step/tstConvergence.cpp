/// Manufactured solutions: a motion is chosen, the body force that it needs is put on the nodes, and the
/// particles' positions are compared with it on finer and finer cells.
///
/// Neo-Hookean, plane strain, density rho and Lame's constants; tau = lambda ln J 1 + mu (b - 1).
///
/// Vortex (Kamojjala, Brannon, Sadeghirad and Guilkey, Eng. Comput. 31 (2015) 269): a ring, R in [3/4, 5/4],
/// turns by alpha(R, t) = g(t) h(R), h = 1 - 32 (R - 1)^2 + 256 (R - 1)^4, which vanishes with its slope at
/// both rims, g = G sin(pi t / T). In the polar directions of the present position F is 1 with s = R alpha'
/// below the diagonal, so tau has the shear mu s and the hoop stress mu s^2, J = 1, and the balance of
/// momentum gives the force per mass
///
///     b_r = -R (d alpha / dt)^2 + (mu / rho) R alpha'^2,   b_theta = R alpha_tt - (mu / rho)(R alpha'' + 3
///     alpha').
///
/// Stretch along the axes (after Wallstedt and Guilkey, J. Comput. Phys. 227 (2008) 9628): a unit square
/// between walls, u_i = A_i sin(pi X_i) sin(pi t). With F = 1 + u' and P = lambda ln J / F + mu (F - 1/F)
/// along an axis,
///
///     b = u_tt - (F' / rho)(lambda (1 - ln J) / F^2 + mu (1 + 1 / F^2)).
///
/// Orders to expect: cells of linear functions give 2 in displacement, steps of leap frog 2 in time with dt ~
/// h. GIMP's boxes tile a body that is stretched along the axes, so that the sum over particles is a midpoint
/// rule of order 2; points cross cells, and the force then jumps by a fraction of the stress that does not
/// fall with h: order below 1. A sheared box is no parallelogram here, so the vortex with a large twist is
/// worse than order 2 with GIMP too.

#include "Bodies.hpp"
#include "Pi.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace Rhegma
{
namespace Test
{

namespace
{

using Rhegma::Test::pi;
constexpr double poisson = 0.3, lambda = poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson)),
                 shear = 0.5 / (1.0 + poisson);

struct Vortex
{
  static constexpr const char* name = "vortex";
  double amplitude; ///< G, largest turn [rad]

  KOKKOS_INLINE_FUNCTION double profile(double R) const
  {
    const double q = (R - 1.0) * (R - 1.0);
    return 1.0 - 32.0 * q + 256.0 * q * q;
  }
  KOKKOS_INLINE_FUNCTION Vector<2> turned(const Vector<2>& X, double angle) const
  {
    return {
        {std::cos(angle) * X[0] - std::sin(angle) * X[1], std::sin(angle) * X[0] + std::cos(angle) * X[1]}};
  }
  Vector<2> positionOf(const Vector<2>& X, double t) const
  {
    return turned(X, amplitude * std::sin(pi * t) * profile(norm(X)));
  }
  Vector<2> startVelocity(const Vector<2>& X) const
  {
    return amplitude * pi * profile(norm(X)) * Vector<2>{{-X[1], X[0]}};
  }
  /// Force per mass at a position now.
  KOKKOS_INLINE_FUNCTION Vector<2> force(const Vector<2>& x, double t) const
  {
    const double R = norm(x), d = R - 1.0;
    const double g = amplitude * std::sin(pi * t), rate = amplitude * pi * std::cos(pi * t);
    const double slope = g * (-64.0 * d + 1024.0 * d * d * d), curve = g * (-64.0 + 3072.0 * d * d);
    const double radial = -R * rate * rate * profile(R) * profile(R) + shear * R * slope * slope;
    const double hoop = -pi * pi * R * g * profile(R) - shear * (R * curve + 3.0 * slope);
    return {{(radial * x[0] - hoop * x[1]) / R, (radial * x[1] + hoop * x[0]) / R}};
  }

  Teuchos::ParameterList scene(double cell, const std::string& shape) const
  {
    Teuchos::ParameterList list = emptyScene<2>(all<2>(-1.5), all<2>(1.5), cell, "MUSL", shape);
    Teuchos::ParameterList& ring = addBall<2>(list, "Ring", all<2>(0.0), 1.25);
    Teuchos::ParameterList& hole = ring.sublist("Operations").sublist("Hole");
    hole.set("Operation", "Cut");
    hole.set("Shape", "Ball");
    hole.set("Centre", array(all<2>(0.0)));
    hole.set("Radius", 0.75);
    return list;
  }
};

struct Stretch
{
  static constexpr const char* name = "stretch";
  double amplitude; ///< A_x = -A_y [m]

  /// Initial value of a coordinate: X + A sin(pi X) sin(pi t) = x, by Newton's method.
  KOKKOS_INLINE_FUNCTION double origin(double x, double a) const
  {
    double X = x;
    for (int k = 0; k < 20; ++k)
      X -= (X + a * std::sin(pi * X) - x) / (1.0 + a * pi * std::cos(pi * X));
    return X;
  }
  Vector<2> positionOf(const Vector<2>& X, double t) const
  {
    const double a = amplitude * std::sin(pi * t);
    return {{X[0] + a * std::sin(pi * X[0]), X[1] - a * std::sin(pi * X[1])}};
  }
  Vector<2> startVelocity(const Vector<2>& X) const
  {
    return amplitude * pi * Vector<2>{{std::sin(pi * X[0]), -std::sin(pi * X[1])}};
  }
  KOKKOS_INLINE_FUNCTION Vector<2> force(const Vector<2>& x, double t) const
  {
    const double a[2] = {amplitude * std::sin(pi * t), -amplitude * std::sin(pi * t)};
    double u[2], F[2];
    for (int i = 0; i < 2; ++i)
    {
      const double X = origin(x[i], a[i]);
      u[i] = a[i] * std::sin(pi * X);
      F[i] = 1.0 + a[i] * pi * std::cos(pi * X);
    }
    const double logJ = std::log(F[0] * F[1]);
    Vector<2> b;
    for (int i = 0; i < 2; ++i)
    {
      const double inverse = 1.0 / (F[i] * F[i]);
      // u'' = -pi^2 u in X as in time.
      b[i] = -pi * pi * u[i] * (1.0 - lambda * (1.0 - logJ) * inverse - shear * (1.0 + inverse));
    }
    return b;
  }

  Teuchos::ParameterList scene(double cell, const std::string& shape) const
  {
    Teuchos::ParameterList list = emptyScene<2>(all<2>(-0.25), all<2>(1.25), cell, "MUSL", shape);
    addBox<2>(list, "Square", all<2>(0.0), all<2>(1.0));
    for (const char axis : {'x', 'y'})
      for (const bool lower : {true, false})
      {
        Teuchos::ParameterList& wall =
            list.sublist("Boundaries").sublist(std::string(lower ? "Lower " : "Upper ") + axis);
        wall.set("Type", "Symmetry");
        wall.set("Axis", std::string(1, axis));
        wall.set("Position", lower ? 0.0 : 1.0);
        wall.set("Side", lower ? "Lower" : "Upper");
      }
    return list;
  }
};

/// The body force of a motion as an effect: nodal mass times force per mass at the node.
template <class Motion>
Effect<2> manufacturedForce(const Motion& motion)
{
  Effect<2> effect;
  effect.name = "Manufactured Force";
  effect.call({Stage::BeforeSolve,
               "manufactured force",
               {quantity::nodalMass},
               {},
               {quantity::nodalForce},
               [motion](State<2>& state)
               {
                 const Nodes<2> nodes = state.mesh.nodes;
                 const Grid<2> grid = state.mesh.grid;
                 const double t = state.clock.time;
                 Kokkos::parallel_for(
                     "manufacturedForce", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
                     KOKKOS_LAMBDA(const int i) {
                       const int n = activeNode(nodes, i);
                       const double mass = nodes.sums(n, Nodes<2>::massAt);
                       if (mass > 0.0)
                       {
                         const Vector<2> b = motion.force(grid.nodePosition(n), t);
                         for (int d = 0; d < 2; ++d)
                           nodes.sums(n, Nodes<2>::forceAt + d) += mass * b[d];
                       }
                     });
               }});
  return effect;
}

/// Root mean square of the particles' distance from where they should be at half the period, over the
/// amplitude.
template <class Motion>
double error(const Motion& motion, int cells, const std::string& shape)
{
  Teuchos::ParameterList scene = motion.scene(1.0 / cells, shape);
  addMaterial(scene, "Neo-Hookean", poisson);
  Rhegma::Run<2> run(validated(scene), {manufacturedForce(motion)});
  run.initialize();
  State<2>& state = run.state();
  {
    const HostParticles<2> particles(state);
    for (int p = 0; p < particles.size; ++p)
    {
      const Vector<2> v = motion.startVelocity(particles.at(p));
      for (int d = 0; d < 2; ++d)
        particles.velocity(p, d) = v[d];
    }
    particles.store(state);
  }
  while (state.clock.time < 0.5)
    run.step(0.5, false);
  const HostParticles<2> particles(state);
  const auto reference = onHost(state.particles.real<2>(fields::reference));
  double sum = 0.0;
  for (int p = 0; p < particles.size; ++p)
  {
    const Vector<2> off =
        particles.at(p) - motion.positionOf({{reference(p, 0), reference(p, 1)}}, state.clock.time);
    sum += dot(off, off);
  }
  return std::sqrt(sum / particles.size) / motion.amplitude;
}

/// Prints the errors of both shape functions. \return the mean order of each from the coarsest cells to the
/// finest
template <class Motion>
std::array<double, 2> orders(const Motion& motion, const std::vector<int>& cells)
{
  std::array<double, 2> order{};
  int column = 0;
  for (const std::string shape : {"Linear", "GIMP"})
  {
    double first = 0.0, before = 0.0;
    std::printf("%s, amplitude %g, %s:", Motion::name, motion.amplitude, shape.c_str());
    for (const int n : cells)
    {
      const double now = error(motion, n, shape);
      if (before > 0.0)
        std::printf("  (order %.2f)", std::log2(before / now));
      else
        first = now;
      std::printf("  1/%d %.3e", n, now);
      before = now;
    }
    order[column] = std::log2(first / before) / std::log2(double(cells.back()) / cells.front());
    std::printf("  mean order %.2f\n", order[column]);
    ++column;
  }
  return order;
}

} // namespace

TEST(Convergence, StretchAlongTheAxes)
{
  for (const double amplitude : {0.02, 0.1})
  {
    const auto [linear, gimp] = orders(Stretch{amplitude}, {8, 16, 32, 64});
    // Order 2, less the scatter from mesh to mesh: which particles are about to cross a cell when the run
    // ends.
    EXPECT_GT(gimp, 1.75);
    // Points that cross cells do not converge at all.
    EXPECT_LT(linear, 0.5);
  }
}

TEST(Convergence, Vortex)
{
  for (const double amplitude : {0.02, 0.1})
  {
    const auto [linear, gimp] = orders(Vortex{amplitude}, {8, 16, 32});
    EXPECT_GT(gimp, 1.75);
    EXPECT_LT(linear, gimp);
  }
}

} // namespace Test
} // namespace Rhegma
