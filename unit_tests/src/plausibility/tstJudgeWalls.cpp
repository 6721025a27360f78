/// Walls, gaps and pieces that the shapes of a body leave together.

#include "Warnings.hpp"

#include <cmath>
#include <random>

namespace Rhegma
{
namespace Test
{

namespace
{

const std::string wall = "Bodies > Plate: a wall of it is less than two cells wide",
                  gap = "Bodies > Plate: a gap of it is less than two cells wide",
                  pieces = "pieces that do not touch";

/// A plate with a round hole.
Teuchos::RCP<Teuchos::ParameterList> drilled(double x, double y, double radius)
{
  const auto scene = freePlate(0.05);
  Teuchos::ParameterList& hole =
      scene->sublist("Bodies").sublist("Plate").sublist("Operations").sublist("Bore");
  hole.set<std::string>("Operation", "Cut");
  hole.set<std::string>("Shape", "Ball");
  hole.set("Centre", pair(x, y));
  hole.set("Radius", radius);
  return scene;
}

/// A disk of radius 0.4 with a hole.
Teuchos::RCP<Teuchos::ParameterList> ring(double inner)
{
  const auto scene = drilled(0.5, 0.5, inner);
  Teuchos::ParameterList& body = scene->sublist("Bodies").sublist("Plate");
  body.remove("Lower Corner");
  body.remove("Upper Corner");
  body.set<std::string>("Shape", "Ball");
  body.set("Centre", pair(0.5, 0.5));
  body.set("Radius", 0.4);
  return scene;
}

/// The plate as a polygon that has a tip or a notch of this angle at the middle of its right side.
Teuchos::RCP<Teuchos::ParameterList> pointed(double degrees, bool tip)
{
  const auto scene = freePlate(0.05);
  Teuchos::ParameterList& body = scene->sublist("Bodies").sublist("Plate");
  body.remove("Lower Corner");
  body.remove("Upper Corner");
  body.set<std::string>("Shape", "Polygon");
  const double depth = 0.3, half = depth * std::tan(0.5 * degrees * std::acos(-1.0) / 180.0);
  Reals points(14);
  const double corners[] = {0.0, 0.0, 1.0,        0.0, 1.0, 0.5 - half, tip ? 1.0 + depth : 1.0 - depth,
                            0.5, 1.0, 0.5 + half, 1.0, 1.0, 0.0,        1.0};
  std::copy(std::begin(corners), std::end(corners), points.begin());
  body.set("Points", points);
  return scene;
}

/// A shaft along z of which a box is cut, in cells of 0.75 mm. \param lower, upper corners of the box [m]
Teuchos::RCP<Teuchos::ParameterList> cutShaft(double radius, const std::vector<double>& lower,
                                              const std::vector<double>& upper)
{
  const auto scene = Teuchos::rcp(new Teuchos::ParameterList("Rhegma"));
  const double cell = 0.75e-3, across = cell * std::ceil(radius / cell + 2.0), along = 21.0 * cell;
  const auto triple = [](double x, double y, double z) { return Reals(std::vector<double>{x, y, z}); };
  Teuchos::ParameterList& domain = scene->sublist("Domain");
  domain.set("Dimension", 3).set("Cell Size", cell);
  domain.set("Lower Corner", triple(-across, -across, -along));
  domain.set("Upper Corner", triple(across, across, along));
  scene->sublist("Time").set("Final Time", 1e-4);
  scene->sublist("Materials").sublist("Steel") = freePlate()->sublist("Materials").sublist("Steel");
  Teuchos::ParameterList& shaft = scene->sublist("Bodies").sublist("Plate");
  shaft.set<std::string>("Material", "Steel").set<std::string>("Shape", "Cylinder").set("Radius", radius);
  shaft.set("From", triple(0.0, 0.0, -15e-3)).set("To", triple(0.0, 0.0, 15e-3));
  Teuchos::ParameterList& box = shaft.sublist("Operations").sublist("Box");
  box.set<std::string>("Operation", "Cut").set<std::string>("Shape", "Box");
  box.set("Lower Corner", Reals(lower)).set("Upper Corner", Reals(upper));
  return scene;
}

} // namespace

/// Cells are 0.05 m: two of them are 0.1 m.
TEST(Walls, OfRingsAreSaidWhereTheyAreThin)
{
  const Warnings said = warningsOf(ring(0.33));
  EXPECT_TRUE(say(said, wall));
  EXPECT_TRUE(say(said, "such as 70 mm at "));
  EXPECT_TRUE(say(said, "1.4 cells of 50 mm"));
  EXPECT_FALSE(say(warningsOf(ring(0.29)), wall));
}

TEST(Walls, NextToAHoleAreSaid)
{
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> chance(0.0, 1.0);
  for (int trial = 0; trial < 10; ++trial)
  {
    const double radius = 0.2 + 0.15 * chance(engine), thin = 0.01 + 0.02 * chance(engine);
    // Thinner than two cells over the chord 2 sqrt(2 R d - d^2), d = 0.1 - thin: more than 0.3.
    EXPECT_TRUE(say(warningsOf(drilled(1.0 - radius - thin, 0.5, radius)), wall)) << radius << " " << thin;
    EXPECT_FALSE(say(warningsOf(drilled(1.0 - radius - 0.101, 0.5, radius)), wall)) << radius;
  }
}

/// Over 2 cells / tan(angle): more than 4 below 26.6 degrees, as rays from one side see it.
TEST(Walls, OfTipsAndNotchesAreSaidWhereTheyAreSharp)
{
  EXPECT_TRUE(say(warningsOf(pointed(15.0, true)), wall));
  EXPECT_TRUE(say(warningsOf(pointed(15.0, false)), gap));
  for (const bool tip : {true, false})
  {
    const Warnings said = warningsOf(pointed(45.0, tip));
    EXPECT_FALSE(say(said, wall) || say(said, gap));
  }
}

/// The half of a ring at a plane of symmetry has its whole thickness there, and no wall along it.
TEST(Walls, GoOnBeyondAMirror)
{
  const auto scene = freePlate(0.05);
  bore(*scene, pair(0.06, 0.2), pair(0.9, 0.8)); // leaves 0.06 at the left and 0.1 at the right
  EXPECT_TRUE(say(warningsOf(scene), wall));
  Teuchos::ParameterList& mirror = boundary(*scene, "Middle", "Symmetry");
  mirror.set<std::string>("Axis", "x");
  mirror.set("Position", 0.0);
  EXPECT_FALSE(say(warningsOf(scene), wall));
}

/// Half a shaft is thin next to the edges of its cut all along it, which is no wall. What is left where the
/// cut is near its surface is one.
TEST(Walls, OfShaftsAreNotTheirEdges)
{
  for (const bool thin : {false, true})
    EXPECT_EQ(
        say(warningsOf(cutShaft(6e-3, {-10e-3, -10e-3, -20e-3}, {thin ? 4.8e-3 : 0.0, 10e-3, 20e-3})), wall),
        thin);
}

/// Both edges of a keyway have 74 degrees. What is left below a deep one, of 0.7 to 1.05 mm, is a wall.
TEST(Walls, AreNoEdgesOfKeyways)
{
  for (const bool deep : {false, true})
    EXPECT_EQ(
        say(warningsOf(cutShaft(9e-3, {deep ? -7.95e-3 : 6.5e-3, -2.5e-3, -8e-3}, {12e-3, 2.5e-3, 8e-3})),
            wall),
        deep);
}

TEST(Pieces, OfABodyThatIsCutApartAreSaidWithTheirMass)
{
  const auto scene = freePlate(0.05);
  bore(*scene, pair(-0.1, 0.2), pair(1.1, 0.4));
  const Warnings said = warningsOf(scene);
  EXPECT_TRUE(say(said, "Bodies > Plate > Operations: they leave 2 pieces that do not touch"));
  const double density = scene->sublist("Materials").sublist("Steel").get<double>("Density");
  char text[80];
  std::snprintf(text, sizeof text, "the smallest of %.4g kg of %.4g kg", 0.2 * density, 0.8 * density);
  EXPECT_TRUE(say(said, text)) << text;
  EXPECT_TRUE(say(said, "no support holds one of them"));
}

TEST(Pieces, ThatAreHeldOrConnectedAreRight)
{
  const auto held = freePlate(0.05), connected = freePlate(0.05), near = freePlate(0.05);
  bore(*held, pair(-0.1, 0.2), pair(1.1, 0.4));
  hold(*held, "Grip", pair(-0.2, -0.2), pair(0.02, 1.2));
  bore(*connected, pair(-0.1, 0.2), pair(0.9, 0.4));
  bore(*near, pair(-0.1, 0.21), pair(1.1, 0.28));
  hold(*near, "Grip", pair(-0.2, -0.2), pair(0.02, 1.2));
  EXPECT_FALSE(say(warningsOf(held), pieces));
  EXPECT_FALSE(say(warningsOf(connected), pieces));
  EXPECT_TRUE(say(warningsOf(near), "pieces less than two cells apart move as one"));
}

} // namespace Test
} // namespace Rhegma
