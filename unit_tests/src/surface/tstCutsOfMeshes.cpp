/// Particles of bodies that cracks divide: the mass on each side of a crack is exact.

#include "Pi.hpp"
#include "geometry/Seeds.hpp"
#include "geometry/Slivers.hpp"
#include "surface/CutsOfMeshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>

using namespace Rhegma;
using surface::CrackMesh;

namespace
{

using Rhegma::Test::pi;

std::mt19937 seededEngine()
{
  const char* const given = std::getenv("RHEGMA_SEED");
  const unsigned seed = given != nullptr ? std::strtoul(given, nullptr, 10) : std::random_device{}();
  std::cout << "seed " << seed << '\n';
  return std::mt19937(seed);
}

double between(std::mt19937& engine, double from, double to)
{
  return std::uniform_real_distribution<double>(from, to)(engine);
}

template <int D>
Shape<D> boxOf(const Vector<D>& upper)
{
  Teuchos::ParameterList list;
  list.set<std::string>("Shape", "Box");
  list.set("Lower Corner", Teuchos::Array<double>(D, 0.0));
  list.set("Upper Corner", Teuchos::Array<double>(upper.c, upper.c + D));
  return makeShape<D>(list);
}

/// \param beyond what is beyond the first and the last point
CrackMesh<2> polyline(const std::vector<Vector<2>>& points, int first = facet::surfaceBreaking,
                      int last = facet::surfaceBreaking)
{
  CrackMesh<2> mesh;
  mesh.vertices = points;
  const int pieces = static_cast<int>(points.size()) - 1;
  for (int s = 0; s < pieces; ++s)
  {
    mesh.simplices.push_back({s, s + 1});
    mesh.beyond.push_back({s + 1 < pieces ? s + 1 : last, s > 0 ? s - 1 : first});
  }
  return mesh;
}

/// Volume and first moments of the particles whose centroids a function is positive at.
template <int D, class IsIn>
std::pair<double, Vector<D>> momentsWhere(const Seeds<D>& seeds, const IsIn& isIn)
{
  double volume = 0.0;
  Vector<D> first{};
  for (std::size_t p = 0; p < seeds.position.size(); ++p)
    if (isIn(seeds.position[p]))
    {
      volume += seeds.volume[p];
      first = first + seeds.volume[p] * seeds.position[p];
    }
  return {volume, first};
}

/// The part of a convex polygon where a linear function is positive (Sutherland and Hodgman).
std::vector<Vector<2>> clip(const std::vector<Vector<2>>& polygon,
                            const std::function<double(const Vector<2>&)>& depth)
{
  std::vector<Vector<2>> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector<2>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double da = depth(a), db = depth(b);
    if (da > 0.0)
      kept.push_back(a);
    if ((da > 0.0) != (db > 0.0))
      kept.push_back(a + (da / (da - db)) * (b - a));
  }
  return kept;
}

std::pair<double, Vector<2>> momentsOf(const std::vector<Vector<2>>& polygon)
{
  double area = 0.0;
  Vector<2> first{};
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector<2>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double twice = a[0] * b[1] - a[1] * b[0];
    area += 0.5 * twice;
    first = first + (twice / 6.0) * (a + b);
  }
  return {area, first};
}

/// Volume of the part of a box from the origin to `upper` where n . x < at, all components of n positive:
/// sum over the corners of (-1)^k max(0, at - n . corner)^3 / (6 n1 n2 n3).
double volumeBelow(const Vector<3>& upper, const Vector<3>& n, double at)
{
  double sum = 0.0;
  for (int k = 0; k < 8; ++k)
  {
    double left = at;
    int ones = 0;
    for (int d = 0; d < 3; ++d)
      if ((k >> d & 1) != 0)
      {
        left -= n[d] * upper[d];
        ++ones;
      }
    sum += (ones % 2 == 0 ? 1.0 : -1.0) * std::pow(std::max(0.0, left), 3);
  }
  return sum / (6.0 * n[0] * n[1] * n[2]);
}

TEST(CutsOfMeshes, MassAndCentroidOfEachSideOfAStraightCrackAreExact)
{
  std::mt19937 engine = seededEngine();
  for (int trial = 0; trial < 60; ++trial)
  {
    const Vector<2> upper{{between(engine, 3.0, 6.0), between(engine, 3.0, 6.0)}};
    const double angle = between(engine, 0.0, 2.0 * pi);
    const Vector<2> middle{{between(engine, 0.2, 0.8) * upper[0], between(engine, 0.2, 0.8) * upper[1]}};
    const Vector<2> along{{std::cos(angle), std::sin(angle)}}, n{{-along[1], along[0]}};
    SeedRules<2> rules;
    rules.cuts = surface::cutsOfMeshes<2>({polyline({middle - 9.0 * along, middle, middle + 9.0 * along})});
    const Seeds<2> seeds = seedParticles(boxOf(upper), 1.0, trial % 2 == 0 ? 2 : 3, "Plate", rules);
    for (const double sign : {-1.0, 1.0})
    {
      const auto depth = [&](const Vector<2>& x) { return sign * dot(x - middle, n); };
      const auto [area, first] = momentsOf(
          clip({Vector<2>{}, Vector<2>{{upper[0], 0.0}}, upper, Vector<2>{{0.0, upper[1]}}}, depth));
      const auto [found, foundFirst] = momentsWhere(seeds, [&](const auto& x) { return depth(x) > 0.0; });
      EXPECT_NEAR(found, area, 1e-9 * area) << trial;
      EXPECT_LT(norm(foundFirst - first), 1e-9 * area * norm(upper)) << trial;
    }
    // No particle is left that a node would feel as a tenth of another.
    const double cell = seeds.edge[0] * seeds.edge[1];
    const auto small = std::count_if(seeds.volume.begin(), seeds.volume.end(),
                                     [&](double v) { return v < 0.999 * Geometry::joinedBelow * cell; });
    EXPECT_LE(small, 1) << trial; // in the corner that a crack may cut off
  }
}

TEST(CutsOfMeshes, ParticlesAheadOfAFrontAreWhole)
{
  std::mt19937 engine = seededEngine();
  for (int trial = 0; trial < 40; ++trial)
  {
    const double angle = between(engine, -0.7, 0.7);
    const Vector<2> along{{std::cos(angle), std::sin(angle)}}, n{{-along[1], along[0]}};
    const Vector<2> mouth{{-1.0, between(engine, 3.0, 5.0)}},
        front = mouth + between(engine, 3.0, 5.0) * along;
    SeedRules<2> rules;
    rules.cuts = surface::cutsOfMeshes<2>({polyline({mouth, front}, facet::surfaceBreaking, facet::front)});
    const Seeds<2> seeds = seedParticles(boxOf<2>({{8.0, 8.0}}), 1.0, 2, "Plate", rules);
    const double reach = norm(seeds.edge);
    double all = 0.0;
    for (std::size_t p = 0; p < seeds.position.size(); ++p)
    {
      all += seeds.volume[p];
      const Vector<2> from = seeds.position[p] - front;
      const bool isAway = dot(from, along) > reach || std::fabs(dot(from, n)) > 2.0 * reach;
      EXPECT_TRUE(!isAway || seeds.volume[p] == seeds.edge[0] * seeds.edge[1]) << trial;
    }
    EXPECT_NEAR(all, 64.0, 1e-9);
    // Behind the front the box of a particle, as wide as its second moments say, is on one side.
    for (std::size_t p = 0; p < seeds.position.size(); ++p)
    {
      const Vector<2> from = seeds.position[p] - front;
      const double distance = std::fabs(dot(from, n));
      if (dot(from, along) < -reach && distance < reach)
      {
        const double least = 0.25 * std::min(seeds.edge[0], seeds.edge[1]) / std::sqrt(2.0);
        EXPECT_GT(distance, 0.5 * least) << trial; // of the centroid of a part of half a cell
      }
    }
  }
}

TEST(CutsOfMeshes, AKinkedCrackDividesExactlyButForItsKink)
{
  std::mt19937 engine = seededEngine();
  for (int trial = 0; trial < 20; ++trial)
  {
    const double kink = between(engine, 2.0, 4.0), height = between(engine, 2.0, 4.0);
    const double slope = between(engine, -0.4, 0.4), later = between(engine, -0.4, 0.4);
    const Vector<2> at{{kink, height}};
    SeedRules<2> rules;
    rules.cuts = surface::cutsOfMeshes<2>(
        {polyline({{{-1.0, height - slope * (kink + 1.0)}}, at, {{7.0, height + later * (7.0 - kink)}}})});
    const Seeds<2> seeds = seedParticles(boxOf<2>({{6.0, 6.0}}), 1.0, 2, "Plate", rules);
    const auto line = [&](double x) { return height + (x < kink ? slope : later) * (x - kink); };
    const double below = height * 6.0 - 0.5 * slope * kink * kink + 0.5 * later * (6.0 - kink) * (6.0 - kink);
    const auto found = momentsWhere(seeds, [&](const Vector<2>& x) { return x[1] < line(x[0]); }).first;
    // PartOfBox.hpp takes the distance as linear where it is so to 2e-3 of an edge.
    EXPECT_NEAR(found, below, 2e-3 * seeds.edge[0] * seeds.edge[1]) << trial;
  }
}

TEST(CutsOfMeshes, APlaneInABlockDividesItsVolume)
{
  std::mt19937 engine = seededEngine();
  for (int trial = 0; trial < 6; ++trial)
  {
    const Vector<3> upper{{3.0, 2.5, 2.0}};
    Vector<3> n{{between(engine, 0.2, 1.0), between(engine, 0.2, 1.0), between(engine, 0.2, 1.0)}};
    n = (1.0 / norm(n)) * n;
    const double at = between(engine, 0.3, 0.7) * dot(n, upper);
    // Two triangles of a square in the plane, larger than the block.
    Vector<3> a{{n[1], -n[0], 0.0}};
    a = (20.0 / norm(a)) * a;
    const Vector<3> b{{n[1] * a[2] - n[2] * a[1], n[2] * a[0] - n[0] * a[2], n[0] * a[1] - n[1] * a[0]}};
    const Vector<3> middle = (at / dot(n, upper)) * upper;
    CrackMesh<3> mesh;
    mesh.vertices = {middle - a - b, middle + a - b, middle + a + b, middle - a + b};
    mesh.simplices = {{0, 1, 2}, {0, 2, 3}};
    mesh.beyond = {{facet::surfaceBreaking, 1, facet::surfaceBreaking},
                   {facet::surfaceBreaking, facet::surfaceBreaking, 0}};
    SeedRules<3> rules;
    rules.cuts = surface::cutsOfMeshes<3>({mesh});
    const Seeds<3> seeds = seedParticles(boxOf(upper), 0.5, 2, "Block", rules);
    const double below = momentsWhere(seeds, [&](const Vector<3>& x) { return dot(n, x) < at; }).first;
    EXPECT_NEAR(below, volumeBelow(upper, n, at), 1e-6) << trial;
  }
}

TEST(CutsOfMeshes, CellsThatAreHalvedAreCutAtTheirLevel)
{
  SeedRules<2> rules;
  rules.cuts = surface::cutsOfMeshes<2>({polyline({{{-1.0, 2.11}}, {{3.3, 2.11}}}, -1, facet::front)});
  const auto nearFront = [](const Geometry::OrientedBox<2>& cell, int level)
  { return level < 2 && std::fabs(cell.centre[0] - 3.0) < 1.0 && std::fabs(cell.centre[1] - 2.0) < 1.0; };
  rules.isDivided = nearFront;
  const Seeds<2> seeds = seedParticles(boxOf<2>({{6.0, 4.0}}), 1.0, 2, "Plate", rules);
  double above = 0.0, all = 0.0;
  for (std::size_t p = 0; p < seeds.position.size(); ++p)
  {
    all += seeds.volume[p];
    const bool behind = seeds.position[p][0] < 3.0; // whole lattice columns, the front is at 3.3
    above += behind && seeds.position[p][1] > 2.11 ? seeds.volume[p] : 0.0;
  }
  EXPECT_NEAR(all, 24.0, 1e-9);
  EXPECT_NEAR(above, 3.0 * 1.89, 1e-9);
  EXPECT_EQ(*std::max_element(seeds.level.begin(), seeds.level.end()), 2);
}

TEST(CutsOfMeshes, SeparatesWhatTheLineBetweenTwoPointsCrosses)
{
  const Geometry::Cuts<2> cuts = surface::cutsOfMeshes<2>({polyline({{{0.0, 0.0}}, {{1.0, 0.0}}}, -1, -2)});
  const Vector<2> above{{0.5, 0.3}}, below{{0.6, -0.2}}, ahead{{1.4, -0.2}}, other{{1.5, 0.2}};
  EXPECT_TRUE(cuts.separate(above, below));
  EXPECT_FALSE(cuts.separate(ahead, other));
  EXPECT_FALSE(cuts.separate(below, ahead));
  EXPECT_FALSE(surface::cutsOfMeshes<2>({}).ofBox);
}

} // namespace
