/// Sizes of cracks in 3D: by what lies behind their fronts, not by the thickness of a plate.

#include "plausibility/CrackExtent.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace Rhegma
{
namespace Test
{
namespace
{

/// A rectangle in the plane y = 0 of a depth along x and a width along z, with fronts of two nodes where x is
/// largest and, with both, where it is smallest.
State<3> rectangle(double depth, double width, bool both)
{
  State<3> state;
  state.cracks.cracks = {{"Notch", 0, 4, 0, 2}};
  state.cracks.vertex = View<double* [3]>("rhegma::vertex", 4);
  state.cracks.simplex = View<int* [3]>("rhegma::simplex", 2);
  for (int v = 0; v < 4; ++v)
  {
    state.cracks.vertex(v, 0) = v == 1 || v == 2 ? depth : 0.0;
    state.cracks.vertex(v, 2) = v > 1 ? width : 0.0;
  }
  for (int i = 0; i < 3; ++i)
  {
    state.cracks.simplex(0, i) = i;
    state.cracks.simplex(1, i) = i == 0 ? 0 : i + 1;
  }
  for (int f = 0; f < (both ? 2 : 1); ++f)
  {
    CrackFront<3> front;
    front.nodes.resize(2);
    for (FrontNode<3>& node : front.nodes)
    {
      node.direction = Vector<3>{{f == 0 ? 1.0 : -1.0, 0.0, 0.0}};
      node.normal = Vector<3>{{0.0, 1.0, 0.0}};
    }
    state.cracks.fronts.push_back(front);
  }
  return state;
}

/// A box along the axes, from the origin in x and z and about it in y.
BodyMeasure<3> box(double x, double y, double z)
{
  BodyMeasure<3> body;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      body.axes[i][j] = i == j ? 1.0 : 0.0;
  body.lower = body.ownLower = Vector<3>{{0.0, -0.25 * y, 0.0}};
  body.upper = body.ownUpper = Vector<3>{{x, 0.75 * y, z}};
  body.shortest = std::min(x, std::min(y, z));
  return body;
}

} // namespace

TEST(CrackExtent, IsTheDepthWhateverTheThickness)
{
  for (const double width : {2.0, 40.0})
  {
    const State<3> state = rectangle(4.0, width, false);
    EXPECT_DOUBLE_EQ(extentOf(state, 0), 4.0);
    EXPECT_DOUBLE_EQ(longestCrack(state), 4.0);
    EXPECT_DOUBLE_EQ(areaOf(state, 0), 4.0 * width);
  }
}

/// Without a front the diagonal of its bounds.
TEST(CrackExtent, OfACrackWithoutFronts)
{
  State<3> state = rectangle(3.0, 4.0, false);
  state.cracks.fronts.clear();
  EXPECT_DOUBLE_EQ(extentOf(state, 0), 5.0);
  state.cracks.cracks[0].numVertices = 0;
  EXPECT_EQ(extentOf(state, 0), 0.0);
}

/// A plate of 10 by 8, 2 thick: parts of 2 and 6 next to a crack of 4, whose front runs along the thickness.
TEST(CrackedSection, IsAcrossTheFront)
{
  for (const bool both : {false, true})
  {
    const State<3> state = rectangle(4.0, 2.0, both);
    const BodyMeasure<3> plate = box(10.0, 8.0, 2.0);
    const std::vector<CrackedSection<3>> sections = sectionsOf(state, plate);
    ASSERT_EQ(sections.size(), 1u);
    EXPECT_DOUBLE_EQ(sections[0].depth, 4.0);
    EXPECT_DOUBLE_EQ(sections[0].width, 10.0);
    EXPECT_DOUBLE_EQ(sections[0].fraction, 0.4);
    EXPECT_DOUBLE_EQ(sections[0].below, 2.0);
    EXPECT_DOUBLE_EQ(sections[0].above, 6.0);
    EXPECT_DOUBLE_EQ(sections[0].thinner(), 2.0);
    EXPECT_EQ(sections[0].alongFront, 2);
    EXPECT_EQ(sections[0].atBothEnds, both);
    EXPECT_DOUBLE_EQ(shortestAcrossFronts(state, plate), 8.0);
  }
}

/// A body beyond the crack has no section with it, and counts by all of its extents.
TEST(CrackedSection, IsOfBodiesWithTheCrack)
{
  const State<3> state = rectangle(4.0, 2.0, false);
  BodyMeasure<3> plate = box(10.0, 8.0, 2.0);
  plate.lower[1] = 1.0;
  EXPECT_TRUE(sectionsOf(state, plate).empty());
  EXPECT_DOUBLE_EQ(shortestAcrossFronts(state, plate), 2.0);
}

} // namespace Test
} // namespace Rhegma
