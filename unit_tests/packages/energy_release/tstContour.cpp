#include "LatticeState.hpp"

#include "energy_release/CrackPath.hpp"
#include "energy_release/FrontTube.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace Rhegma;
using namespace Rhegma::energy_release;
using namespace Rhegma::energy_release::test;

/// The body ends on a line of nodes 3 mm to the right of the front.
TEST(Contour, EndsAtTheSurface)
{
  const State<2> state = makeBody(0.01, 1e-3, Plane::Strain, ShapeKind::Gimp);
  CrackFront<2> front;
  front.position = {{0.007, 0.0}};
  EXPECT_NEAR(largestContour(state, front, 0.006), 0.003, 1e-12);
  front.position = {{0.0, 0.0}};
  EXPECT_EQ(largestContour(state, front, 0.006), 0.006);
}

TEST(Contour, EndsAtAnotherFront)
{
  State<2> state = makeBody(0.01, 1e-3, Plane::Strain, ShapeKind::Linear);
  CrackFront<2> front = addFront(state, {{-0.002, 0.0}}, 0.0);
  CrackFront<2> other = front;
  other.number = 1;
  other.position = {{0.003, 0.0}};
  state.cracks.fronts.push_back(other);
  EXPECT_NEAR(largestContour(state, front, 0.007), 0.005, 1e-12);
}

namespace
{

constexpr double cell = 1e-3;

ContourRadii radiiAt(double x, const GivenRadii& given = {})
{
  State<2> state = makeBody(0.01, cell, Plane::Strain, ShapeKind::Gimp);
  return fittingTube(state, addFront(state, {{x, 0.0}}, 0.0), given).radii;
}

void expectRadii(const ContourRadii& radii, double inner, double outer)
{
  EXPECT_NEAR(radii.inner, inner, 1e-12);
  EXPECT_NEAR(radii.outer, outer, 1e-12);
}

} // namespace

/// The body ends at x = 10 mm.
TEST(Contour, DrawsInWhereItIsNotGiven)
{
  expectRadii(radiiAt(0.000), 3e-3, 6e-3);
  expectRadii(radiiAt(0.005), 2.5e-3, 5e-3);
  expectRadii(radiiAt(0.006), 2e-3, 4e-3);
  expectRadii(radiiAt(0.007), 2e-3, 3e-3);
  expectRadii(radiiAt(0.008), 1e-3, 2e-3);
  expectRadii(radiiAt(0.009), 1e-3, 2e-3); // no smaller: such a front is refused at the start
}

TEST(Contour, KeepsWhatIsGiven)
{
  expectRadii(radiiAt(0.007, {0.0, 5e-3}), 2.5e-3, 5e-3);
  expectRadii(radiiAt(0.005, {1e-3, 0.0}), 1e-3, 5e-3);
  expectRadii(radiiAt(0.000, {4e-3, 0.0}), 4e-3, 8e-3);
  expectRadii(radiiAt(0.007, {4e-3, 0.0}), 4e-3, 5e-3);
}

TEST(Contour, StaysClearOfOtherCracks)
{
  State<2> state = makeBody(0.01, cell, Plane::Strain, ShapeKind::Gimp);
  const CrackFront<2> front = addFront(state, {{0.0, 0.0}}, 0.0);
  state.cracks.cracks.push_back({"Other", 0, 2, 0, 1});
  state.cracks.vertex = View<double* [2]>("rhegma::vertex", 2);
  state.cracks.vertex(0, 0) = -2e-3;
  state.cracks.vertex(1, 0) = 2e-3;
  state.cracks.vertex(0, 1) = state.cracks.vertex(1, 1) = 5e-3;
  state.cracks.simplex = View<int* [2]>("rhegma::simplex", 1);
  state.cracks.simplex(0, 1) = 1;
  expectRadii(fittingTube(state, front, {}).radii, 2e-3, 4e-3);
}

/// A crack whose front looks back along its own other leg, 5 mm away; with legs of 1 mm it has only turned.
TEST(Contour, StaysClearOfItsOwnCrack)
{
  for (const double leg : {6e-3, 1e-3})
  {
    State<2> state = makeBody(0.01, cell, Plane::Strain, ShapeKind::Gimp);
    const CrackFront<2> front = addFront(state, {{0.0, 0.0}}, std::acos(-1.0));
    const double points[4][2] = {{-5e-3, 5e-3}, {leg, 5e-3}, {leg, 0.0}, {0.0, 0.0}};
    CrackSet<2>& cracks = state.cracks;
    cracks.cracks[0].numVertices = 4;
    cracks.cracks[0].numSimplices = 3;
    cracks.vertex = View<double* [2]>("rhegma::vertex", 4);
    cracks.simplex = View<int* [2]>("rhegma::simplex", 3);
    cracks.neighbour = View<int* [2]>("rhegma::neighbour", 3);
    cracks.frontFacet = View<int* [2]>("rhegma::frontFacet", 1);
    cracks.frontFacet(0, 0) = 2;
    for (int v = 0; v < 4; ++v)
      for (int d = 0; d < 2; ++d)
        cracks.vertex(v, d) = points[v][d];
    for (int s = 0; s < 3; ++s)
      for (int i = 0; i < 2; ++i)
      {
        cracks.simplex(s, i) = s + i;
        const int beyond = i == 0 ? s + 1 : s - 1; // facet i is opposite to vertex i
        cracks.neighbour(s, i) = beyond == 3 ? facet::front : beyond;
      }
    expectRadii(fittingTube(state, front, {}).radii, leg > 2e-3 ? 2e-3 : 3e-3, leg > 2e-3 ? 4e-3 : 6e-3);
  }
}

/// Outside of a bend positions have the bend as their nearest point: round-off must not decide to which piece
/// they belong.
TEST(CrackPath, OutsideOfABendPositionsGoWithThePieceNearerToTheFront)
{
  constexpr int times = 40;
  for (const bool forwards : {true, false})
    for (int k = 0; k < times; ++k)
    {
      const double x = 0.013 * k, y = 0.029 * k, ends[3][2] = {{0.0, 0.0}, {1.0, 0.0}, {1.7, 0.7}};
      CrackPath path;
      path.vertex = View<double* [2]>("rhegma::vertex", 3);
      path.simplex = View<int* [2]>("rhegma::simplex", 2);
      for (int v = 0; v < 3; ++v)
      {
        path.vertex(v, 0) = ends[v][0] + x;
        path.vertex(v, 1) = ends[v][1] + y;
      }
      for (int s = 0; s < 2; ++s)
        for (int i = 0; i < 2; ++i)
          path.simplex(s, i) = s + i;
      path.count = 2;
      path.forwards = forwards;
      const Vector<2> found = path(Vector<2>{{1.3 + x, -0.7 + y}});
      EXPECT_NEAR(found[0], forwards ? std::sqrt(0.5) : -1.0, 1e-12) << k;
      EXPECT_NEAR(found[1], forwards ? std::sqrt(0.5) : 0.0, 1e-12) << k;
    }
}
