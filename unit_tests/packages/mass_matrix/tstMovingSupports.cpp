/// Supports that move nodes whose mass is coupled: what damping takes there, and how they strain particles.

#include "../../src/step/Bodies.hpp"
#include "state/EnergySums.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double speed = 1e-5; // of the wall; waves are of 1 m/s and cells of 1 m

/// A bar of 12 by 2 cells whose left end a wall moves to and fro.
Teuchos::ParameterList drivenBar(const std::string& scheme, const std::string& mass)
{
  Teuchos::ParameterList scene =
      emptyScene<2>(Vector<2>{{-2.0, -2.0}}, Vector<2>{{14.0, 4.0}}, 1.0, scheme, "GIMP");
  addMaterial(scene, "Linear Elastic", 0.0);
  addBox<2>(scene, "Bar", all<2>(0.0), Vector<2>{{12.0, 2.0}});
  scene.sublist("Time").set("CFL", 0.2);
  Teuchos::ParameterList& wall = scene.sublist("Boundaries").sublist("Wall");
  wall.set("Type", "Velocity");
  wall.set("Lower Corner", array(Vector<2>{{-2.0, -2.0}}));
  wall.set("Upper Corner", array(Vector<2>{{0.0, 4.0}}));
  wall.set("Value", array(Vector<2>{{speed, 0.0}}));
  wall.set("Components", "x");
  wall.set("History", "sin(pi*t/12)");
  scene.sublist("Mass Matrix").set("Type", mass);
  if (mass == "Partial")
  {
    // Along the bar, so that it opens nowhere; all around its front is unlumped, the wall's nodes too.
    scene.sublist("Cracks").sublist("Slit").set(
        "Points", Teuchos::Array<double>(std::vector<double>{6.0, 1.0, 2.0, 1.0}));
    scene.sublist("Mass Matrix").set("Radius", 4.0);
  }
  return scene;
}

struct Balance
{
  double open = 0.0; ///< mean residual of the energy balance over the last period [J]
  double work = 0.0; ///< of the wall [J]
  double step = 0.0; ///< the last [s]
};

Balance balanceOf(const Teuchos::ParameterList& scene)
{
  const double period = 24.0, end = 5.0 * period;
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  State<2>& state = run.state();
  Balance balance;
  while (state.clock.time < end)
  {
    run.step(end, false);
    measureEnergy(state);
    if (state.clock.time > end - period)
      balance.open += state.clock.dt * state.energy.residual() / period;
    balance.step = std::max(balance.step, state.clock.dt);
  }
  balance.work = state.energy.externalWork;
  return balance;
}

/// Deformation gradients, one after the other.
std::vector<double> deformations(const State<2>& state)
{
  const HostParticles<2> particles(state);
  const auto id = onHost(state.particles.integer(fields::id));
  std::vector<double> all(4 * static_cast<std::size_t>(particles.size));
  for (int p = 0; p < particles.size; ++p)
    for (int k = 0; k < 4; ++k)
      all[4 * static_cast<std::size_t>(id(p)) + k] = particles.deformation(p, k);
  return all;
}

} // namespace

/// Nearly all that the wall gives is damped. What damping takes from stresses is right to the first order in
/// rate dt, so that their second order of the wall's work may stay open. (Were it not recorded at held nodes,
/// rate dt / 2 of the work would.)
TEST(MovingSupports, CloseTheBalanceWhereTheirNodesAreDamped)
{
  const double rate = 0.2;
  for (const char* scheme : {"MUSL", "USAVG"})
    for (const char* mass : {"Lumped", "Full", "Partial"})
    {
      Teuchos::ParameterList scene = drivenBar(scheme, mass);
      scene.sublist("Damping").set("Mass Rate", rate);
      const Balance balance = balanceOf(scene);
      std::printf("%s, %s: open %.4f %% of the wall's work\n", scheme, mass,
                  100.0 * balance.open / balance.work);
      EXPECT_GT(balance.work, 0.0);
      EXPECT_LT(std::fabs(balance.open), std::pow(rate * balance.step, 2) * balance.work)
          << scheme << " " << mass;
    }
}

/// Where every node is held it is no matter what mass it has, in either half of a step. Particles' velocities
/// differ, and by them steps, to the order of the velocity over that of waves; so it is small, and what is
/// left is rounding of 1 in both runs, twice a step.
TEST(MovingSupports, StrainAlikeWhateverTheMass)
{
  const int steps = 20;
  for (const char* scheme : {"MUSL", "USAVG", "USF"})
  {
    std::vector<double> strained[2];
    for (const bool full : {false, true})
    {
      Teuchos::ParameterList scene = drivenBar(scheme, full ? "Full" : "Lumped");
      Teuchos::ParameterList& wall = scene.sublist("Boundaries").sublist("Wall");
      wall.set("Upper Corner", array(Vector<2>{{14.0, 4.0}}));
      wall.remove("Value");
      wall.set("Field", "1e-9*x, 0");
      wall.set("History", "t");
      wall.set("Components", "xy");
      Rhegma::Run<2> run(validated(scene));
      run.initialize();
      for (int k = 0; k < steps; ++k)
        run.step(1e30, false);
      strained[full] = deformations(run.state());
    }
    ASSERT_EQ(strained[0].size(), strained[1].size());
    EXPECT_GT(strained[0][0], 1.0 + 5e-9);
    double most = 0.0;
    for (std::size_t k = 0; k < strained[0].size(); ++k)
      most = std::max(most, std::fabs(strained[1][k] - strained[0][k]));
    EXPECT_LT(most, 4 * steps * 1.1e-16) << scheme;
  }
}

} // namespace Test
} // namespace Rhegma
