/// Dynamic runs that start in equilibrium.

#include "Simulation.hpp"
#include "material/Tensors.hpp"
#include "src/step/Bodies.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <random>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double pull = 1e-3; ///< of Young's modulus 1

/// A free block under tension along y.
Teuchos::ParameterList pulledBlock(const std::string& start)
{
  Teuchos::ParameterList scene = emptyScene<2>(all<2>(-3.0), all<2>(12.0), 1.0, "MUSL", "GIMP");
  scene.sublist("Time").set("Initial State", start);
  scene.sublist("Time").set("Rigid Modes", "Remove");
  scene.sublist("Time").set("Final Time", 100.0);
  addMaterial(scene, "Neo-Hookean", 0.3);
  addBox<2>(scene, "Block", all<2>(0.0), all<2>(8.0));
  for (const bool top : {true, false})
  {
    Teuchos::ParameterList& load = scene.sublist("Boundaries").sublist(top ? "Top" : "Bottom");
    const double y = top ? 8.0 : 0.0;
    load.set("Type", "Traction");
    load.set("Body", "Block");
    load.set("From", array(Vector<2>{{top ? 8.0 : 0.0, y}}));
    load.set("To", array(Vector<2>{{top ? 0.0 : 8.0, y}}));
    load.set("Stress", array(Vector<2>{{0.0, top ? pull : -pull}}));
  }
  return scene;
}

void addCrack(Teuchos::ParameterList& scene)
{
  scene.sublist("Cracks").sublist("Cut").set("Points", Teuchos::Array<double>({2.2, 4.3, 5.7, 4.3}));
}

double fastestParticle(const State<2>& state)
{
  const HostParticles<2> particles(state);
  double fastest = 0.0;
  for (int p = 0; p < particles.size; ++p)
    fastest = std::max({fastest, std::fabs(particles.velocity(p, 0)), std::fabs(particles.velocity(p, 1))});
  return fastest;
}

/// Speeds in the first 40 steps, in that of a load that is applied at once, sigma / (rho c) [-].
struct Motion
{
  double fastest = 0.0; ///< of a particle
  double mean = 0.0;    ///< largest root of the mean square
};

Motion motionAfter(const Teuchos::ParameterList& scene)
{
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  Motion most;
  for (int k = 0; k < 40; ++k)
  {
    run.step(100.0, false);
    most.fastest = std::max(most.fastest, fastestParticle(run.state()) / pull);
    const HostParticles<2> particles(run.state());
    double squares = 0.0;
    for (int p = 0; p < particles.size; ++p)
      for (int d = 0; d < 2; ++d)
        squares += particles.velocity(p, d) * particles.velocity(p, d);
    most.mean = std::max(most.mean, std::sqrt(squares / particles.size) / pull);
  }
  return most;
}

} // namespace

/// Under the same loads nothing moves, with a crack or without.
TEST(Preload, StaysInEquilibrium)
{
  for (const bool cracked : {false, true})
  {
    Teuchos::ParameterList scene = pulledBlock("Equilibrium"), unloaded = pulledBlock("Unloaded");
    if (cracked)
      for (Teuchos::ParameterList* const s : {&scene, &unloaded})
        addCrack(*s);
    EXPECT_GT(motionAfter(unloaded).fastest, 0.5) << cracked;
    // The crack's ghost penalty holds no body in motion; without a crack there is none.
    EXPECT_LT(motionAfter(scene).fastest, cracked ? 0.05 : 1e-4) << cracked;
  }
}

namespace
{

/// A block that yields as a whole under the preload: the von Mises stress of plane strain is sqrt(1 - nu +
/// nu^2) times the tension at least.
Teuchos::ParameterList yieldingBlock(double hardening)
{
  Teuchos::ParameterList scene = pulledBlock("Equilibrium");
  Teuchos::ParameterList& solid = scene.sublist("Materials").sublist("Solid");
  solid.set("Model", "J2 Plastic");
  solid.set("Yield Stress", 0.7 * pull);
  solid.set("Hardening Modulus", hardening);
  return scene;
}

void addCrackAnywhere(Teuchos::ParameterList& scene, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const double left = 2.0 + part(random), right = 5.0 + part(random), y = 3.0 + 2.0 * part(random);
  scene.sublist("Cracks").sublist("Cut").set("Points", Teuchos::Array<double>({left, y, right, y}));
}

} // namespace

/// A body that has yielded is as much at rest as the solution of its equilibrium: forces of less than 1e-6 of
/// the loads are out of balance. In 40 steps of half a cell they accelerate the end of a bar of 8 cells to
/// no more than 8 times this fraction of the speed of the loads.
TEST(Preload, BodiesThatYieldStayAtRest)
{
  for (const double hardening : {0.02, 0.2})
    EXPECT_LT(motionAfter(yieldingBlock(hardening)).fastest, 8e-6) << hardening;
}

/// With a crack, the ghost penalty holds what the run does not hold, as in an elastic body. Its stiffness is
/// a fraction of Young's modulus E, so a body that yields has up to E over the plastic tangent times as much.
TEST(Preload, CrackedBodiesThatYieldStayAsElasticOnesDo)
{
  for (const unsigned seed : {1U, 2U, 3U})
  {
    Teuchos::ParameterList elastic = yieldingBlock(0.2);
    elastic.sublist("Materials").sublist("Solid").set("Yield Stress", 1e3 * pull);
    addCrackAnywhere(elastic, seed);
    const double motion = motionAfter(elastic).mean;
    for (const double hardening : {0.02, 0.2})
    {
      Teuchos::ParameterList scene = yieldingBlock(hardening);
      addCrackAnywhere(scene, seed);
      EXPECT_LT(motionAfter(scene).mean, (1.0 + hardening) / hardening * motion)
          << "hardening " << hardening << ", seed " << seed;
    }
  }
}

/// The plastic work of the preload is none of the run.
TEST(Preload, TheBalanceClosesAfterPlasticFlow)
{
  const Teuchos::RCP<Teuchos::ParameterList> scene =
      Teuchos::rcp(new Teuchos::ParameterList(validated(yieldingBlock(0.05))));
  scene->sublist("Time").set("Final Time", 10.0);
  Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)), scene);
  simulation.initialize();
  simulation.sampleEvery(1.0, [](double, const Simulation::Row&) {});
  simulation.advance(10.0);
  const nlohmann::json report = simulation.report();
  const double plastic = report["energy"]["plastic"].get<double>();
  EXPECT_GT(plastic, 0.1 * pull * pull);
  EXPECT_LT(std::fabs(report["energy"]["residual"].get<double>()), 1e-6 * plastic);
  EXPECT_EQ(report["warnings"].dump().find("Time > Analysis"), std::string::npos) << report["warnings"];
}

/// A crack that is cut at the start finds the stress of the whole body, and opens.
TEST(Preload, CracksAreCutIntoLoadedBodies)
{
  Teuchos::ParameterList scene = pulledBlock("Equilibrium Without Cracks");
  addCrack(scene);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  const HostParticles<2> particles(run.state());
  for (int p = 0; p < particles.size; ++p)
    ASSERT_NEAR(particles.stress(p, symmetricIndex<2>(1, 1)), pull,
                2e-3 * pull) // Kirchhoff stress at a stretch of 1.001
        << "particle " << p;
  for (int k = 0; k < 5; ++k)
    run.step(100.0, false);
  EXPECT_GT(fastestParticle(run.state()), 0.5 * pull);
}

/// Bodies that can move freely are named, as in a static analysis.
TEST(Preload, FreeMotionsAreNamed)
{
  Teuchos::ParameterList scene = pulledBlock("Equilibrium");
  scene.sublist("Time").set("Rigid Modes", "Refuse");
  Rhegma::Run<2> run(validated(scene));
  try
  {
    run.initialize();
    FAIL() << "the free body is accepted";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("Bodies > Block can move along x"), std::string::npos)
        << error.what();
  }
}

} // namespace Test
} // namespace Rhegma
