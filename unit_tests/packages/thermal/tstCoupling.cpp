/// Motion and heat together: the energy balance of both closes, and waves run at the adiabatic speed.

#include "Pi.hpp"
#include "src/step/Bodies.hpp"
#include "state/EnergySums.hpp"
#include "transfer/ParticleViews.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

namespace Rhegma
{
namespace Test
{

namespace
{

using Rhegma::Test::pi;
constexpr double start = 300.0, length = 16.0;

/// A bar of 16 x 2 m, E = rho = 1, in smooth motion v = speed cos(pi x / L); across it is held.
Rhegma::Run<2> movingBar(const std::string& model, double expansion, double capacity, double speed,
                         bool heat = true, const std::function<void(Teuchos::ParameterList&)>& more = {})
{
  Teuchos::ParameterList scene =
      emptyScene<2>(Vector<2>{{-4.0, -4.0}}, Vector<2>{{20.0, 6.0}}, 1.0, "MUSL", "GIMP");
  addMaterial(scene, model, 0.0);
  Teuchos::ParameterList& material = scene.sublist("Materials").sublist("Solid");
  material.set("Specific Heat", capacity);
  if (expansion > 0.0)
    material.set("Thermal Expansion", expansion);
  addBox<2>(scene, "Bar", Vector<2>{{0.0, 0.0}}, Vector<2>{{length, 2.0}});
  for (const double side : {0.0, 2.0})
  {
    Teuchos::ParameterList& wall = scene.sublist("Boundaries").sublist(side > 0.0 ? "Upper" : "Lower");
    wall.set("Type", "Symmetry");
    wall.set("Axis", "y");
    wall.set("Position", side);
  }
  if (heat)
    scene.sublist("Thermal").set("Initial Temperature", start);
  if (more)
    more(scene);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  const HostParticles<2> particles(run.state());
  for (int p = 0; p < particles.size; ++p)
    particles.velocity(p, 0) = speed * std::cos(pi / length * particles.position(p, 0));
  particles.store(run.state());
  return run;
}

/// Half a period of the bar's first mode: the time between two changes of sign of its amplitude.
double halfPeriod(Rhegma::Run<2>& run)
{
  double crossings[2] = {}, before = 0.0, last = 0.0;
  for (int found = 0; found < 2;)
  {
    run.step(1e30, false);
    const HostParticles<2> particles(run.state());
    double amplitude = 0.0;
    for (int p = 0; p < particles.size; ++p)
      amplitude += particles.velocity(p, 0) * std::cos(pi / length * particles.position(p, 0));
    const double time = run.state().clock.time;
    if (last * amplitude < 0.0)
      crossings[found++] = before + (time - before) * last / (last - amplitude);
    before = time;
    last = amplitude;
  }
  return crossings[1] - crossings[0];
}

/// Kinetic, strain and thermal energy less what they were, over the kinetic energy of the start.
template <class AnyRun>
double residualAfter(AnyRun& run, int steps)
{
  measureEnergy(run.state());
  EnergyBalance& energy = run.state().energy;
  energy.start = energy.kinetic + energy.strain;
  energy.thermalStart += energy.thermal;
  const double given = energy.kinetic;
  for (int s = 0; s < steps; ++s)
    run.step(1e30, false);
  measureEnergy(run.state());
  return energy.residual() / given;
}

} // namespace

/// What stresses give to the motion in half a step [J]: by so much the energies of velocities and of strain,
/// half a step apart, differ from those of one time.
double halfStepOfStresses(const State<2>& state)
{
  const auto volume = state.particles.scalar(fields::volume);
  const auto stress = state.particles.real<symmetricSize<2>>(fields::stress);
  const auto projection = state.mesh.nodes.projection;
  double power = 0.0;
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     for (int p = 0; p < state.particles.size(); ++p)
                       connect.visit(p,
                                     [&](int node, double, const double* slope)
                                     {
                                       for (int i = 0; i < 2; ++i)
                                         for (int j = 0; j < 2; ++j)
                                           power += volume(p) * stress(p, symmetricIndex<2>(i, j)) *
                                                    projection(node, i) * slope[j];
                                     });
                   });
  return 0.5 * state.clock.dt * power;
}

/// c^2 of waves without heat flow over that at constant temperature is 1 + T (E alpha)^2 / (rho c E) where
/// the bar is held across and nu = 0: here 1.2.
TEST(Coupling, WavesRunAtTheAdiabaticSpeed)
{
  Rhegma::Run<2> isothermal = movingBar("Linear Elastic", 0.0, 0.15, 1e-4);
  Rhegma::Run<2> adiabatic = movingBar("Linear Elastic", 0.01, 0.15, 1e-4);
  const double slow = halfPeriod(isothermal), fast = halfPeriod(adiabatic);
  // Period 2 L / c; a wave of 32 cells is 0.2 % slow on the cells.
  EXPECT_NEAR(slow, length, 5e-3 * length);
  EXPECT_NEAR(slow * slow / (fast * fast), 1.2, 5e-3);
}

/// What the coupling takes from motion it gives to heat: the energy balance of a vibrating bar closes as well
/// as without heat, in every law.
TEST(Coupling, TheBalanceClosesAsWithoutHeat)
{
  for (const std::string model : {"Linear Elastic", "Neo-Hookean", "J2 Plastic"})
  {
    Rhegma::Run<2> without = movingBar(model, 0.0, 0.15, 1e-3, false),
                   with = movingBar(model, 0.01, 0.15, 1e-3);
    const double mechanical = std::fabs(residualAfter(without, 300)),
                 both = std::fabs(residualAfter(with, 300));
    // Velocities are half a step behind positions: a few percent of what sloshes to and fro.
    EXPECT_LT(mechanical, 2e-2) << model;
    EXPECT_LT(both, std::max(1.5 * mechanical, 1e-3)) << model;
    // The bar's temperature has come and gone: without the coupling it would still be that of the start.
    double most = 0.0;
    const auto T = with.state().particles.scalar(fields::temperature);
    const auto host = onHost(T);
    for (int p = 0; p < with.state().particles.size(); ++p)
      most = std::max(most, std::fabs(host(p) - start));
    EXPECT_GT(most, 1e-3) << model;
  }
}

/// The energy balance of linear waves closes step by step: kinetic energy is that of half a step before
/// strain energy, and with the work of stresses in it the residual is only due to changes of weights and
/// geometry, which are proportional to the strain and the motion of particles in a cell. Waves are the bar's
/// first mode, or those of 7 cells that its end sends out, so that the work of supports is right too.
TEST(Coupling, TheBalanceOfLinearWavesClosesStepByStep)
{
  const auto driven = [](double speed)
  {
    return [=](Teuchos::ParameterList& scene)
    {
      Teuchos::ParameterList& end = scene.sublist("Boundaries").sublist("End");
      end.set("Type", "Velocity");
      end.set("Components", "x");
      end.set("Lower Corner", array(Vector<2>{{-4.0, -4.0}}));
      end.set("Upper Corner", array(Vector<2>{{0.0, 6.0}}));
      end.set("Value", array(Vector<2>{{speed, 0.0}}));
      end.set("History", std::string("sin(2*pi*t/7)"));
    };
  };
  for (const double speed : {1e-5, 1e-4, 1e-3})
    for (const bool support : {false, true})
    {
      Rhegma::Run<2> run = support ? movingBar("Linear Elastic", 0.0, 0.15, 0.0, false, driven(speed))
                                   : movingBar("Linear Elastic", 0.0, 0.15, speed, false);
      State<2>& state = run.state();
      measureEnergy(state);
      state.energy.start = state.energy.kinetic + state.energy.strain;
      double open = 0.0, closed = 0.0, given = state.energy.start;
      for (int s = 0; s < 150; ++s)
      {
        run.step(1e30, false);
        measureEnergy(state);
        const double residual = state.energy.residual();
        given = std::max(given, state.energy.kinetic + state.energy.strain);
        open = std::max(open, std::fabs(residual));
        closed = std::max(closed, std::fabs(residual - halfStepOfStresses(state)));
      }
      std::printf("speed %.0e, %s: residual %.2e of the motion, less half a step of stresses %.2e\n", speed,
                  support ? "driven" : "free", open / given, closed / given);
      // Small strain is the speed over that of waves, 1 m/s; the wall moves by its speed over the frequency.
      EXPECT_LT(closed, (support ? 5.0 : 0.2) * speed * given);
    }
}

/// Samples of USAVG have velocity and strain of one time t. Its mean of two strains is A cos(w dt / 2) cos(w
/// t) where A cos(w t) would keep the energy, so that sin(w dt / 2)^2 of it oscillates; a wave without heat
/// flow is faster by sqrt(1.2) here.
TEST(Coupling, TheBalanceOfMotionStrainedTwiceAStepDoesNotWaverByHalfAStep)
{
  for (const double expansion : {0.0, 0.01})
  {
    Rhegma::Run<2> run =
        movingBar("Linear Elastic", expansion, 0.15, 1e-5, true,
                  [](Teuchos::ParameterList& scene) { scene.sublist("Time").set("Update Scheme", "USAVG"); });
    State<2>& state = run.state();
    measureEnergy(state);
    state.energy.start = state.energy.kinetic + state.energy.strain;
    double open = 0.0;
    for (int s = 0; s < 300; ++s)
    {
      run.step(1e30, false);
      measureEnergy(state);
      open = std::max(open, std::fabs(state.energy.kinetic + state.energy.strain + state.energy.thermal -
                                      state.energy.start));
    }
    const double phase = 0.5 * pi / length * std::sqrt(expansion > 0.0 ? 1.2 : 1.0) * state.clock.dt;
    std::printf("expansion %g: residual %.2e of the motion, sin^2 %.2e\n", expansion,
                open / state.energy.start, std::pow(std::sin(phase), 2));
    EXPECT_LT(open, 1.1 * std::pow(std::sin(phase), 2) * state.energy.start);
  }
}

/// Rubber at strains of some ten percent whose stress does not know the temperature: heat takes nothing of
/// its motion, and all is as without heat to round-off. One whose modulus goes with the temperature warms and
/// cools by a thousandth of it, and so does the energy that it exchanges with motion.
TEST(Coupling, LargeStrainsMakeNoHeatThatNoLawAsksFor)
{
  const auto entropic = [](Teuchos::ParameterList& scene)
  { scene.sublist("Materials").sublist("Solid").set("Entropic", true); };
  Rhegma::Run<2> without = movingBar("Mooney-Rivlin", 0.0, 0.15, 0.3, false),
                 with = movingBar("Mooney-Rivlin", 0.0, 0.15, 0.3),
                 warmed = movingBar("Mooney-Rivlin", 0.0, 15.0, 0.3, true, entropic);
  const double mechanical = residualAfter(without, 200), both = residualAfter(with, 200),
               coupled = residualAfter(warmed, 200);
  const EnergyBalance &own = without.state().energy, &heated = with.state().energy;
  std::printf("residual %.3e without heat, %.3e with, %.3e entropic; heat %.1e J and %.1e J of %.1e J\n",
              mechanical, both, coupled, heated.thermal, warmed.state().energy.thermal, own.start);
  EXPECT_NEAR(heated.kinetic, own.kinetic, 1e-12 * own.start);
  EXPECT_NEAR(heated.strain, own.strain, 1e-12 * own.start);
  EXPECT_NEAR(both, mechanical, 1e-11);
  EXPECT_NEAR(heated.thermal, 0.0, 1e-11 * own.start);
  EXPECT_GT(own.strain, 0.1 * own.start);
  EXPECT_NEAR(coupled, mechanical, 0.1 * std::fabs(mechanical) + 1e-3);
}

/// The same with every mass matrix and with each velocity update that loses motion, whose loss is none of
/// heat's.
TEST(Coupling, TheBalanceClosesWithEveryMassMatrix)
{
  for (const std::string type : {"Lumped", "Full", "FMPM"})
    for (const std::string update : {"FLIP", "PIC"})
    {
      const auto matrix = [&](Teuchos::ParameterList& scene)
      {
        scene.sublist("Mass Matrix").set("Type", type);
        scene.sublist("Mass Matrix").set("Velocity Update", update);
        if (type == "Full")
          scene.sublist("Mass Matrix").set("Solver Tolerance", 1e-12);
      };
      Rhegma::Run<2> without = movingBar("Linear Elastic", 0.0, 0.15, 1e-3, false, matrix),
                     with = movingBar("Linear Elastic", 0.01, 0.15, 1e-3, true, matrix);
      // Waves are faster by a tenth with heat: the same number of periods.
      const double mechanical = std::fabs(residualAfter(without, 300)),
                   both = std::fabs(residualAfter(with, 300));
      std::printf("%s %s: %.2e without heat, %.2e with\n", type.c_str(), update.c_str(), mechanical, both);
      EXPECT_LT(both, std::max(1.5 * mechanical, 1e-3)) << type << " " << update;
      EXPECT_LT(mechanical, update == "FLIP" ? 2e-2 : 1.0) << type << " " << update;
    }
}

/// A modulus that falls with temperature, or rises by a fifth, keeps the energy balance of a bar at its kink
/// as one without a table does; of one that rises threefold there the temperature is not unique for an
/// energy, which is printed.
TEST(Coupling, ModuliThatChangeAtAKink)
{
  Rhegma::Run<2> plain = movingBar("Linear Elastic", 0.0, 1.7e-3, 0.02);
  const double none = std::fabs(residualAfter(plain, 300));
  for (const std::string table : {"250:3, 300:1", "300:1, 350:1.2", "300:1, 350:3"})
  {
    Rhegma::Run<2> run = movingBar("Linear Elastic", 0.0, 1.7e-3, 0.02, true,
                                   [&](Teuchos::ParameterList& scene) {
                                     scene.sublist("Materials").sublist("Solid").set("Young Modulus", table);
                                   });
    const double open = std::fabs(residualAfter(run, 300));
    const auto T = onHost(run.state().particles.scalar(fields::temperature));
    const auto ends = std::minmax_element(T.data(), T.data() + T.extent(0));
    std::printf("modulus %s: open %.1e of the motion (%.1e without a table), from %.2f to %.2f K\n",
                table.c_str(), open, none, *ends.first, *ends.second);
    // Where it rises threefold the residual is the fraction of energy that has two roots, below T dE/dT / E
    // times what is strained.
    EXPECT_LT(open, table == "300:1, 350:3" ? 12.0 : 1.5 * none);
  }
}

/// What viscosity takes from motion is heat of the body.
TEST(Coupling, ViscousWorkIsHeat)
{
  for (const std::string model : {"Linear Elastic", "Neo-Hookean"})
  {
    const auto viscous = [](Teuchos::ParameterList& scene)
    {
      scene.sublist("Damping").set("Shear Viscosity", 0.2);
      scene.sublist("Damping").set("Bulk Viscosity", 0.1);
    };
    Rhegma::Run<2> without = movingBar(model, 0.0, 0.15, 1e-3, false, viscous),
                   with = movingBar(model, 0.0, 0.15, 1e-3, true, viscous);
    const double mechanical = std::fabs(residualAfter(without, 1000)),
                 both = std::fabs(residualAfter(with, 1000));
    const EnergyBalance &damped = without.state().energy, &warmed = with.state().energy;
    std::printf("%s: residual %.2e without heat, %.2e with; %.6e J damped, %.6e J heat\n", model.c_str(),
                mechanical, both, damped.damped, warmed.thermal);
    EXPECT_GT(damped.damped, 1e-6); // of 8e-6 J
    EXPECT_EQ(warmed.damped, 0.0);
    // Without heat the energy balance has the work of the new stress alone, and are off by as much.
    EXPECT_NEAR(warmed.thermal, damped.damped, 4e-3 * damped.damped);
    EXPECT_LT(both, std::max(1.5 * mechanical, 1e-3));
  }
}

/// Without heat in the scene particles have none of its fields.
TEST(Coupling, AbsentHeatLeavesNoField)
{
  Rhegma::Run<2> run = movingBar("Linear Elastic", 0.0, 0.15, 1e-3, false);
  for (const std::string& name : {fields::temperature, fields::temperatureGradient, fields::internalEnergy})
    EXPECT_FALSE(run.state().particles.has(name)) << name;
  EXPECT_TRUE(run.state().materials.thermo.empty());
}

} // namespace Test
} // namespace Rhegma
