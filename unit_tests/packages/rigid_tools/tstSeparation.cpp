/// Distances of the domains of particles from tools, and the motion of tools.

#include "material/FrictionLaw.hpp"
#include "rigid_tools/Outline.hpp"
#include "rigid_tools/Separation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace Rhegma::rigid_tools
{

namespace
{

constexpr unsigned seed = 31;

template <int D>
Vector<D> randomVector(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  Vector<D> v;
  for (int d = 0; d < D; ++d)
    v[d] = normal(random);
  return v;
}

/// A tool of one primitive.
template <int D, class Primitive>
Shape<D> shapeOf(const Primitive& primitive)
{
  return Shape<D>({{primitive, {Geometry::spaceAxes<D>(), Vector<D>{}}, Geometry::Operation::Add}});
}

template <int D>
Placement<D> randomPlacement(std::mt19937& random)
{
  Placement<D> placement;
  placement.centre = randomVector<D>(random);
  placement.moved = randomVector<D>(random);
  std::uniform_real_distribution<double> angle(0.0, 360.0);
  if constexpr (D == 2)
    placement.axes = Geometry::turnedAxes(angle(random));
  else
    placement.axes = Geometry::turnedAxes(angle(random), randomVector<3>(random));
  return placement;
}

/// Edges of a domain of about this size, sheared a little.
template <int D>
void randomEdges(std::mt19937& random, double size, Vector<D> (&edge)[D])
{
  for (int e = 0; e < D; ++e)
  {
    edge[e] = 0.1 * size * randomVector<D>(random);
    edge[e][e] += size;
  }
}

/// The deepest of many points of a domain.
template <int D>
double deepestOfMany(const ToolSurface<D>& surface, const Vector<D>& centre, const Vector<D> (&edge)[D])
{
  constexpr int cuts = 40;
  double deepest = -1e300;
  int all = 1;
  for (int d = 0; d < D; ++d)
    all *= cuts + 1;
  for (int k = 0; k < all; ++k)
  {
    Vector<D> x = centre;
    for (int e = 0, rest = k; e < D; ++e, rest /= cuts + 1)
      x = x + (double(rest % (cuts + 1)) / cuts - 0.5) * edge[e];
    deepest = std::max(deepest, surface.depth(x));
  }
  return deepest;
}

template <int D>
void checkPlacement()
{
  std::mt19937 random(seed);
  for (int k = 0; k < 20; ++k)
  {
    const Placement<D> placement = randomPlacement<D>(random);
    const Vector<D> own = randomVector<D>(random), other = randomVector<D>(random);
    EXPECT_LT(norm(placement.toOwn(placement.toSpace(own)) - own), 1e-14);
    EXPECT_LT(norm(placement.toSpace(own) - placement.toSpace(other) - placement.turn(own - other)), 1e-14);
    EXPECT_LT(norm(placement.toSpace(placement.centre) - placement.centre - placement.moved), 1e-15);
  }
}

TEST(RigidMotion, PlacementsHaveAnInverse)
{
  checkPlacement<2>();
  checkPlacement<3>();
}

/// Points of a turning tool move at right angles to their arm, with the angular velocity times the arm.
TEST(RigidMotion, PointsOfATurningToolMoveAroundItsCentre)
{
  const RigidVelocity<2> flat{{{1.0, 2.0}}, {3.0}};
  const Vector<2> v = flat.at({{0.5, 0.0}});
  EXPECT_EQ(v[0], 1.0);
  EXPECT_EQ(v[1], 2.0 + 3.0 * 0.5);
  const RigidVelocity<3> solid{{{0.0, 0.0, 1.0}}, {0.0, 0.0, 2.0}};
  const Vector<3> w = solid.at({{0.5, 0.25, 7.0}});
  EXPECT_EQ(w[0], -2.0 * 0.25);
  EXPECT_EQ(w[1], 2.0 * 0.5);
  EXPECT_EQ(w[2], 1.0);
  const RigidVelocity<2> mean = meanOf(flat, RigidVelocity<2>{});
  EXPECT_EQ(mean.ofCentre[1], 1.0);
  EXPECT_EQ(mean.spin[0], 1.5);
}

/// A large box is a flat surface: gap, normal and foot are exact to the differences for the normal.
template <int D>
void checkFlatSurface()
{
  std::mt19937 random(seed + D);
  std::uniform_real_distribution<double> height(-0.2, 1.0), along(-5.0, 5.0);
  Geometry::Bounds<D> bounds;
  for (int d = 0; d < D; ++d)
  {
    bounds.lower[d] = -20.0;
    bounds.upper[d] = d == 1 ? 0.0 : 20.0;
  }
  const Shape<D> shape = shapeOf<D>(Geometry::Box<D>{bounds});
  for (int k = 0; k < 50; ++k)
  {
    const Placement<D> placement = randomPlacement<D>(random);
    const ToolSurface<D> surface{shape, placement, 1e-3};
    Vector<D> edge[D], own;
    randomEdges(random, 0.5, edge);
    for (int d = 0; d < D; ++d)
      own[d] = d == 1 ? height(random) : along(random);
    const Vector<D> normal = placement.turn(Vector<D>{{0.0, 1.0}}), centre = placement.toSpace(own);
    double reach = 0.0;
    for (int e = 0; e < D; ++e)
      reach += 0.5 * std::fabs(dot(edge[e], normal));
    const Separation<D> found = separate(surface, centre, edge);
    EXPECT_LT(std::fabs(found.gap - (own[1] - reach)), 1e-10);
    EXPECT_LT(norm(found.normal - normal), 1e-10);
    EXPECT_LT(norm(found.foot - (centre - own[1] * normal)), 1e-10);
  }
}

TEST(Separation, IsExactForAFlatSurface)
{
  checkFlatSurface<2>();
  checkFlatSurface<3>();
}

/// Gaps of round tools and of corners of tools are those of a dense lattice of points of the domain. Such a
/// point is at most half of a step of the lattice along each edge from the nearest one of the domain.
template <int D, class Primitive>
void checkSampled(const Primitive& primitive, double from, double to, double within = 0.02)
{
  std::mt19937 random(seed + 10 * D);
  std::uniform_real_distribution<double> distance(from, to);
  const Shape<D> shape = shapeOf<D>(primitive);
  for (int k = 0; k < 40; ++k)
  {
    const Placement<D> placement = randomPlacement<D>(random);
    const ToolSurface<D> surface{shape, placement, 1e-4};
    Vector<D> edge[D];
    randomEdges(random, 0.5, edge);
    Vector<D> direction = randomVector<D>(random);
    direction = 1.0 / norm(direction) * direction;
    const Vector<D> centre = placement.toSpace(distance(random) * direction);
    const double step = 0.5 * 0.5 / 40 * std::sqrt(double(D)) * 1.5,
                 sampled = -deepestOfMany(surface, centre, edge);
    const Separation<D> found = separate(surface, centre, edge);
    // Of a corner of the tool in the middle of a domain the depth is not found, but that it touches.
    if (sampled > step)
      EXPECT_LT(std::fabs(found.gap - sampled), step + within) << k;
    else
    {
      EXPECT_LT(found.gap, step) << k;
      EXPECT_GT(found.gap, sampled - step) << k;
    }
    EXPECT_LT(std::fabs(norm(found.normal) - 1.0), 1e-12);
  }
}

TEST(Separation, IsThatOfManyPointsOfTheDomain)
{
  checkSampled<2>(Geometry::Ball<2>{{}, 2.0}, 1.9, 3.5);
  checkSampled<3>(Geometry::Ball<3>{{}, 2.0}, 1.9, 3.5);
  // Next to edges and corners of a box, where its depth is smaller than the distance, to a quarter of the
  // edge.
  checkSampled<2>(Geometry::Box<2>{{{{-1.0, -1.0}}, {{1.0, 1.0}}}}, 1.75, 3.0, 0.125);
  checkSampled<3>(Geometry::Box<3>{{{{-1.0, -1.0, -1.0}}, {{1.0, 1.0, 1.0}}}}, 2.2, 3.5, 0.125);
}

TEST(FrictionLaw, CutsTheImpulseToThePressure)
{
  const Vector<2> n{{0.0, 1.0}};
  const auto free = contactImpulse<2>({}, n, {{3.0, 2.0}});
  EXPECT_EQ(free.impulse[0], 0.0);
  EXPECT_EQ(free.impulse[1], 2.0);
  EXPECT_FALSE(free.sticks);
  const auto slides = contactImpulse<2>({0.5, 0.25}, n, {{3.0, 2.0}});
  EXPECT_EQ(slides.impulse[0], 0.5);
  EXPECT_EQ(slides.impulse[1], 2.0);
  EXPECT_FALSE(slides.sticks);
  const auto sticks = contactImpulse<2>({0.5, 0.25}, n, {{1.0, 2.0}});
  EXPECT_EQ(sticks.impulse[0], 1.0);
  EXPECT_TRUE(sticks.sticks);
  const auto parts = contactImpulse<2>({0.5, 0.25}, n, {{1.0, -2.0}});
  EXPECT_EQ(parts.impulse[0], 0.0);
  EXPECT_EQ(parts.pressing, 0.0);
}

/// Outlines lie on the surface, and what an operation has cut off is left out.
TEST(Outline, LiesOnTheSurface)
{
  const Geometry::Frame<2> straight{Geometry::spaceAxes<2>(), Vector<2>{}};
  const Geometry::Box<2> box{{{{0.0, 0.0}}, {{2.0, 1.0}}}};
  const Geometry::Ball<2> ball{{{2.0, 1.0}}, 0.5};
  const Shape<2> cut({{box, straight, Geometry::Operation::Add}, {ball, straight, Geometry::Operation::Cut}});
  const ToolOutline<2> outline = outlineOf(cut);
  double length = 0.0;
  for (const auto& [a, b] : outline.cells)
  {
    const Vector<2>&from = outline.points[a], &to = outline.points[b];
    length += norm(to - from);
    EXPECT_LT(std::fabs(cut.depth(0.5 * (from + to))), 0.01);
  }
  // Sides less what is cut off, and a quarter of a circle; each end is off by a piece at most.
  EXPECT_NEAR(length, 6.0 - 1.0 + 0.25 * 3.14159265 * 1.0, 4.0 / 16.0);
  const ToolOutline<3> solid = outlineOf(shapeOf<3>(Geometry::Cylinder<3>{{}, {{0.0, 0.0, 2.0}}, 0.5}));
  EXPECT_FALSE(solid.cells.empty());
  for (const Vector<3>& x : solid.points)
    EXPECT_LT(std::hypot(x[0], x[1]), 0.5 + 1e-12);
}

} // namespace

} // namespace Rhegma::rigid_tools
