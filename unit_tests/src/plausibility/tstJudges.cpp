/// Scenes of wrong physics, and right ones next to them.

#include "Warnings.hpp"

#include <random>

namespace Rhegma
{
namespace Test
{

namespace
{

const std::string still = "nothing loads or moves the bodies", flies = "so it moves by";

void addGravity(Teuchos::ParameterList& scene, double acceleration, const std::string& history = "1")
{
  Teuchos::ParameterList& list = boundary(scene, "Weight", "Gravity");
  list.set("Acceleration", pair(0.0, -acceleration));
  list.set("History", history);
}

/// 0.1 s, in which 3 MPa on one side accelerate the plate by 1.92 m.
Teuchos::RCP<Teuchos::ParameterList> pulledPlate()
{
  const auto scene = freePlate();
  scene->sublist("Time").set("Final Time", 0.1);
  pull(*scene, 3e6);
  return scene;
}

} // namespace

TEST(Rest, IsSaidWhereNothingActs)
{
  const auto bare = freePlate();
  EXPECT_TRUE(say(warningsOf(bare), "Boundaries: " + still));
  EXPECT_TRUE(say(warningsOf(freePlate()), "Time > Final Time = 1 ms"));
  const auto held = freePlate();
  hold(*held, "Grip", pair(-0.1, -0.1), pair(0.1, 1.1));
  EXPECT_TRUE(say(warningsOf(held), still));
}

TEST(Rest, IsNotSaidWhereSomethingActs)
{
  const auto pulled = freePlate(), thrown = freePlate(), spun = freePlate(), heavy = freePlate(),
             moved = freePlate();
  pull(*pulled, 1e6);
  thrown->sublist("Bodies").sublist("Plate").set("Velocity", pair(1.0, 0.0));
  spun->sublist("Bodies").sublist("Plate").set("Angular Velocity", Reals(1, 1.0));
  addGravity(*heavy, 9.81);
  hold(*moved, "Grip", pair(-0.1, -0.1), pair(0.1, 1.1), pair(0.0, 1.0));
  for (const auto& scene : {pulled, thrown, spun, heavy, moved})
    EXPECT_FALSE(say(warningsOf(scene), still));
}

TEST(Gravity, InMillimetresIsSaid)
{
  const auto scene = freePlate();
  addGravity(*scene, 9810.0);
  EXPECT_TRUE(
      say(warningsOf(scene), "Boundaries > Weight > Acceleration is 9810 m/s2 up to the end, 1000 times"));
}

TEST(Gravity, OfACentrifugeOrAShockIsRight)
{
  const auto centrifuge = freePlate(), shock = freePlate();
  addGravity(*centrifuge, 1962.0);
  addGravity(*shock, 1e4, "0:1, 5e-4:0");
  EXPECT_FALSE(say(warningsOf(centrifuge), "Weight > Acceleration"));
  EXPECT_FALSE(say(warningsOf(shock), "Weight > Acceleration"));
}

/// The strip strains by a fifth, which its law bears; the block of a linear law next to it is not loaded.
TEST(Strain, IsJudgedByTheLawOfTheBodyThatStrains)
{
  for (const bool rubber : {true, false})
  {
    const auto scene = freePlate();
    scene->sublist("Materials").sublist("Rubber") = scene->sublist("Materials").sublist("Steel");
    Teuchos::ParameterList& law = scene->sublist("Materials").sublist("Rubber");
    law.set<std::string>("Model", rubber ? "Neo-Hookean" : "Linear Elastic").set("Young Modulus", 1e6);
    scene->sublist("Bodies").sublist("Block") = scene->sublist("Bodies").sublist("Plate");
    scene->sublist("Bodies").sublist("Plate").set<std::string>("Material", "Rubber");
    Teuchos::ParameterList& block = scene->sublist("Bodies").sublist("Block");
    block.set("Lower Corner", pair(-0.2, 0.0)).set("Upper Corner", pair(0.0, 1.0));
    block.set<std::string>("Bonded To", "Plate");
    pull(*scene, 2e5);
    EXPECT_EQ(say(warningsOf(scene), "it strains the body by about 20 %"), !rubber);
  }
}

/// A pressure in a crack is a load: 1e12 Pa in steel.
TEST(Strain, OfAPressureInACrackIsSaid)
{
  for (const double pressure : {1e12, 1e6})
  {
    const auto scene = freePlate();
    scene->sublist("Cracks").sublist("Notch").set("Points", Reals(std::vector<double>{0.2, 0.53, 0.8, 0.53}));
    scene->sublist("Face Pressure").sublist("Notch").set<std::string>("Pressure", std::to_string(pressure));
    EXPECT_EQ(
        say(warningsOf(scene), "Face Pressure > Notch > Pressure: it strains the body by about 476.2 %"),
        pressure > 1e9);
  }
}

/// Along its longest axis a plate of 1 m by 0.2 m is stretched: by 6 % where supports move apart by 60 mm.
TEST(Strain, OfSupportsAlongTheLongestAxisIsThatOfStretching)
{
  for (const double length : {0.06, 0.03})
  {
    const auto scene = steelPlate(-0.4, 1.4, 0.1, pair(0.0, 0.0), pair(1.0, 0.2));
    hold(*scene, "Held", pair(-0.05, -0.05), pair(0.05, 0.25));
    hold(*scene, "Moved", pair(0.95, -0.05), pair(1.05, 0.25), pair(length / 1e-3, 0.0));
    EXPECT_EQ(say(warningsOf(scene), "Boundaries > Moved: it strains the body by about 6 %"), length > 0.05);
  }
}

TEST(YieldStress, AboveWhatBondsBearIsSaid)
{
  for (const double yield : {6e13, 3e8})
  {
    const auto scene = freePlate();
    scene->sublist("Materials")
        .sublist("Steel")
        .set<std::string>("Model", "J2 Plastic")
        .set("Yield Stress", yield);
    EXPECT_EQ(
        say(warningsOf(scene), "Materials > Steel > Yield Stress is 6e+13 Pa, 285.7 of Young's modulus"),
        yield > 1e10);
  }
}

/// Without cracks nothing compares stresses with the yield stress of a linear law.
TEST(YieldStress, OfALawThatDoesNotYieldIsSaid)
{
  for (const std::string model : {"Linear Elastic", "J2 Plastic"})
  {
    const auto scene = freePlate();
    scene->sublist("Materials").sublist("Steel").set<std::string>("Model", model).set("Yield Stress", 3e8);
    EXPECT_EQ(say(warningsOf(scene), "Materials > Steel > Yield Stress is 3e+08 Pa, but its Model, Linear "
                                     "Elastic, does not yield"),
              model == "Linear Elastic");
  }
}

/// A run that starts in equilibrium under a load that rises from zero starts unloaded.
TEST(Start, InEquilibriumWithoutALoadIsSaid)
{
  for (const std::string history : {"t/1e-3", "1", "0:0, 1e-4:1", "1 + t"})
  {
    const auto scene = freePlate();
    hold(*scene, "Held", pair(-0.05, -0.05), pair(0.05, 1.05));
    pull(*scene, 1e6).set("History", history);
    scene->sublist("Time").set<std::string>("Initial State", "Equilibrium");
    EXPECT_EQ(say(warningsOf(scene), "no load acts at time 0 (Boundaries > Pull starts from zero)"),
              history[0] != '1')
        << history;
  }
}

/// A displacement of 0.03 mm written as a velocity moves the support by 30 nm in 1 ms.
TEST(Supports, ThatHardlyMoveAreSaid)
{
  for (const double speed : {3e-5, 3e-2})
  {
    const auto scene = freePlate();
    hold(*scene, "Held", pair(-0.05, -0.05), pair(0.05, 1.05));
    hold(*scene, "Moved", pair(0.95, -0.05), pair(1.05, 1.05), pair(speed, 0.0));
    EXPECT_EQ(
        say(warningsOf(scene), "Boundaries > Moved: up to Time > Final Time it strains the body by about"),
        speed < 1e-3);
  }
}

TEST(Flight, IsSaidWithItsDistance)
{
  const Warnings said = warningsOf(pulledPlate());
  EXPECT_TRUE(say(said,
                  "Boundaries > Pull: no load balances it, and nothing supports Bodies > Plate along x, y, "
                  "so it moves by 1.923 m"));
  EXPECT_TRUE(say(said, "1.923 times its length of 1 m"));
}

TEST(Flight, IsThatOfABodyThatNothingBalancesOrHolds)
{
  const auto balanced = pulledPlate();
  Teuchos::ParameterList& push = boundary(*balanced, "Push", "Line Load");
  push.set<std::string>("Body", "Plate");
  push.set("From", pair(0.0, 0.0));
  push.set("To", pair(0.0, 1.0));
  push.set("Force", pair(-3e6, 0.0));
  const auto returned = pulledPlate();
  returned->sublist("Boundaries").sublist("Pull").set<std::string>("History", "t < 0.05 ? 1 : -1");
  const auto held = pulledPlate();
  hold(*held, "Grip", pair(-0.1, -0.1), pair(0.05, 1.1)).set<std::string>("Components", "x");
  for (const auto& scene : {balanced, held})
    EXPECT_FALSE(say(warningsOf(scene), flies));
  // It stops again, far away.
  EXPECT_TRUE(say(warningsOf(returned), "so it moves by "));
}

/// A support along y leaves x free.
TEST(Flight, IsThatAlongFreeAxes)
{
  const auto scene = pulledPlate();
  hold(*scene, "Rail", pair(-0.3, -0.1), pair(1.3, 0.05)).set<std::string>("Components", "y");
  EXPECT_TRUE(say(warningsOf(scene), "nothing supports Bodies > Plate along x, so it moves by 1.923 m"));
}

TEST(Flight, OfWhatIsThrownOrHitsSomethingIsMeant)
{
  const auto thrown = pulledPlate(), atWall = pulledPlate(), withRoom = pulledPlate();
  thrown->sublist("Bodies").sublist("Plate").set("Velocity", pair(0.1, 0.0));
  atWall->sublist("Domain").set("Upper Corner", pair(2.0, 1.4));
  hold(*atWall, "Wall", pair(1.7, -0.4), pair(2.0, 1.4));
  withRoom->sublist("Domain").set("Upper Corner", pair(3.4, 1.4));
  for (const auto& scene : {thrown, atWall, withRoom})
    EXPECT_FALSE(say(warningsOf(scene), flies));
}

/// Two bodies that touch are one.
TEST(Flight, IsThatOfAllThatMovesTogether)
{
  const auto scene = pulledPlate();
  scene->sublist("Domain").set("Lower Corner", pair(-1.4, -0.4));
  Teuchos::ParameterList& other = scene->sublist("Bodies").sublist("Other");
  other.setParameters(scene->sublist("Bodies").sublist("Plate"));
  other.set("Lower Corner", pair(-1.0, 0.0));
  other.set("Upper Corner", pair(0.0, 1.0));
  // Twice the mass and the length: 0.96 m of 2 m.
  EXPECT_TRUE(say(warningsOf(scene), "so it moves by 961.5 mm"));
  EXPECT_TRUE(say(warningsOf(scene), "0.4808 times its length of 2 m"));
  scene->sublist("Boundaries").sublist("Pull").set("Stress", pair(8e6, 0.0));
  EXPECT_TRUE(say(warningsOf(scene), "so it moves by 2.564 m"));
}

TEST(Thickness, OfPlaneStressIsLessThanTheBody)
{
  const auto warnings = [](const std::string& plane, double thickness)
  {
    const auto scene = freePlate();
    pull(*scene, 1e6);
    scene->sublist("Domain").set("Plane", plane);
    scene->sublist("Domain").set("Thickness", thickness);
    return warningsOf(scene);
  };
  EXPECT_TRUE(say(warnings("Stress", 30.0),
                  "Domain > Thickness is 30 m, 30 times the largest body's 1 m; plane stress"));
  EXPECT_FALSE(say(warnings("Stress", 0.03), "Domain > Thickness"));
  EXPECT_FALSE(say(warnings("Strain", 30.0), "Domain > Thickness"));
}

/// A support that covers the body is no mirror; planes of symmetry and grips at sides are.
TEST(ThinParts, AreEndlessBetweenMirrorsOnly)
{
  const std::string thin = "Bodies > Plate > Operations > Bore: the hole is 100 mm thin";
  const auto covered = freePlate();
  bore(*covered, pair(0.4, 0.2), pair(0.5, 0.8));
  hold(*covered, "All", pair(-0.4, -0.4), pair(1.4, 1.4), pair(1.0, 0.0));
  EXPECT_TRUE(say(warningsOf(covered), thin));

  const std::string slab = "Bodies > Plate: the body is 100 mm thin";
  const auto plate = [](const std::string& type)
  {
    const auto scene = steelPlate(-0.4, 1.4, 0.1, pair(0.0, 0.0), pair(1.0, 0.1));
    if (type == "Symmetry")
      for (const double y : {0.0, 0.1})
      {
        Teuchos::ParameterList& list = boundary(*scene, y == 0.0 ? "Low" : "High", type);
        list.set<std::string>("Axis", "y");
        list.set("Position", y);
        list.set<std::string>("Side", y == 0.0 ? "Lower" : "Upper");
      }
    else if (type == "Sides")
      for (const double y : {-0.02, 0.08})
        hold(*scene, y < 0.0 ? "Low" : "High", pair(-0.4, y), pair(1.4, y + 0.04))
            .set<std::string>("Components", "y");
    else
      hold(*scene, "All", pair(-0.4, -0.4), pair(1.4, 1.4));
    scene->sublist("Bodies").sublist("Plate").set("Velocity", pair(1.0, 0.0));
    return scene;
  };
  EXPECT_FALSE(say(warningsOf(plate("Symmetry")), slab));
  EXPECT_FALSE(say(warningsOf(plate("Sides")), slab));
  EXPECT_TRUE(say(warningsOf(plate("All")), slab));
}

/// Tractions on one side, from either end, of any size; not of another side, or where one comes later.
TEST(Loads, ThatCancelAreSaid)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> size(1e3, 1e8);
  const std::string words = "Boundaries > Pull: it acts on the same points as Boundaries > Other, and their "
                            "forces add up to nothing at all times";
  for (int k = 0; k < 5; ++k)
    for (const std::string change : {"", "size", "side", "history", "turned"})
    {
      const auto scene = freePlate();
      const double stress = size(random);
      pull(*scene, stress);
      Teuchos::ParameterList& other = boundary(*scene, "Other", "Traction");
      other.setParameters(scene->sublist("Boundaries").sublist("Pull"));
      other.set("Stress", pair(change == "size" ? -0.99 * stress : -stress, 0.0));
      if (change == "side")
        other.set("From", pair(0.0, 0.0)).set("To", pair(0.0, 1.0));
      if (change == "history")
        other.set<std::string>("History", "t");
      if (change == "turned")
        other.set("From", pair(1.0, 1.0)).set("To", pair(1.0, 0.0));
      EXPECT_EQ(say(warningsOf(scene), words), change.empty() || change == "turned") << change;
    }
}

/// What they leave is rounding, and no instability.
TEST(Loads, ThatCancelDoNotStopARun)
{
  const auto scene = freePlate();
  pull(*scene, 1e6);
  boundary(*scene, "Other", "Traction").setParameters(scene->sublist("Boundaries").sublist("Pull"));
  scene->sublist("Boundaries").sublist("Other").set("Stress", pair(-1e6, 0.0));
  Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)), scene);
  simulation.initialize();
  simulation.sampleEvery(1e-5, [](double, const Simulation::Row&) {}); // of energy, too
  EXPECT_NO_THROW(simulation.advance(1e-3));
  EXPECT_LT(simulation.report()["energy"]["kinetic"].get<double>(), 1e-19); // of 1.6e11 J
}

/// Gone at the end, which alone counts in a static analysis.
TEST(Loads, OfNoTimeThatCountsAreSaid)
{
  for (const std::string analysis : {"Static", "Dynamic"})
  {
    const auto scene = freePlate();
    scene->sublist("Time").set("Analysis", analysis);
    hold(*scene, "Grip", pair(-0.1, -0.1), pair(0.1, 1.1));
    hold(*scene, "Shake", pair(0.9, -0.1), pair(1.1, 1.1), pair(0.0, 1e-3))
        .set<std::string>("History", "t < 5e-4 ? 1 : -1");
    Teuchos::ParameterList& top = boundary(*scene, "Top", "Traction");
    top.set<std::string>("Body", "Plate");
    top.set("From", pair(1.0, 1.0)).set("To", pair(0.0, 1.0)).set("Stress", pair(0.0, 1e6));
    top.set<std::string>("History", "0:0, 1e-4:1, 2e-4:0");
    EXPECT_EQ(say(warningsOf(scene), "Boundaries > Top > History: its factor reaches 1, and is 0 at Time"),
              analysis == "Static");
    EXPECT_EQ(say(warningsOf(scene), "Boundaries > Shake > History: the integral of its factor reaches"),
              analysis == "Static");
  }
}

/// A support that holds nothing moves no body to it.
TEST(IdleSupports, AreNotReachedByTheirOwnMotion)
{
  const auto scene = freePlate();
  hold(*scene, "Grip", pair(-0.4, -0.4), pair(-0.3, 1.4), pair(1e6, 0.0));
  EXPECT_TRUE(say(warningsOf(scene), "Boundaries > Grip: it contains no node of any body"));
}

} // namespace Test
} // namespace Rhegma
