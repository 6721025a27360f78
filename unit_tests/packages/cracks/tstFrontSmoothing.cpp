#include "cracks/FrontSmoothing.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace Rhegma;
using namespace Rhegma::cracks;
using namespace Rhegma::surface;

namespace
{

constexpr double cell = 1e-3;

/// An open line of front along y whose points are ahead of it, each by its own length.
struct Line
{
  GrowingSurface surface;
  FrontLines<3> lines;
  std::vector<FrontNode<3>> nodes;
  std::vector<FrontNodeAdvance<3>> advances;

  Line(const std::vector<double>& y, const std::vector<double>& ahead, double length)
  {
    for (std::size_t k = 0; k < y.size(); ++k)
    {
      surface.vertices.push_back({ahead[k], y[k], 0.0});
      FrontPoint<3> point;
      FrontNode<3> node;
      point.vertex = static_cast<int>(k);
      point.joined = k + 1 < y.size();
      point.direction = {1.0, 0.0, 0.0};
      node.driving.release = 90.0;
      node.tributaryLength =
          0.5 * ((k > 0 ? y[k] - y[k - 1] : 0.0) + (k + 1 < y.size() ? y[k + 1] - y[k] : 0.0));
      lines.push_back(point);
      nodes.push_back(node);
      advances.push_back({point.direction, length, 100.0 + 10.0 * double(k)});
    }
  }

  void smooth()
  {
    smoothAlongFront(surface, lines, nodes, std::vector<double>(lines.size(), cell),
                     std::vector<bool>(lines.size(), false), advances);
  }

  /// Sum of length times tributary length, times toughness if requested.
  double sum(bool energy) const
  {
    double all = 0.0;
    for (std::size_t k = 0; k < lines.size(); ++k)
      if (advances[k].length > 0.0)
        all += advances[k].length * nodes[k].tributaryLength * (energy ? advances[k].toughness : 1.0);
    return all;
  }
};

std::vector<double> evenly(std::size_t count)
{
  std::vector<double> y;
  y.reserve(count);
  for (std::size_t k = 0; k < count; ++k)
    y.push_back(double(k) * cell);
  return y;
}

} // namespace

/// A front node at rest behind its neighbours receives area, with its energy, and none where its resistance
/// is more than twice its driving force, or infinite.
TEST(FrontSmoothing, HandsOnAreaWithItsEnergy)
{
  const double d = 0.08 * cell;
  for (const double resists : {80.0, 200.0, std::numeric_limits<double>::infinity()})
  {
    Line front(evenly(9), {d, d, d, d, 0.0, d, d, d, d}, 0.25 * cell);
    front.advances[4] = {front.lines[4].direction, 0.0, resists};
    const double area = front.sum(false), energy = front.sum(true);
    front.smooth();
    EXPECT_NEAR(front.sum(false), area, 1e-14 * area);
    EXPECT_NEAR(front.sum(true), energy, 1e-14 * energy);
    const FrontNodeAdvance<3>& corner = front.advances[4];
    if (resists > 180.0)
    {
      EXPECT_EQ(corner.length, 0.0);
      continue;
    }
    // 0.25 of the difference of curvatures, 2 d / h^2 there, - d / h^2 next to it, halved, to both sides.
    // Pieces are longer than h by d^2 / (2 h^2).
    EXPECT_NEAR(corner.length, 0.25 * 1.5 * d, 2.0 * 0.08 * 0.08 * d);
    EXPECT_GE(corner.toughness, front.advances[3].toughness - 1e-9);
    EXPECT_LE(corner.toughness, front.advances[5].toughness + 1e-9);
  }
}

/// A ripple of points of which every other is ahead decreases in each step and never changes its sign, with
/// pieces of any length that a front may have.
TEST(FrontSmoothing, NeverTurnsARippleRound)
{
  for (const double longer : {1.0, 1.5, 2.0, 3.0})
  {
    std::vector<double> y{0.0}, ahead;
    for (int k = 0; k < 15; ++k)
      y.push_back(y.back() + 0.5 * cell * (k % 2 == 0 ? 1.0 : longer));
    for (std::size_t k = 0; k < y.size(); ++k)
      ahead.push_back(k % 2 == 0 ? 0.05 * cell : 0.0);
    Line front(y, ahead, 0.25 * cell); // long enough that the flux is not limited
    front.smooth();
    // Away from the ends, where there is no flux.
    const double ripple = front.advances[6].length + 0.05 * cell - front.advances[7].length;
    EXPECT_LT(ripple, 0.05 * cell) << longer;
    EXPECT_GT(ripple, -0.1 * 0.1 * 0.05 * cell) << longer; // pieces are inclined by up to 0.1
  }
}
