/// Dynamic runs that start in equilibrium.

#include "material/Tensors.hpp"
#include "src/step/Bodies.hpp"

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

/// Largest speed of a particle in the first 40 steps, in that of a load that is applied at once [-].
double motionAfter(const Teuchos::ParameterList& scene)
{
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  double fastest = 0.0;
  for (int k = 0; k < 40; ++k)
  {
    run.step(100.0, false);
    fastest = std::max(fastest, fastestParticle(run.state()));
  }
  return fastest / pull; // sigma / (rho c)
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
    EXPECT_GT(motionAfter(unloaded), 0.5) << cracked;
    // The crack's ghost penalty holds no body in motion; without a crack there is none.
    EXPECT_LT(motionAfter(scene), cracked ? 0.05 : 1e-4) << cracked;
  }
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
