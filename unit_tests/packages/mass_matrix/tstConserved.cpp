/// What runs keep with each type of mass matrix.

#include "SquareScene.hpp"
#include "mass_matrix/AngularMomentum.hpp"
#include "transfer/ParticleViews.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace Rhegma
{
namespace Test
{

namespace
{

/// Momentum over the sum of |m v|, largest component.
double relativeMomentum(const State<2>& state, const Vector<2>& start)
{
  const HostParticles<2> particles(state);
  Vector<2> total{{-start[0], -start[1]}};
  double size = 0.0;
  for (int p = 0; p < particles.size; ++p)
  {
    for (int d = 0; d < 2; ++d)
      total[d] += particles.mass(p) * particles.velocity(p, d);
    size += particles.mass(p) * std::hypot(particles.velocity(p, 0), particles.velocity(p, 1));
  }
  return std::max(std::fabs(total[0]), std::fabs(total[1])) / size;
}

Vector<2> momentumOf(const State<2>& state)
{
  const HostParticles<2> particles(state);
  Vector<2> total{{0.0, 0.0}};
  for (int p = 0; p < particles.size; ++p)
    for (int d = 0; d < 2; ++d)
      total[d] += particles.mass(p) * particles.velocity(p, d);
  return total;
}

} // namespace

TEST(MassMatrix, KeepsMomentumWithEveryType)
{
  for (const Case& c : cases)
    for (const auto& [scheme, shape] : {std::pair("MUSL", "GIMP"), std::pair("USF", "GIMP"),
                                        std::pair("MUSL", "Linear"), std::pair("USF", "Linear")})
    {
      // With USF, only the bodies without a crack.
      if (std::string(scheme) == "USF" && std::string(c.type) == "Partial")
        continue;
      Rhegma::Run<2> run(validated(withMass(squareScene(scheme, shape, 17.0), c)));
      run.initialize();
      State<2>& state = run.state();
      shake(state, 1e-3);
      const Vector<2> start = momentumOf(state);
      for (int k = 0; k < 40; ++k)
        run.step(1e30, false);
      EXPECT_LT(relativeMomentum(state, start), 1e-12) << c.name << " " << scheme << " " << shape;
    }
}

/// What a step of MUSL adds to the angular momentum of particles without a crack, from M and the nodes'
/// acceleration a. Forces turn nothing, as stresses are symmetric, so sum_I x_I x (M a)_I = 0; positions
/// change by a velocity w with sum_I w_I x (M w)_I = 0, M being symmetric. What is left is that a particle of
/// which the fraction l is lumped takes the acceleration at its own position, and M has l m N_I at the nodes:
///
///     dL = - dt sum_p l m_p sum_I N_I (x_I - x_p) x a_I
///
/// with l = 1 (Lumped) or the lumped fraction (Full). A consistent mass would keep it.
TEST(MassMatrix, ChangesAngularMomentumByItsLumpedFractionAlone)
{
  for (const char* shape : {"Linear", "GIMP"})
    for (const double lumpedFraction : {1.0, 0.1})
    {
      Teuchos::ParameterList scene = squareScene("MUSL", shape, 17.0);
      Teuchos::ParameterList& list = scene.sublist("Mass Matrix");
      list.set("Type", lumpedFraction < 1.0 ? "Full" : "Lumped");
      if (lumpedFraction < 1.0)
      {
        list.set("Lumped Fraction", lumpedFraction);
        list.set("Minimum Node Mass", 0.0); // all particles alike
        list.set("Solver Tolerance", 1e-12);
        list.set("Maximum Iterations", 2000);
      }
      Rhegma::Run<2> run(validated(scene));
      run.initialize();
      State<2>& state = run.state();
      run.step(1e30, false);
      shake(state, 1e-3);
      struct Fraction
      {
        int node;
        double m; ///< m_p N_I
        Vector<2> arm;
      };
      for (int k = 0; k < 5; ++k)
      {
        std::vector<Fraction> fractions;
        {
          const HostParticles<2> particles(state);
          withConnectivity(state,
                           [&](const auto& connect)
                           {
                             for (int p = 0; p < particles.size; ++p)
                               connect.visit(p,
                                             [&](int node, double weight, const double*)
                                             {
                                               const Vector<2> x = state.mesh.grid.nodePosition(node);
                                               fractions.push_back(
                                                   {node, particles.mass(p) * weight,
                                                    Vector<2>{{x[0] - particles.position(p, 0),
                                                               x[1] - particles.position(p, 1)}}});
                                             });
                           });
        }
        const double before = mass_matrix::angularMomentum(state)[2];
        run.step(1e30, false);
        const double change = mass_matrix::angularMomentum(state)[2] - before;
        const auto motion = onHost(state.mesh.nodes.motion);
        double derived = 0.0, size = 0.0;
        for (const Fraction& s : fractions)
        {
          const double turn = -state.clock.dt * lumpedFraction * s.m *
                              (s.arm[0] * motion(s.node, Nodes<2>::accelerationAt + 1) -
                               s.arm[1] * motion(s.node, Nodes<2>::accelerationAt));
          derived += turn;
          size += std::fabs(turn);
        }
        // The first step after the shake starts without stress.
        if (k > 0)
        {
          EXPECT_GT(size, 0.0) << shape << " " << lumpedFraction;
        }
        // Angular momentum of 100 particles is summed to some 1e-16 of it.
        EXPECT_NEAR(change, derived, 1e-8 * size + 1e-15) << shape << " " << lumpedFraction << " step " << k;
      }
    }
}

/// A wall that moves a body at rest: no force acts on the free nodes, and their momentum comes from that of
/// the wall alone. All of the momentum is the wall's impulse.
TEST(MassMatrix, TakesWhatASupportDoesToABodyAtRest)
{
  Teuchos::ParameterList scene = squareScene("MUSL", "GIMP", 0.0);
  scene.sublist("Mass Matrix").set("Type", "Full");
  Teuchos::ParameterList& wall = scene.sublist("Boundaries").sublist("Wall");
  wall.set("Type", "Velocity");
  wall.set("Lower Corner", array(Vector<2>{{-8.0, -8.0}}));
  wall.set("Upper Corner", array(Vector<2>{{-1.5, 8.0}}));
  wall.set("Components", "x");
  wall.set("Value", array(Vector<2>{{1e-4, 0.0}}));
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  State<2>& state = run.state();
  for (int k = 0; k < 20; ++k)
    run.step(1e30, false);
  const Vector<2> momentum = momentumOf(state);
  EXPECT_GT(momentum[0], 0.0);
  EXPECT_NEAR(momentum[1], 0.0, 1e-12 * momentum[0]);
}

} // namespace Test
} // namespace Rhegma
