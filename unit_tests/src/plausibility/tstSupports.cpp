/// Planes of symmetry inside bodies, bodies that are held everywhere, and supports and forces of no first
/// step.

#include "Warnings.hpp"

#include <random>

namespace Rhegma
{
namespace Test
{

namespace
{

void mirror(Teuchos::ParameterList& scene, double position, const std::string& side = "")
{
  Teuchos::ParameterList& list = boundary(scene, "Mirror", "Symmetry");
  list.set<std::string>("Axis", "y");
  list.set("Position", position);
  if (!side.empty())
    list.set("Side", side);
}

const std::string inside = "Boundaries > Mirror > ",
                  all = "it prescribes the motion of all of Bodies > Plate along ";

} // namespace

/// The plate is 1 m high, in a domain with as much room on both sides.
TEST(Mirror, InsideABodyIsSaidWithThePartBeyond)
{
  std::mt19937 random(3);
  for (int k = 0; k < 6; ++k)
  {
    const int cells = std::uniform_int_distribution<int>(1, 9)(random);
    const bool lower = random() % 2 == 0;
    const auto scene = freePlate();
    mirror(*scene, 0.1 * cells, lower ? "Lower" : "Upper");
    const Warnings said = warningsOf(scene);
    const int percent = lower ? 10 * cells : 100 - 10 * cells;
    EXPECT_TRUE(say(said, inside + "Position: " + std::to_string(percent) +
                              " % of Bodies > Plate lies on the " + (lower ? "lower" : "upper") +
                              " side of the plane y = "))
        << cells;
  }
  const auto byDefault = freePlate();
  mirror(*byDefault, 0.7);
  EXPECT_TRUE(say(warningsOf(byDefault),
                  "Position: 30 % of Bodies > Plate lies on the upper side of the plane y = "
                  "700 mm, which is that of the mirror image (by default, the nearer end "
                  "of the domain), so that it is held along y"));
}

TEST(Mirror, WithTheBodyOnItsSideIsSaid)
{
  const auto scene = freePlate();
  mirror(*scene, 0.0, "Upper");
  EXPECT_TRUE(say(warningsOf(scene), inside + "Side: all of Bodies > Plate lies on the upper side"));
  EXPECT_TRUE(say(warningsOf(scene), "write Side = Lower"));
}

TEST(Mirror, AtASurfaceIsRight)
{
  for (const double position : {0.0, 1.0})
    for (const bool given : {false, true})
    {
      const auto scene = freePlate();
      mirror(*scene, position, !given ? "" : position == 0.0 ? "Lower" : "Upper");
      EXPECT_FALSE(say(warningsOf(scene), inside)) << position;
    }
}

TEST(Held, EverywhereUnderALoadIsSaid)
{
  const auto scene = freePlate();
  pull(*scene, 1e6);
  hold(*scene, "Grip", pair(-0.4, -0.4), pair(1.4, 1.4));
  EXPECT_TRUE(say(warningsOf(scene), "Boundaries > Grip: " + all +
                                         "x, so that Boundaries > Pull does not strain the body along x"));
  const auto outside = freePlate();
  pull(*outside, 1e6);
  hold(*outside, "Grip", pair(1.2, 1.2), pair(1.3, 1.3)).set<std::string>("Nodes", "Outside");
  EXPECT_TRUE(say(warningsOf(outside), all));
}

/// A load whose ends lie in the box of a support.
TEST(Held, WhereALoadActsIsSaid)
{
  const std::string held = "Boundaries > Pull: it acts where Boundaries > Grip prescribes the motion along x";
  const auto scene = freePlate(), partly = freePlate(), outside = freePlate();
  pull(*scene, 1e6);
  hold(*scene, "Grip", pair(0.85, -0.4), pair(1.4, 1.4));
  EXPECT_TRUE(say(warningsOf(scene), held));
  pull(*partly, 1e6);
  hold(*partly, "Grip", pair(0.85, -0.4), pair(1.4, 0.5));
  EXPECT_FALSE(say(warningsOf(partly), "it acts where"));
  pull(*outside, 1e6);
  hold(*outside, "Grip", pair(-0.4, -0.4), pair(0.85, 1.4)).set<std::string>("Nodes", "Outside");
  EXPECT_TRUE(say(warningsOf(outside), held));
}

/// A traction normal to a plane of symmetry on it does nothing; one along it does, and so does one elsewhere.
TEST(Held, TractionsOnAPlaneOfSymmetryAreSaid)
{
  for (const double position : {1.0, 0.0})
    for (const bool normal : {true, false})
    {
      const auto scene = freePlate();
      pull(*scene, 1e6).set("Stress", normal ? pair(1e6, 0.0) : pair(0.0, 1e6));
      Teuchos::ParameterList& plane = boundary(*scene, "Middle", "Symmetry");
      plane.set<std::string>("Axis", "x");
      plane.set("Position", position);
      EXPECT_EQ(say(warningsOf(scene),
                    "Boundaries > Pull: it acts where Boundaries > Middle prescribes the motion along x"),
                position == 1.0 && normal)
          << position;
    }
}

/// The halves of two supports meet.
TEST(Held, ByTwoSupportsIsSaid)
{
  const auto scene = freePlate();
  pull(*scene, 1e6);
  hold(*scene, "Left", pair(-0.4, -0.4), pair(0.5, 1.4));
  hold(*scene, "Right", pair(0.55, -0.4), pair(1.4, 1.4));
  EXPECT_TRUE(say(warningsOf(scene), all));
  scene->sublist("Boundaries").sublist("Right").set("Lower Corner", pair(0.65, -0.4));
  EXPECT_FALSE(say(warningsOf(scene), all));
}

TEST(Held, InPartOrAlongAnotherAxisIsRight)
{
  const auto part = freePlate(), across = freePlate(), unloaded = freePlate();
  pull(*part, 1e6);
  hold(*part, "Grip", pair(-0.4, -0.4), pair(0.85, 1.4));
  pull(*across, 1e6);
  hold(*across, "Grip", pair(-0.4, -0.4), pair(1.4, 1.4)).set<std::string>("Components", "y");
  hold(*unloaded, "Grip", pair(-0.4, -0.4), pair(1.4, 1.4), pair(1.0, 0.0));
  for (const auto& scene : {part, across, unloaded})
    EXPECT_FALSE(say(warningsOf(scene), all));
}

/// Waves have 5189 m/s.
TEST(FirstSteps, OfASupportThatIsFasterThanWavesAreSaid)
{
  const auto fast = freePlate(), slow = freePlate();
  hold(*fast, "Grip", pair(-0.1, -0.1), pair(0.1, 1.1), pair(0.0, -5e3));
  EXPECT_TRUE(
      say(warningsOf(fast), "Boundaries > Grip: it moves nodes at 5000 m/s, 0.9636 times the 5189 m/s"));
  hold(*slow, "Grip", pair(-0.1, -0.1), pair(0.1, 1.1), pair(0.0, -50.0));
  EXPECT_FALSE(say(warningsOf(slow), "it moves nodes at"));
}

/// 1 m thick cells of 0.1 m: 3e10 N are 3e11 Pa.
TEST(FirstSteps, OfAForceThatCellsCannotBearAreSaid)
{
  for (const double force : {3e10, 1e9})
  {
    const auto scene = freePlate();
    Teuchos::ParameterList& list = boundary(*scene, "Push", "Point Load");
    list.set<std::string>("Body", "Plate");
    list.set("Point", pair(1.0, 0.5));
    list.set("Force", pair(-force, 0.0));
    EXPECT_EQ(
        say(warningsOf(scene), "Boundaries > Push > Force: the cells at the load bear 3e+11 Pa, 1.429 times"),
        force > 1e10);
  }
}

} // namespace Test
} // namespace Rhegma
