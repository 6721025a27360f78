#include "ShapeLists.hpp"

#include "geometry/Seeds.hpp"
#include "geometry/Slivers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <stdexcept>
#include <string>

using Rhegma::makeShape;
using Rhegma::seedParticles;
using Rhegma::Vector;
namespace Geometry = Rhegma::Geometry;
using namespace ShapeLists;
using Teuchos::ParameterList;

/// Cells of 1 m, two particles a cell and axis: centres at 1/4 and 3/4 of every cell, in rows along x.
TEST(Seeds, SitAtTheQuarterPointsOfCells)
{
  const auto seeds = seedParticles(makeShape<2>(box({2.0, 0.0}, {4.0, 1.0})), 1.0, 2, "Beam");
  ASSERT_EQ(seeds.position.size(), 8u);
  EXPECT_DOUBLE_EQ(seeds.edge[0], 0.5);
  EXPECT_DOUBLE_EQ(seeds.volume[0], 0.25);
  for (int p = 0; p < 8; ++p)
  {
    EXPECT_DOUBLE_EQ(seeds.position[p][0], 2.25 + 0.5 * (p % 4));
    EXPECT_DOUBLE_EQ(seeds.position[p][1], 0.25 + 0.5 * (p / 4));
  }
}

/// 1 m by 0.3 m in edges of 0.25 m: 4 of 0.25 m and 1 of 0.3 m, so that the area is 0.3 m^2 exactly.
TEST(Seeds, TileABoxOfAnySize)
{
  const auto seeds = seedParticles(makeShape<2>(box({0.1, 0.1}, {1.1, 0.4})), 0.5, 2, "Beam");
  ASSERT_EQ(seeds.position.size(), 4u);
  EXPECT_DOUBLE_EQ(seeds.edge[0], 0.25);
  EXPECT_DOUBLE_EQ(seeds.edge[1], 0.3);
  EXPECT_DOUBLE_EQ(4.0 * seeds.volume[0], 0.3);
  EXPECT_DOUBLE_EQ(seeds.position[0][1], 0.25);
}

TEST(Seeds, TileABoxIn3D)
{
  const auto seeds = seedParticles(makeShape<3>(box({0.0, 0.0, 0.0}, {1.0, 2.0, 3.0})), 1.0, 2, "Block");
  ASSERT_EQ(seeds.position.size(), 48u);
  EXPECT_DOUBLE_EQ(48 * seeds.volume[0], 6.0);
  EXPECT_DOUBLE_EQ(seeds.position.back()[2], 2.75);
}

/// Turned by 30 degrees about the origin, the first centre (0.25, 0.25) goes to (0.25 cos 30 - 0.25 sin 30,
/// ...).
TEST(Seeds, TurnWithTheirBox)
{
  auto list = box({0.0, 0.0}, {2.0, 1.0});
  list.set("Rotation", 30.0);
  list.set("Rotation Centre", numbers({0.0, 0.0}));
  const auto seeds = seedParticles(makeShape<2>(list), 1.0, 2, "Beam");
  const double cosine = std::sqrt(3.0) / 2.0, sine = 0.5;
  ASSERT_EQ(seeds.position.size(), 8u);
  EXPECT_NEAR(seeds.position[0][0], 0.25 * (cosine - sine), 1.0e-15);
  EXPECT_NEAR(seeds.position[0][1], 0.25 * (cosine + sine), 1.0e-15);
  EXPECT_NEAR(seeds.axes[0][0], cosine, 1.0e-15);
  EXPECT_NEAR(seeds.axes[0][1], sine, 1.0e-15);
  EXPECT_NEAR(seeds.axes[1][0], -sine, 1.0e-15);
}

/// Of a 4 x 4 lattice over a disk of radius 1 with edges 0.5, the corner cells hold 0.13 of a cell or less,
/// so their material belongs to their neighbours.
TEST(Seeds, OfADiskHaveNoSlivers)
{
  const auto seeds = seedParticles(makeShape<2>(ball({5.0, 5.0}, 1.0)), 1.0, 2, "Disk");
  EXPECT_EQ(seeds.position.size(), 12u);
  for (const double volume : seeds.volume)
    EXPECT_GT(volume, 0.25 * Geometry::joinedBelow);
}

/// Every particle of a disk has its mirror images, with their volumes and boxes.
TEST(Seeds, OfADiskAreSymmetric)
{
  const auto seeds = seedParticles(makeShape<2>(ball({0.3, 0.7}, 0.1)), 0.00625, 2, "Disk");
  using Row = std::array<long, 5>;
  std::set<Row> rows;
  const auto row = [](double x, double y, double a, double b, double v)
  {
    return Row{std::lround(1e9 * x), std::lround(1e9 * y), std::lround(1e9 * a), std::lround(1e9 * b),
               std::lround(1e12 * v)};
  };
  const auto rowOf = [&](std::size_t p, double sx, double sy, bool swaps)
  {
    const double x = sx * (seeds.position[p][0] - 0.3), y = sy * (seeds.position[p][1] - 0.7);
    const double a = seeds.box[p][0], b = seeds.box[p][1];
    return swaps ? row(y, x, b, a, seeds.volume[p]) : row(x, y, a, b, seeds.volume[p]);
  };
  for (std::size_t p = 0; p < seeds.position.size(); ++p)
    rows.insert(rowOf(p, 1.0, 1.0, false));
  ASSERT_EQ(rows.size(), seeds.position.size());
  for (std::size_t p = 0; p < seeds.position.size(); ++p)
  {
    EXPECT_EQ(rows.count(rowOf(p, -1.0, 1.0, false)), 1u)
        << seeds.position[p][0] << ' ' << seeds.position[p][1];
    EXPECT_EQ(rows.count(rowOf(p, 1.0, 1.0, true)), 1u)
        << seeds.position[p][0] << ' ' << seeds.position[p][1];
  }
}

/// An L of three unit squares holds 3 * 4 particles of edge 1/2.
TEST(Seeds, TileAPolygonWithSidesAlongTheAxes)
{
  const ParameterList list = polygon({0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2});
  const auto seeds = seedParticles(makeShape<2>(list), 1.0, 2, "Angle");
  EXPECT_EQ(seeds.position.size(), 12u);
  EXPECT_DOUBLE_EQ(12 * seeds.volume[0], 3.0);
}

/// A 1 x 1 box added at the left of a 1 x 1 box continues its lattice, to negative indices; a quarter is cut.
TEST(Seeds, OfACombinedShapeFollowTheBase)
{
  auto list = box({0.0, 0.0}, {1.0, 1.0});
  list.sublist("Operations").sublist("More") = box({-1.0, 0.0}, {0.0, 1.0});
  list.sublist("Operations").sublist("More").set<std::string>("Operation", "Add");
  list.sublist("Operations").sublist("Notch") = box({-1.0, 0.0}, {-0.5, 1.0});
  list.sublist("Operations").sublist("Notch").set<std::string>("Operation", "Cut");
  const auto seeds = seedParticles(makeShape<2>(list), 1.0, 2, "Beam");
  ASSERT_EQ(seeds.position.size(), 6u);
  EXPECT_DOUBLE_EQ(seeds.position[0][0], -0.25);
  EXPECT_DOUBLE_EQ(seeds.position[0][1], 0.25);
}

TEST(Seeds, RefuseABodyWithoutParticles)
{
  auto list = box({0.0, 0.0}, {1.0, 1.0});
  list.sublist("Operations").sublist("All") = ball({0.5, 0.5}, 2.0);
  list.sublist("Operations").sublist("All").set<std::string>("Operation", "Cut");
  try
  {
    seedParticles(makeShape<2>(list), 1.0, 2, "Bodies > Beam");
    FAIL() << "a body that is cut away was accepted";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_EQ(std::string(error.what()).find("Bodies > Beam: the body contains no particle"), 0u)
        << error.what();
  }
}

/// 1 m in cells of 1 micrometre is 4e12 particles.
TEST(Seeds, RefuseMoreThanCanBeCounted)
{
  EXPECT_THROW(seedParticles(makeShape<2>(box({0.0, 0.0}, {1.0, 1.0})), 1.0e-6, 2, "Beam"),
               std::invalid_argument);
}
