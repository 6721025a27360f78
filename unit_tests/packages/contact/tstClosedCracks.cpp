/// Closed cracks in equilibrium: parts that only contact joins, friction, and stress intensities.

#include "Pi.hpp"
#include "Simulation.hpp"
#include "packages/energy_release/InclinedPlate.hpp"
#include "src/step/Bodies.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <random>

namespace Rhegma
{
namespace Test
{

namespace
{

using Rhegma::Test::pi;
constexpr double press = 1e-3; ///< of Young's modulus 1

/// A block of 8 x 8 cells, cut through by a crack at an angle, between tractions at its bottom and top.
Teuchos::ParameterList cutBlock(const std::string& law, double friction, double degrees,
                                const Vector<2>& middle)
{
  Teuchos::ParameterList scene = emptyScene<2>(all<2>(-3.0), all<2>(12.0), 1.0, "MUSL", "GIMP");
  scene.sublist("Time").set("Analysis", "Static");
  scene.sublist("Time").set("Rigid Modes", "Remove");
  scene.sublist("Time").set("Final Time", 1.0);
  addMaterial(scene, "Linear Elastic", 0.3);
  addBox<2>(scene, "Block", all<2>(0.0), all<2>(8.0));
  for (const bool top : {true, false})
  {
    Teuchos::ParameterList& load = scene.sublist("Boundaries").sublist(top ? "Top" : "Bottom");
    const double y = top ? 8.0 : 0.0;
    load.set("Type", "Traction");
    load.set("Body", "Block");
    load.set("From", array(Vector<2>{{top ? 8.0 : 0.0, y}}));
    load.set("To", array(Vector<2>{{top ? 0.0 : 8.0, y}}));
    load.set("Stress", array(Vector<2>{{0.0, top ? -press : press}}));
  }
  const double c = 12.0 * std::cos(degrees * pi / 180.0), s = 12.0 * std::sin(degrees * pi / 180.0);
  scene.sublist("Cracks").sublist("Cut").set(
      "Points", Teuchos::Array<double>({middle[0] - c, middle[1] - s, middle[0] + c, middle[1] + s}));
  scene.sublist("Contact").set("Law", law);
  if (law == "Coulomb")
    scene.sublist("Contact").set("Friction Coefficient", friction);
  return scene;
}

nlohmann::json reportOf(const Rhegma::Run<2>& run)
{
  nlohmann::json summary;
  for (const Effect<2>& effect : run.plan().effects)
    if (effect.report)
      effect.report(run.state(), summary);
  return summary;
}

/// Mean of the pressure and of the shear traction on side +1 of the first crack [Pa].
Vector<2> meanTraction(const State<2>& state)
{
  Vector<2> sum{};
  double size = 0.0;
  const Vector<2> normal = {{state.cracks.normal(0, 0), state.cracks.normal(0, 1)}};
  for (const FaceTraction<2>& point : state.cracks.tractions(0))
  {
    sum[0] += point.size * dot(point.traction, normal);
    sum[1] += point.size * (point.traction[0] * normal[1] - point.traction[1] * normal[0]);
    size += point.size;
  }
  return (1.0 / size) * sum;
}

} // namespace

/// The patch test: a pressed block does not feel a crack that sticks.
TEST(ClosedCracks, PressedBlockHasUniformStress)
{
  std::mt19937 random(23);
  std::uniform_real_distribution<double> anywhere(-0.5, 0.5), angle(-20.0, 20.0);
  std::cout << "seed 23\n";
  for (int k = 0; k < 3; ++k)
  {
    const Vector<2> middle{{4.0 + anywhere(random), 4.0 + anywhere(random)}};
    const double degrees = k == 0 ? 0.0 : angle(random);
    Rhegma::Run<2> run(validated(cutBlock("Coulomb", 0.5, degrees, middle)));
    run.initialize();
    run.step(1.0, false);
    const HostParticles<2> particles(run.state());
    double worst = 0.0;
    for (int p = 0; p < particles.size; ++p)
      for (int c = 0; c < 4; ++c)
        worst = std::max(worst, std::fabs(particles.stress(p, c) + (c == symmetricIndex<2>(1, 1) ? press
                                                                    : c == 3                     ? 0.3 * press
                                                                                                 : 0.0)));
    std::cout << degrees << " degrees: stress off by " << worst / press << "\n";
    EXPECT_LT(worst, 0.03 * press);
    const Vector<2> traction = meanTraction(run.state());
    const double c = std::cos(degrees * pi / 180.0), s = std::sin(degrees * pi / 180.0);
    EXPECT_NEAR(traction[0], press * c * c, 0.03 * press);
    EXPECT_NEAR(std::fabs(traction[1]), press * std::fabs(s) * c, 0.03 * press);
  }
}

/// A crack inside a free body leaves it in one piece: only Time > Rigid Modes says something of its motions.
TEST(ClosedCracks, InsideAFreeBodyNeedNoSupport)
{
  Teuchos::ParameterList scene = cutBlock("Frictionless", 0.0, 45.0, all<2>(4.0));
  scene.sublist("Cracks").sublist("Cut").set("Points", Teuchos::Array<double>({2.6, 2.6, 5.4, 5.4}));
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  while (run.state().clock.time < 1.0 && run.state().failure.empty())
    run.step(1.0, false);
  EXPECT_EQ(run.state().failure, "");
  const Vector<2> traction = meanTraction(run.state());
  EXPECT_NEAR(traction[0], 0.5 * press, 0.1 * press); // that of the block without a crack
  EXPECT_NEAR(traction[1], 0.0, 1e-12 * press);       // no friction
}

/// Above the angle of friction the upper part slides off, which no equilibrium holds.
TEST(ClosedCracks, PartsThatSlideAreNamed)
{
  Rhegma::Run<2> run(validated(cutBlock("Coulomb", 0.3, 25.0, all<2>(4.1))));
  run.initialize();
  try
  {
    run.step(1.0, false);
    FAIL() << "it stays";
  }
  catch (const std::exception& error)
  {
    EXPECT_NE(std::string(error.what()).find("a part of Bodies > Block ("), std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("crack Cut slide"), std::string::npos) << error.what();
  }
}

/// Without friction nothing holds the parts along the crack, although the loads do not move them.
TEST(ClosedCracks, FreePartsAreNamed)
{
  Rhegma::Run<2> run(validated(cutBlock("Frictionless", 0.0, 0.0, all<2>(4.1))));
  run.initialize();
  EXPECT_THROW(run.step(1.0, false), std::exception);
}

/// A cracked plate under pressure and shear that are raised and halved: the crack slides, sticks and slides
/// back. What friction dissipates is the work of the loads less the stored energy.
TEST(ClosedCracks, WorkOfFrictionIsThatOfTheLoads)
{
  Teuchos::ParameterList scene = emptyScene<2>(all<2>(-2.0), all<2>(12.0), 1.0, "MUSL", "GIMP");
  scene.sublist("Time").set("Analysis", "Quasi-Static");
  scene.sublist("Time").set("Final Time", 3.0);
  scene.sublist("Time").set("Load Steps", 12);
  addMaterial(scene, "Linear Elastic", 0.3);
  addBox<2>(scene, "Plate", all<2>(0.0), all<2>(10.0));
  Teuchos::ParameterList& rim = scene.sublist("Boundaries").sublist("Rim");
  rim.set("Type", "Velocity");
  rim.set("Nodes", "Outside");
  rim.set("Lower Corner", array(all<2>(0.01)));
  rim.set("Upper Corner", array(all<2>(9.99)));
  // Pressed in the first third, sheared there and back in the others.
  // There and halfway back.
  rim.set("Field", "3e-5*y, -1e-5*y");
  rim.set("History", "t < 2 ? 0.5 : -0.5");
  scene.sublist("Cracks").sublist("Cut").set("Points", Teuchos::Array<double>({2.1, 5.2, 7.9, 5.2}));
  scene.sublist("Contact").set("Law", "Coulomb");
  scene.sublist("Contact").set("Friction Coefficient", 0.1);
  Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)),
                        Teuchos::rcp(new Teuchos::ParameterList(scene)));
  simulation.initialize();
  simulation.sampleEvery(0.25, {});
  double slid = 0.0, last = 0.0;
  for (int k = 1; k <= 12; ++k)
  {
    simulation.advance(0.25 * k);
    const double lost = simulation.report()["energy"]["friction"];
    EXPECT_GE(lost, (1.0 - 1e-6) * last); // faces that stick may slip by the tolerance of the solution
    last = lost;
    slid = k == 8 ? lost : slid;
  }
  const nlohmann::json energy = simulation.report()["energy"];
  std::cout << energy.dump() << "\n";
  EXPECT_GT(slid, 0.0);
  EXPECT_GT(last, 1.01 * slid) << "it slides back, too";
  EXPECT_NEAR(energy["contact"].get<double>(), last, 1e-3 * last);
  // Loads and forces are linear over each step, but for the second order of strains of 1e-5.
  EXPECT_NEAR(energy["residual"].get<double>(), 0.0, 0.05 * last);
}

/// K_II of a closed crack is that of the shear stress less friction, and K_I is zero.
TEST(ClosedCracks, MeetTheClosedForm)
{
  std::mt19937 random(23);
  std::uniform_real_distribution<double> part(0.0, 1.0), shift(-0.5, 0.5);
  const ElasticSolid solid{1200.0, 3e9, 0.33};
  constexpr double halfLength = 5e-3, load = 1e6, cell = halfLength / 10.0;
  std::cout << "seed 23\n" << std::fixed << std::setprecision(4);
  for (const double friction : {0.0, 0.2, 0.5})
  {
    const double least = std::atan(friction) + 0.2, angle = least + (0.95 - least) * part(random);
    const double c = std::cos(angle), s = std::sin(angle);
    const double normal = load * c * c, shear = load * s * c, drag = friction * normal;
    // The infinite plate slides under the shear that friction does not take; a uniform strain is added.
    InclinedCrack crack{solid, halfLength,   angle,        cell * shift(random), cell * shift(random),
                        0.0,   drag - shear, -load * s * s};
    Teuchos::ParameterList scene = inclinedPlate(crack, 3.0 * halfLength, cell);
    scene.remove("Damping");
    scene.sublist("Time").set("Analysis", "Static");
    scene.sublist("Time").set("Final Time", 2e-5);
    scene.sublist("Boundaries").sublist("Rim").set("History", "1");
    std::ostringstream more;
    const double E = solid.young, nu = solid.poisson;
    more << std::setprecision(15) << "; e = (" << nu * normal / E << ")*p + (" << -drag * (1.0 + nu) / E
         << ")*q; w = (" << -normal / E << ")*q + (" << -drag * (1.0 + nu) / E << ")*p;"
         << "(c*(u+e) - s*(v+w)) / 2e-5, (s*(u+e) + c*(v+w)) / 2e-5";
    Teuchos::ParameterList& rim = scene.sublist("Boundaries").sublist("Rim");
    std::string field = rim.get<std::string>("Field");
    field = field.substr(0, field.rfind(';')) + more.str();
    rim.set("Field", field);
    scene.sublist("Contact").set("Law", friction > 0.0 ? "Coulomb" : "Frictionless");
    if (friction > 0.0)
      scene.sublist("Contact").set("Friction Coefficient", friction);
    Rhegma::Run<2> run(validated(scene));
    run.initialize();
    run.step(2e-5, true);
    const double pressure = meanTraction(run.state())[0] / normal;
    std::cout << "friction " << friction << ", " << angle * 180.0 / pi << " degrees: mean pressure "
              << pressure;
    EXPECT_NEAR(pressure, 1.0, 0.03);
    const nlohmann::json report = reportOf(run);
    for (const auto& front : report["cracks"][0]["fronts"])
    {
      const double one = std::fabs(front["K_I"].get<double>()) / (normal * std::sqrt(pi * halfLength)),
                   two =
                       std::fabs(front["K_II"].get<double>()) / ((shear - drag) * std::sqrt(pi * halfLength));
      std::cout << "; K_I " << one << ", K_II " << two;
      EXPECT_LT(one, 0.01);
      EXPECT_NEAR(two, 1.0, 0.015);
    }
    std::cout << "\n";
  }
}

/// The same law in 3D: a block that is cut through and pressed has a uniform stress where faces stick.
TEST(ClosedCracks, PressedBlockHasUniformStressIn3D)
{
  Teuchos::ParameterList scene = emptyScene<3>(all<3>(-2.0), all<3>(7.0), 1.0, "MUSL", "GIMP");
  scene.sublist("Time").set("Analysis", "Static");
  scene.sublist("Time").set("Final Time", 1.0);
  addMaterial(scene, "Linear Elastic", 0.3);
  addBox<3>(scene, "Block", all<3>(0.0), all<3>(5.0));
  Teuchos::ParameterList& rim = scene.sublist("Boundaries").sublist("Rim");
  rim.set("Type", "Velocity");
  rim.set("Nodes", "Outside");
  rim.set("Lower Corner", array(all<3>(0.01)));
  rim.set("Upper Corner", array(all<3>(4.99)));
  rim.set("Field", "1e-4*z, 2e-5*x, -1e-3*z");
  scene.sublist("Cracks").sublist("Cut").set(
      "Points", Teuchos::Array<double>({1.3, 1.2, 2.4, 3.9, 1.3, 2.6, 3.8, 3.7, 2.9, 1.2, 3.6, 2.7}));
  scene.sublist("Contact").set("Law", "Stick");
  Rhegma::Run<3> run(validated(scene));
  run.initialize();
  run.step(1.0, false);
  const HostParticles<3> particles(run.state());
  double worst = 0.0;
  for (int p = 0; p < particles.size; ++p)
    worst = std::max(worst, std::fabs(particles.deformation(p, 8) - (1.0 - 1e-3)));
  std::cout << "strain off by " << worst / 1e-3 << "\n";
  EXPECT_LT(worst, 0.05e-3);
}

} // namespace Test
} // namespace Rhegma
