#include "LatticeState.hpp"

#include "energy_release/Contour.hpp"

#include <gtest/gtest.h>

using namespace Rhegma;
using namespace Rhegma::energy_release;
using namespace Rhegma::energy_release::test;

/// The body ends on a line of nodes 3 mm to the right of the front.
TEST(Contour, EndsAtTheSurface)
{
  const State<2> state = makeBody(0.01, 1e-3, Plane::Strain, ShapeKind::Gimp);
  EXPECT_NEAR(clearRadius(state, {{0.007, 0.0}}, 0.006), 0.003, 1e-12);
  EXPECT_EQ(clearRadius(state, {{0.0, 0.0}}, 0.006), 0.006);
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
