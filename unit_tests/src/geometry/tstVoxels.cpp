#include "geometry/VoxelPhase.hpp"

#include "Surfaces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace Rhegma;
using namespace Rhegma::Geometry;
using Surfaces::seedOf;

namespace
{

constexpr int across = 7, up = 5, deep = 4;

struct Image
{
  std::vector<std::int16_t> inside;
  VoxelPhase<3> phase;

  explicit Image(std::vector<std::int16_t> values) : inside(values), phase({across, up, deep}, values) {}

  bool has(int i, int j, int k) const { return inside[(i * up + j) * deep + k] > 0; }
};

Image randomImage(std::mt19937& random)
{
  std::vector<std::int16_t> values(across * up * deep);
  for (std::int16_t& value : values)
    value = random() % 3 == 0 ? 1 : -1;
  values[5] = 1;
  return Image(values);
}

/// The largest distance along an axis from a point to the nearest voxel of a kind, of all of them; beyond the
/// image there are three layers of voxels outside.
double distance(const Image& image, const Vector<3>& x, bool inside)
{
  double least = std::numeric_limits<double>::infinity();
  for (int i = -3; i < across + 3; ++i)
    for (int j = -3; j < up + 3; ++j)
      for (int k = -3; k < deep + 3; ++k)
      {
        const bool isInImage = i >= 0 && i < across && j >= 0 && j < up && k >= 0 && k < deep;
        if ((isInImage && image.has(i, j, k)) != inside)
          continue;
        const double low[3] = {double(i), double(j), double(k)};
        double away = 0.0;
        for (int d = 0; d < 3; ++d)
          away = std::max({away, low[d] - x[d], x[d] - low[d] - 1.0});
        least = std::min(least, away);
      }
  return least;
}

} // namespace

/// The depth is the distance to the nearest voxel of the other kind, and a point is in the phase where it is
/// in one of its voxels.
TEST(Voxels, DepthIsTheDistanceToTheOtherKind)
{
  std::mt19937 random(seedOf("Voxels.DepthIsTheDistanceToTheOtherKind"));
  std::uniform_real_distribution<double> anywhere(-2.0, 9.0);
  const Image image = randomImage(random);
  for (int n = 0; n < 2000; ++n)
  {
    const Vector<3> x{{anywhere(random), anywhere(random), anywhere(random)}};
    const double out = distance(image, x, true), in = distance(image, x, false);
    EXPECT_NEAR(image.phase.depth(x), out > 0.0 ? -out : in, 1e-12);
    EXPECT_EQ(image.phase.contains(x, 1e-12), out == 0.0);
  }
  const Vector<3> far{{-50.0, 2.0, 2.0}};
  EXPECT_LE(image.phase.depth(far), -49.0);
  EXPECT_FALSE(image.phase.contains(far, 1e-12));
}

/// Fraction, centroid and variance of a box are sums over small cells, in which each voxel is resolved.
TEST(Voxels, PartOfABoxIsExact)
{
  std::mt19937 random(seedOf("Voxels.PartOfABoxIsExact"));
  const Image image = randomImage(random);
  constexpr int fine = 4; // cells of a quarter of a voxel
  std::uniform_int_distribution<int> begin(-2, 10), length(1, 14);
  for (int n = 0; n < 100; ++n)
  {
    const int first[3] = {begin(random), begin(random), begin(random)};
    const int count[3] = {length(random), length(random), length(random)};
    double number = 0.0;
    Vector<3> sum{}, squares{};
    for (int i = 0; i < count[0]; ++i)
      for (int j = 0; j < count[1]; ++j)
        for (int k = 0; k < count[2]; ++k)
        {
          const int at[3] = {i, j, k};
          int voxel[3];
          for (int d = 0; d < 3; ++d)
            voxel[d] = static_cast<int>(std::floor(double(first[d] + at[d]) / fine));
          if (!image.phase.has({voxel[0], voxel[1], voxel[2]}))
            continue;
          number += 1.0;
          for (int d = 0; d < 3; ++d)
          {
            const double middle = (at[d] + 0.5) / count[d] - 0.5;
            sum[d] += middle;
            squares[d] += middle * middle + 1.0 / (12.0 * count[d] * count[d]);
          }
        }
    Vector<3> lower, upper;
    for (int d = 0; d < 3; ++d)
    {
      lower[d] = double(first[d]) / fine;
      upper[d] = double(first[d] + count[d]) / fine;
    }
    const BoxPart<3> part = image.phase.part(lower, upper);
    EXPECT_NEAR(part.fraction, number / (count[0] * count[1] * count[2]), 1e-13);
    for (int d = 0; d < 3 && number > 0.0; ++d)
    {
      EXPECT_NEAR(part.centroid[d], sum[d] / number, 1e-12);
      EXPECT_NEAR(part.variance[d], squares[d] / number - sum[d] * sum[d] / (number * number), 1e-12);
    }
  }
}

/// Far from the other kind the depth is too small by less than a voxel.
TEST(Voxels, DepthIsABoundFarInside)
{
  constexpr std::int64_t size = 64;
  const VoxelPhase<2> phase({size, size}, std::vector<std::int16_t>(size * size, 1));
  EXPECT_NEAR(phase.depth({{5.5, 32.0}}), 5.5, 1e-12);
  EXPECT_LE(phase.depth({{32.0, 32.0}}), 32.0);
  EXPECT_GE(phase.depth({{32.0, 32.0}}), 31.0);
  EXPECT_EQ(phase.bounds().upper[1], 64.0);
}
