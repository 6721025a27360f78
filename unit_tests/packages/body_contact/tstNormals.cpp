/// The normal between two sets of domains: shortest distance of hulls, and logistic regression.

#include "body_contact/LogisticNormal.hpp"
#include "body_contact/NearestHulls.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace Rhegma::body_contact
{

namespace
{

constexpr unsigned seed = 28;

template <int D>
using Points = std::vector<Vector<D>>;

/// Unit vectors at right angles, turned at random.
template <int D>
std::vector<Vector<D>> randomAxes(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  std::vector<Vector<D>> axes;
  while (static_cast<int>(axes.size()) < D)
  {
    Vector<D> axis;
    for (int d = 0; d < D; ++d)
      axis[d] = normal(random);
    for (const Vector<D>& other : axes)
      axis = axis - dot(axis, other) * other;
    axes.push_back((1.0 / norm(axis)) * axis);
  }
  return axes;
}

/// Points of a layer in front of and behind a plane through the origin, on a lattice along `axes`. The plane
/// has the normal axes[0]; half of the layer on one side is missing.
template <int D>
Points<D> layer(const std::vector<Vector<D>>& axes, double from, double step, int first)
{
  Points<D> points;
  const int last = 4, rows = D == 2 ? 1 : 9;
  for (int depth = 0; depth < 3; ++depth)
    for (int i = first; i <= last; ++i)
      for (int j = 0; j < rows; ++j)
      {
        Vector<D> x = (from + depth * step) * axes[0] + 0.5 * i * axes[1];
        if (D == 3)
          x = x + 0.5 * (j - 4) * axes[D - 1];
        points.push_back(x);
      }
  return points;
}

template <int D>
Vector<D> nearestOf(const Points<D>& one, const Points<D>& other, const Vector<D>& v)
{
  const Vector<D>*a = &one[0], *b = &other[0];
  for (const Vector<D>& x : one)
    a = dot(x, v) > dot(*a, v) ? &x : a;
  for (const Vector<D>& x : other)
    b = dot(x, v) < dot(*b, v) ? &x : b;
  return *b - *a;
}

template <int D>
Vector<D> shortest(const Points<D>& one, const Points<D>& other)
{
  return shortestBetweenHulls<D>(other[0] - one[0],
                                 [&](const Vector<D>& v) { return nearestOf<D>(one, other, v); });
}

template <int D>
Vector<D> regression(const Points<D>& one, const Points<D>& other)
{
  return logisticNormal<D>(
      [&](const auto& visit)
      {
        for (const Vector<D>& x : one)
          visit(-1.0, x);
        for (const Vector<D>& x : other)
          visit(1.0, x);
      });
}

/// Two layers, one of which ends in the middle of the other: the normal is that of the faces, to rounding.
template <int D>
void findFaces()
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> gaps(0.01, 1.0);
  for (int k = 0; k < 50; ++k)
  {
    const auto axes = randomAxes<D>(random);
    const double gap = gaps(random);
    const Points<D> below = layer<D>(axes, -0.5 * gap, -0.5, -4), above = layer<D>(axes, 0.5 * gap, 0.5, 0);
    const Vector<D> found = shortest<D>(below, above);
    EXPECT_NEAR(norm(found), gap, 1e-9);
    EXPECT_NEAR(dot(found, axes[0]), gap, 1e-9);
    // Regression sees that the second layer lies to one side, and turns by a few degrees.
    EXPECT_GT(dot(regression<D>(below, above), axes[0]), 0.98);
  }
}

TEST(NormalsOfBodies, AreThoseOfFlatFaces)
{
  findFaces<2>();
  findFaces<3>();
}

/// The distance of random clouds is not below the largest gap along random directions, nor above that along
/// its own.
template <int D>
void findLargestGap()
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> at(-1.0, 1.0);
  for (int k = 0; k < 50; ++k)
  {
    Points<D> one(20), other(20);
    for (int i = 0; i < 20; ++i)
      for (int d = 0; d < D; ++d)
      {
        one[i][d] = at(random);
        other[i][d] = at(random) + (d == 0 ? 2.5 : 0.7);
      }
    const Vector<D> found = shortest<D>(one, other);
    const double distance = norm(found);
    const auto gapAlong = [&](const Vector<D>& n) { return dot(nearestOf<D>(one, other, n), n); };
    EXPECT_NEAR(gapAlong((1.0 / distance) * found), distance, 1e-9);
    for (int trial = 0; trial < 100; ++trial)
      EXPECT_LE(gapAlong(randomAxes<D>(random)[0]), distance + 1e-9);
  }
}

TEST(NormalsOfBodies, HaveTheLargestGap)
{
  findLargestGap<2>();
  findLargestGap<3>();
}

TEST(NormalsOfBodies, AreFoundWherePointsOverlap)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> scatter(0.0, 0.4);
  Points<2> one, other;
  for (int k = 0; k < 400; ++k)
  {
    one.push_back({-0.5 + scatter(random), scatter(random)});
    other.push_back({0.5 + scatter(random), scatter(random)});
  }
  EXPECT_EQ(norm(shortest<2>(one, other)), 0.0);
  // The best plane of two normal distributions that differ by their means is across these.
  const Vector<2> n = regression<2>(one, other);
  EXPECT_NEAR(n[0], 1.0, 0.02);
  EXPECT_NEAR(norm(regression<2>(one, {})), 0.0, 0.0);
}

} // namespace

} // namespace Rhegma::body_contact
