#include "../cracks/CubeScene.hpp"
#include "Pi.hpp"

#include "energy_release/FrontCurvature.hpp"
#include "energy_release/FrontTube.hpp"

using namespace Rhegma;
using namespace Rhegma::cracks::test;
using namespace Rhegma::energy_release;

namespace
{

using Rhegma::Test::pi;

} // namespace

/// Which of two pieces that meet is nearer to a position inside of their corner may depend on round-off.
TEST(FrontLines, SeePositionsInsideOfACornerFromTheMiddleOfIt)
{
  Teuchos::ParameterList scene = blockScene({16e-3, 16e-3, 10e-3});
  const Vector<3> middle{{8.1e-3, 7.8e-3, 5.2e-3}};
  setCrack(scene, regularPolygon(middle, 5e-3, 32));
  const auto penny = start<3>(scene);
  const FrontLine line = lineOf(penny->state().cracks.fronts.at(0));
  const FrontSight sight(line, 0.0);
  for (int k : {0, 1, 7, 31}) // at the first the line begins
  {
    const Vector<3> in = middle - line.nodes[k].position, x = line.nodes[k].position + 0.5 * in;
    const Vector<3> along = line.nodes[(k + 1) % 32].position - line.nodes[(k + 31) % 32].position;
    for (const double off : {0.0, 1e-14, -1e-14})
    {
      const FrontFoot foot = sight.locate(x + off * along);
      EXPECT_NEAR(sight.apart(foot.line, foot.arc, k), 0.0, 1e-9 * line.length);
      EXPECT_NEAR(dot(foot.direction, in) / norm(in), -1.0, 1e-9);
    }
    // Further aside than round-off the foot is on one of the two.
    EXPECT_GT(sight.apart(0, sight.locate(x + 1e-3 * along).arc, k), 1e-4 * line.length);
  }
}

/// A surface at which a front ends is inclined towards it where the crack has grown there: it does not reduce
/// the tube, like a surface that is perpendicular to the front.
TEST(FrontLines, EndAtSurfacesThatLean)
{
  Teuchos::ParameterList scene = blockScene({16e-3, 16e-3, 10e-3});
  // The front from face to face of the block, turned by 20 degrees.
  const double rise = 8e-3 * std::tan(20.0 * pi / 180.0);
  setCrack(scene, {-1e-3, -1e-3, 5.2e-3, -1e-3, 17e-3, 5.2e-3, 8e-3 + 1.125 * rise, 17e-3, 5.2e-3,
                   8e-3 - 1.125 * rise, -1e-3, 5.2e-3});
  const auto leaning = start<3>(scene);
  const CrackFront<3>& front = leaning->state().cracks.fronts.at(0);
  const FrontLine line = lineOf(front);
  ASSERT_EQ(line.loop, std::vector<double>{0.0});
  EXPECT_GT(clearAround(leaning->state(), front, 4.5e-3), 4.4e-3);
}

/// A front node where the surface cuts an arc points along the surface-breaking end, here half a radian off
/// the arc's radius: with it the arc would seem four times as curved.
TEST(FrontLines, LeaveTheSurfaceOutOfTheirCurvature)
{
  Teuchos::ParameterList scene = blockScene({16e-3, 16e-3, 10e-3});
  const double radius = 7e-3, least = 3.0 * cell;
  setCrack(scene, regularPolygon({8.1e-3, -3.1e-3, 5.2e-3}, radius, 32));
  const auto arc = start<3>(scene);
  const FrontLine line = lineOf(arc->state().cracks.fronts.at(0));
  ASSERT_EQ(line.loop, std::vector<double>{0.0});
  ASSERT_GT(line.nodes.size(), 6u);
  // The front node next to a cut piece points up to half a corner to the side, which adds that much of a
  // chord to what the arc departs from it, c^2 / 2 R.
  const double aside = pi / 32.0, found = radiusOfCurvature(line, cell);
  EXPECT_GT(found, radius / (1.0 + 2.0 * radius * aside / least));
  EXPECT_LT(found, radius * (1.0 + 1e-9));
}

/// Of a circle 1 / R everywhere, around its whole line; of an arc that ends at surfaces too, whose ends point
/// along them: the corners of its polygon are not at its ends.
TEST(FrontLines, HaveTheCurvatureOfTheirCircle)
{
  const double radius = 2.5e-3;
  Teuchos::ParameterList scene = blockScene({16e-3, 16e-3, 10e-3});
  setCrack(scene, regularPolygon({8.1e-3, 8.3e-3, 5.2e-3}, radius, 32));
  const auto circle = start<3>(scene);
  const FrontLine closed = lineOf(circle->state().cracks.fronts.at(0));
  ASSERT_GT(closed.loop.at(0), 0.0);
  const FrontCurvature ofCircle(closed);
  for (int k = 0; k < 50;
       ++k) // a chord of angle t: the directions differ by 2 sin(t / 2) over 2 R sin(t / 2)
    EXPECT_NEAR(ofCircle.at(0, k / 50.0 * closed.loop[0]), 1.0 / radius, 1e-6 / radius);

  const double large = 7e-3;
  setCrack(scene, regularPolygon({8.1e-3, -3.1e-3, 5.2e-3}, large, 32));
  const auto cut = start<3>(scene);
  const FrontLine arc = lineOf(cut->state().cracks.fronts.at(0));
  ASSERT_EQ(arc.loop, std::vector<double>{0.0});
  const FrontCurvature ofArc(arc);
  for (int k = 1; k < 20; ++k)
  {
    // A front node next to a cut piece points up to half a corner to the side.
    const double found = ofArc.at(0, k / 20.0 * arc.length);
    EXPECT_GT(found, 0.5 / large);
    EXPECT_LT(found, 1.5 / large);
  }
  EXPECT_EQ(ofArc.at(0, -1.0), ofArc.at(0, 0.0));
}

/// Half a circle that ends at a surface which leans by 50 degrees, as half a penny crack in an axle: behind
/// the planes through its ends lies much of the front, and each position there has the direction of the front
/// next to it. With that of the end, J of front nodes that are cells away from the surface was divided by
/// next to nothing.
TEST(FrontLines, HaveTheDirectionOfTheirEndsNearThemOnly)
{
  const double radius = 3.5 * cell, lean = 50.0 * pi / 180.0;
  const int pieces = 18;
  for (const double sense : {-1.0, 1.0})
  {
    CrackFront<3> front;
    for (int k = 0; k <= pieces; ++k)
    {
      const double around = pi * k / pieces;
      const double turned = around + (k == 0 ? -sense * lean : k == pieces ? sense * lean : 0.0);
      FrontNode<3> frontNode;
      frontNode.position = radius * Vector<3>{std::cos(around), std::sin(around), 0.0};
      frontNode.direction = {std::cos(turned), std::sin(turned), 0.0};
      frontNode.normal = {0.0, 0.0, 1.0};
      frontNode.facet = k < pieces ? k : -1;
      front.nodes.push_back(frontNode);
    }
    const FrontLine line = lineOf(front);
    ASSERT_GT(line.open.at(0), 0.0);
    const FrontSight sight(line, 8.0 * cell);
    const double corner = std::cos(0.5 * pi / pieces);
    for (int k = 7; k <= pieces - 7; ++k) // further along than a tube of 2.5 cells is wide
      for (const double off : {-1.0, -0.3, 0.3, 1.0, 2.0})
      {
        const Vector<3>& radial = line.nodes[k].direction;
        const Vector<3> x = line.nodes[k].position + off * cell * radial + 0.4 * cell * line.nodes[k].normal;
        EXPECT_GT(dot(sight.locate(x).direction, radial), corner) << sense << " " << k << " " << off;
      }
  }
}

/// The radius of a circle of pieces of 0.5 and 1.5 cells by turns, the shortest and the longest that a front
/// has: each front node points along its radius, so that all of them say the same.
TEST(FrontLines, ArcsOfUnequalPiecesAreAsCurvedAsTheyAre)
{
  const double radius = 5.0 * cell;
  CrackFront<3> front;
  const int pairs = 16;
  for (int k = 0; k < 2 * pairs; ++k)
  {
    const double around = pi * (k % 2 == 0 ? k : k - 0.5) / pairs;
    FrontNode<3> frontNode;
    frontNode.direction = {std::cos(around), std::sin(around), 0.0};
    frontNode.normal = {0.0, 0.0, 1.0};
    frontNode.position = radius * frontNode.direction;
    frontNode.facet = k;
    front.nodes.push_back(frontNode);
  }
  const FrontLine line = lineOf(front);
  ASSERT_GT(line.loop.at(0), 0.0);
  // Weights by chords, which a circle's arcs exceed by a fraction of (1.5 / 5)^2 / 24.
  EXPECT_NEAR(radiusOfCurvature(line, cell), radius, 0.3 * 0.3 / 24.0 * radius);
}
