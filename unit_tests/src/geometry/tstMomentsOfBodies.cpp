#include "Pi.hpp"
#include "ShapeLists.hpp"

#include "geometry/Seeds.hpp"
#include "geometry/Slivers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <set>

using namespace Rhegma;
using namespace ShapeLists;
using Teuchos::ParameterList;

namespace
{

using Rhegma::Test::pi;

/// Volume, centroid and second moments about the centroid.
template <int D>
struct Moments
{
  double volume = 0.0;
  Vector<D> centre{};
  double second[D][D] = {}; ///< [m^(D + 2)]
};

/// Of the particles: their boxes have moments along their own axes only.
template <int D>
Moments<D> momentsOf(const Seeds<D>& seeds)
{
  Moments<D> sum;
  for (std::size_t p = 0; p < seeds.position.size(); ++p)
  {
    sum.volume += seeds.volume[p];
    sum.centre = sum.centre + seeds.volume[p] * seeds.position[p];
  }
  sum.centre = (1.0 / sum.volume) * sum.centre;
  for (std::size_t p = 0; p < seeds.position.size(); ++p)
  {
    const Vector<D> x = seeds.position[p] - sum.centre;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
      {
        double own = 0.0;
        for (int e = 0; e < D; ++e)
          own += seeds.box[p][e] * seeds.box[p][e] / 12.0 * seeds.axes[e][i] * seeds.axes[e][j];
        sum.second[i][j] += seeds.volume[p] * (x[i] * x[j] + own);
      }
  }
  return sum;
}

/// Compares with closed forms to the same relative accuracy; off the diagonal to as much of the polar moment.
/// \param mostSmall fraction of the volume that may be in particles below half a cell of their lattice
/// \param ofEnds how much more a second moment may be off: what a bar lacks at its end counts three times, as
///        (l / 2)^2 is 3 l^2 / 12
template <int D>
void expectMoments(const Seeds<D>& seeds, const Moments<D>& right, double accuracy, const std::string& what,
                   double mostSmall = 0.0, double ofEnds = 1.0)
{
  const Moments<D> found = momentsOf(seeds);
  const double size = std::pow(right.volume, 1.0 / D);
  double polar = 0.0;
  for (int d = 0; d < D; ++d)
    polar += right.second[d][d];
  EXPECT_NEAR(found.volume, right.volume, accuracy * right.volume) << what;
  for (int d = 0; d < D; ++d)
  {
    EXPECT_NEAR(found.centre[d], right.centre[d], accuracy * size) << what;
    for (int e = 0; e < D; ++e)
      EXPECT_NEAR(found.second[d][e], right.second[d][e],
                  ofEnds * accuracy * (d == e ? right.second[d][d] : polar))
          << what << ' ' << d << e;
  }
  double cell = 1.0;
  for (int d = 0; d < D; ++d)
    cell *= seeds.edge[d];
  double small = 0.0; // volume of particles below half a cell
  for (std::size_t p = 0; p < seeds.volume.size(); ++p)
    if (seeds.volume[p] < Geometry::joinedBelow * std::ldexp(cell, -D * seeds.level[p]) * (1.0 - 1e-9))
      small += seeds.volume[p];
  EXPECT_LE(small, mostSmall * right.volume) << what;
}

/// Random numbers; the seed is printed.
class Random
{
public:
  Random()
  {
    const char* const given = std::getenv("RHEGMA_SEED");
    const unsigned seed = given != nullptr ? std::strtoul(given, nullptr, 10) : std::random_device{}();
    std::cout << "seed " << seed << '\n';
    engine_.seed(seed);
  }
  double operator()(double from, double to)
  {
    return std::uniform_real_distribution<double>(from, to)(engine_);
  }

private:
  std::mt19937 engine_;
};

/// Moments of a polygon by Green's theorem.
Moments<2> momentsOfPolygon(const std::vector<Vector<2>>& points)
{
  Moments<2> sum;
  double about[2][2] = {};
  for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++)
  {
    const Vector<2>&a = points[j], &b = points[i];
    const double twice = a[0] * b[1] - a[1] * b[0];
    sum.volume += 0.5 * twice;
    for (int d = 0; d < 2; ++d)
    {
      sum.centre[d] += twice * (a[d] + b[d]) / 6.0;
      for (int e = 0; e < 2; ++e)
        about[d][e] += twice * (2.0 * a[d] * a[e] + a[d] * b[e] + b[d] * a[e] + 2.0 * b[d] * b[e]) / 24.0;
    }
  }
  sum.centre = (1.0 / sum.volume) * sum.centre;
  for (int d = 0; d < 2; ++d)
    for (int e = 0; e < 2; ++e)
      sum.second[d][e] = about[d][e] - sum.volume * sum.centre[d] * sum.centre[e];
  return sum;
}

} // namespace

/// Disks of 4 cells across, or a little more, anywhere.
TEST(MomentsOfBodies, DisksAreExact)
{
  Random random;
  for (int trial = 0; trial < 20; ++trial)
  {
    const double x = random(-1.0, 1.0), y = random(-1.0, 1.0), r = random(2.0, 3.0);
    const int ppc = trial % 2 + 2;
    Moments<2> right{pi * r * r, {{x, y}}, {}};
    right.second[0][0] = right.second[1][1] = 0.25 * pi * r * r * r * r;
    expectMoments(seedParticles(makeShape<2>(ball({x, y}, r)), 1.0, ppc, "Disk"), right, 1e-3,
                  "disk of radius " + std::to_string(r));
  }
}

/// Balls of 4 cells across.
TEST(MomentsOfBodies, BallsAreExact)
{
  Random random;
  for (int trial = 0; trial < 4; ++trial)
  {
    const double x = random(-1.0, 1.0), r = random(2.0, 2.6);
    Moments<3> right{4.0 / 3.0 * pi * r * r * r, {{x, 2.0, -1.0}}, {}};
    for (int d = 0; d < 3; ++d)
      right.second[d][d] = 0.2 * right.volume * r * r;
    expectMoments(seedParticles(makeShape<3>(ball({x, 2.0, -1.0}, r)), 1.0, 2, "Ball"), right, 1e-3,
                  "ball of radius " + std::to_string(r));
  }
}

/// Disks and balls of which a part is in cells that are up to three levels finer, anywhere. All that is not
/// at the edge has the density of the whole, and parts of a whole cell are those of one family.
template <int D>
void divideBalls(int trials)
{
  Random random;
  for (int trial = 0; trial < trials; ++trial)
  {
    const double r = random(2.0, 2.6);
    Vector<D> centre{}, fine{};
    for (int d = 0; d < D; ++d)
    {
      centre[d] = random(-1.0, 1.0);
      fine[d] = centre[d] + random(-r, r) / std::sqrt(double(D));
    }
    const double around = random(0.3, 1.5);
    const int levels = D == 2 ? 3 : 2;
    const IsDivided<D> isDivided = [&](const Geometry::OrientedBox<D>& box, int level)
    {
      const double away = norm(box.centre - fine) - 0.5 * norm(box.edge);
      return level < (away < around ? levels : (away < 2.0 * around ? 1 : 0));
    };
    Moments<D> right{D == 2 ? pi * r * r : 4.0 / 3.0 * pi * r * r * r, centre, {}};
    for (int d = 0; d < D; ++d)
      right.second[d][d] = right.volume * r * r / (D + 2);
    ParameterList list = ball({0.0, 0.0}, r);
    list.set("Centre", Teuchos::Array<double>(centre.c, centre.c + D));
    const Shape<D> shape = makeShape<D>(list);
    const Seeds<D> seeds = seedParticles(shape, 1.0, 2, "Ball", SeedRules<D>{isDivided, {}});
    expectMoments(seeds, right, 1e-3, "ball of radius " + std::to_string(r));
    double cell = 1.0;
    for (int d = 0; d < D; ++d)
      cell *= seeds.edge[d];
    std::set<std::array<int, 3>> names; // family, level, lineage
    int divided = 0, inside = 0;
    for (std::size_t p = 0; p < seeds.position.size(); ++p)
    {
      divided += seeds.level[p] == levels ? 1 : 0;
      EXPECT_TRUE(names.insert({seeds.family[p], seeds.level[p], seeds.lineage[p]}).second) << p;
      const Vector<D> halved = std::ldexp(2.0, -seeds.level[p]) * seeds.edge;
      if (shape.depth(seeds.position[p]) < norm(halved))
        continue;
      ++inside;
      EXPECT_NEAR(seeds.volume[p], std::ldexp(cell, -D * seeds.level[p]), 1e-9 * cell) << p;
    }
    EXPECT_GT(divided, 1 << D);
    EXPECT_GT(inside, 0);
  }
}

TEST(MomentsOfBodies, DividedDisksAreExact) { divideBalls<2>(20); }
TEST(MomentsOfBodies, DividedBallsAreExact) { divideBalls<3>(3); }

/// Boxes of no more than two edges leave some parts along the sharp edges alone.
/// Round bars in any direction: the moments about their axis are V r^2 / 2, across it V (r^2 / 4 + l^2 / 12).
TEST(MomentsOfBodies, TurnedRoundBarsAreExact)
{
  Random random;
  for (int trial = 0; trial < 4; ++trial)
  {
    const Vector<3> from{{random(-1, 1), random(-1, 1), random(-1, 1)}};
    Vector<3> axis{{random(-1, 1), random(-1, 1), random(-1, 1)}};
    axis = (1.0 / norm(axis)) * axis;
    const double r = random(2.0, 2.5), length = random(4.0, 7.0);
    const Vector<3> to = from + length * axis;
    ParameterList list = body("Cylinder");
    list.set("From", numbers({from[0], from[1], from[2]}));
    list.set("To", numbers({to[0], to[1], to[2]}));
    list.set("Radius", r);
    Moments<3> right{pi * r * r * length, 0.5 * (from + to), {}};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        right.second[i][j] = right.volume * ((i == j ? r * r / 4.0 : 0.0) +
                                             axis[i] * axis[j] * (length * length / 12.0 - r * r / 4.0));
    expectMoments(seedParticles(makeShape<3>(list), 1.0, 2, "Bar"), right, 1e-3,
                  "bar along " + std::to_string(axis[0]) + ' ' + std::to_string(axis[1]), 1e-2);
  }
}

/// Boxes of no more than two edges leave tips of sharp corners alone.
/// Triangles and quadrilaterals round a random point, turned, some 4 to 8 cells across.
TEST(MomentsOfBodies, TurnedPolygonsAreExact)
{
  Random random;
  for (int trial = 0; trial < 30; ++trial)
  {
    const int corners = 3 + trial % 3;
    const double turn = random(0.0, 2.0 * pi), x = random(-1.0, 1.0), y = random(-1.0, 1.0);
    std::vector<Vector<2>> points;
    Teuchos::Array<double> values;
    for (int k = 0; k < corners; ++k)
    {
      const double angle = turn + 2.0 * pi * (k + random(-0.15, 0.15)) / corners, r = random(3.0, 4.0);
      points.push_back({{x + r * std::cos(angle), y + r * std::sin(angle)}});
      values.push_back(points.back()[0]);
      values.push_back(points.back()[1]);
    }
    ParameterList list = body("Polygon");
    list.set("Points", values);
    expectMoments(seedParticles(makeShape<2>(list), 1.0, 2, "Polygon"), momentsOfPolygon(points), 1e-3,
                  std::to_string(corners) + " corners, turned by " + std::to_string(turn), 1e-2);
  }
}

/// A box that is turned against the base box of the body is cut from it: what is left is the difference.
TEST(MomentsOfBodies, TurnedCutsAreExact)
{
  Random random;
  for (int trial = 0; trial < 20; ++trial)
  {
    const double x = random(2.5, 3.5), y = random(2.5, 3.5), a = random(1.2, 2.5), b = random(1.2, 2.5);
    const double degrees = random(0.0, 90.0), c = std::cos(degrees * pi / 180),
                 s = std::sin(degrees * pi / 180);
    ParameterList list = box({0.0, 0.0}, {6.0, 6.0});
    ParameterList& hole = list.sublist("Operations").sublist("Hole");
    hole = box({x - 0.5 * a, y - 0.5 * b}, {x + 0.5 * a, y + 0.5 * b});
    hole.set<std::string>("Operation", "Cut");
    hole.set("Rotation", degrees);
    const double area = 36.0 - a * b;
    Moments<2> right{area, {{(108.0 - a * b * x) / area, (108.0 - a * b * y) / area}}, {}};
    const double own[2][2] = {{c * c * a * a + s * s * b * b, c * s * (a * a - b * b)},
                              {c * s * (a * a - b * b), s * s * a * a + c * c * b * b}};
    const double at[2] = {x, y};
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        right.second[i][j] = 36.0 * ((i == j ? 3.0 : 0.0) + 9.0) -
                             a * b * (own[i][j] / 12.0 + at[i] * at[j]) -
                             area * right.centre[i] * right.centre[j];
    expectMoments(seedParticles(makeShape<2>(list), 1.0, 2, "Plate"), right, 1e-3,
                  "hole turned by " + std::to_string(degrees));
  }
}

/// Two boxes that share a face are one body, wherever the face is. Only where the face or the end of a box
/// reaches the surface, up to four times, may some 2e-3 of a particle of 0.25 be lost: 2e-4 of the area of 10
/// at least.
TEST(MomentsOfBodies, AddedPartsJoinWithoutAGap)
{
  Random random;
  for (int trial = 0; trial < 20; ++trial)
  {
    const double at = random(1.0, 3.0), height = random(2.0, 4.0);
    ParameterList list = box({0.0, 0.0}, {at, height});
    list.sublist("Operations").sublist("More") = box({at, 0.0}, {5.0, height});
    list.sublist("Operations").sublist("More").set<std::string>("Operation", "Add");
    Moments<2> right{5.0 * height, {{2.5, 0.5 * height}}, {}};
    right.second[0][0] = right.volume * 25.0 / 12.0;
    right.second[1][1] = right.volume * height * height / 12.0;
    expectMoments(seedParticles(makeShape<2>(list), 1.0, 2, "Beam"), right, 2e-4, std::to_string(at), 0.0,
                  3.0);
  }
}

/// A slot inside one row of lattice cells leaves two pieces of each: no particle lies in the slot.
TEST(MomentsOfBodies, NoParticleLiesInASlot)
{
  Random random;
  for (int trial = 0; trial < 20; ++trial)
  {
    const double from = random(5.01, 5.15), to = random(5.3, 5.49);
    ParameterList list = box({0.0, 0.0}, {10.0, 10.0});
    list.sublist("Operations").sublist("Slot") = box({-1.0, from}, {11.0, to});
    list.sublist("Operations").sublist("Slot").set<std::string>("Operation", "Cut");
    const Seeds<2> seeds = seedParticles(makeShape<2>(list), 1.0, 2, "Plate");
    double area = 0.0;
    for (std::size_t p = 0; p < seeds.volume.size(); ++p)
    {
      area += seeds.volume[p];
      EXPECT_TRUE(seeds.position[p][1] < from || seeds.position[p][1] > to)
          << seeds.position[p][1] << " in " << from << " to " << to;
    }
    EXPECT_NEAR(area, 100.0 - 10.0 * (to - from), 0.01);
  }
}

/// A wall thinner than half a particle, anywhere in its row of the lattice: its particles are not joined
/// along it into boxes longer than two edges, and keep its area.
TEST(MomentsOfBodies, ThinWallsKeepShortParticles)
{
  Random random;
  constexpr double edge = 0.5;
  for (int trial = 0; trial < 20; ++trial)
  {
    const double thin = random(0.02, 0.24), from = 8.5 + random(0.01, 0.24), to = from + thin;
    ParameterList list = box({0.0, 0.0}, {10.0, 10.0});
    ParameterList& hole = list.sublist("Operations").sublist("Hole");
    hole = box({2.0, 3.0}, {from, 9.0});
    hole.set<std::string>("Operation", "Cut");
    ParameterList& outside = list.sublist("Operations").sublist("Outside");
    outside = box({to, -1.0}, {11.0, 11.0});
    outside.set<std::string>("Operation", "Cut");
    const Seeds<2> seeds = seedParticles(makeShape<2>(list), 1.0, 2, "Plate");
    double area = 0.0;
    for (std::size_t p = 0; p < seeds.volume.size(); ++p)
    {
      area += seeds.volume[p];
      for (int d = 0; d < 2; ++d)
        EXPECT_LE(seeds.box[p][d], 2.0 * edge * (1.0 + 1e-5)) << thin << " at " << seeds.position[p][1];
    }
    EXPECT_NEAR(area, 10.0 * to - 6.0 * (from - 2.0), 0.01) << thin;
  }
}
