/// Cracks next to surfaces and to themselves.

#include "CubeScene.hpp"

#include <algorithm>

using namespace Rhegma;
using namespace Rhegma::cracks::test;

namespace
{

const std::string nearSurface = "Cracks > Cut: a surface of the body is",
                  nearItself = "Cracks > Cut: it comes back";

template <int D>
bool says(const Teuchos::ParameterList& scene, const std::string& text)
{
  const auto run = start<D>(scene);
  const std::vector<std::string>& said = run->state().warnings;
  return std::any_of(said.begin(), said.end(),
                     [&](const std::string& warning) { return warning.find(text) != std::string::npos; });
}

/// Points in cells, in a block of 20 by 20.
Teuchos::ParameterList cracked(std::vector<double> points)
{
  Teuchos::ParameterList scene = blockScene({20.0 * cell, 20.0 * cell});
  for (double& x : points)
    x *= cell;
  setCrack(scene, points);
  return scene;
}

} // namespace

TEST(Ligaments, BelowASurfaceAreSaidWithTheirCells)
{
  for (const double depth : {0.3, 1.1, 1.9})
  {
    const std::string cells = std::to_string(depth).substr(0, 3) + " cells of 1 mm";
    EXPECT_TRUE(says<2>(cracked({3.0, depth, 15.0, depth}), nearSurface)) << depth;
    EXPECT_TRUE(says<2>(cracked({3.0, 20.0 - depth, 15.0, 20.0 - depth}), cells)) << depth;
    EXPECT_TRUE(says<2>(cracked({0.0, depth, 15.0, depth}), nearSurface)) << depth;
  }
  EXPECT_FALSE(says<2>(cracked({3.0, 2.1, 15.0, 2.1}), nearSurface));
}

/// An end straight ahead of a surface; one nearer than a cell counts as broken through.
TEST(Ligaments, AheadOfAFrontAreSaid)
{
  EXPECT_TRUE(says<2>(cracked({0.0, 10.0, 18.5, 10.0}), nearSurface));
  EXPECT_FALSE(says<2>(cracked({0.0, 10.0, 17.5, 10.0}), nearSurface));
}

/// Where a crack meets the surface it is near it.
TEST(Ligaments, OfCracksThatMeetTheSurfaceAreRight)
{
  for (const double degrees : {20.0, 45.0, 90.0, 135.0})
  {
    const double angle = degrees * std::acos(-1.0) / 180.0;
    const auto scene = cracked({10.0, 0.0, 10.0 + 8.0 * std::cos(angle), 8.0 * std::sin(angle)});
    EXPECT_FALSE(says<2>(scene, nearSurface)) << degrees;
  }
  EXPECT_TRUE(says<2>(cracked({2.0, 0.0, 18.0, 1.5}), nearSurface)); // 5 degrees
}

/// A plane of symmetry at the lower side stands for what lies beyond.
TEST(Ligaments, BelowAMirrorAreRight)
{
  Teuchos::ParameterList scene = cracked({3.0, 1.5, 15.0, 1.5});
  EXPECT_TRUE(says<2>(scene, nearSurface));
  Teuchos::ParameterList& mirror = scene.sublist("Boundaries").sublist("Middle");
  mirror.set<std::string>("Type", "Symmetry");
  mirror.set<std::string>("Axis", "y");
  mirror.set("Position", 0.0);
  EXPECT_FALSE(says<2>(scene, nearSurface));
}

TEST(Ligaments, OfACrackThatComesBackAreSaid)
{
  for (const double gap : {0.6, 1.5, 2.8, 3.2})
    EXPECT_EQ(says<2>(cracked({0.0, 8.0, 12.0, 8.0, 12.0, 8.0 + gap, 5.0, 8.0 + gap}), nearItself), gap < 3.0)
        << gap;
  EXPECT_FALSE(says<2>(cracked({0.0, 8.0, 8.0, 8.0, 8.0, 14.0}), nearItself)); // a right angle
  EXPECT_TRUE(says<2>(cracked({0.0, 8.0, 12.0, 8.0, 4.0, 9.5}), nearItself));  // an angle of 11 degrees
}

/// A disk below the upper side of a block, and one across its side.
TEST(Ligaments, OfDisksAreSaid)
{
  for (const double depth : {1.3, 2.5})
  {
    Teuchos::ParameterList scene = blockScene({12.0 * cell, 12.0 * cell, 10.0 * cell});
    Teuchos::ParameterList& crack = scene.sublist("Cracks").sublist("Cut");
    crack.set("Centre", numbers({6.0 * cell, 6.0 * cell, (10.0 - depth) * cell}));
    crack.set("Normal", numbers({0.0, 0.0, 1.0}));
    crack.set("Radius", 3.0 * cell);
    EXPECT_EQ(says<3>(scene, nearSurface), depth < 2.0) << depth;
    crack.set("Centre", numbers({0.0, 6.0 * cell, 5.2 * cell}));
    EXPECT_FALSE(says<3>(scene, nearSurface));
    EXPECT_FALSE(says<3>(scene, nearItself));
  }
}
