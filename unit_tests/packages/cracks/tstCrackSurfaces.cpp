#include "CubeScene.hpp"
#include "Pi.hpp"

#include "../../src/surface/StlFileOf.hpp"
#include "cracks/Opening.hpp"
#include "state/EnergySums.hpp"

#include <cmath>

using namespace Rhegma;
using namespace Rhegma::cracks;
using namespace Rhegma::cracks::test;
using namespace Rhegma::surface::test;

namespace
{

using Rhegma::Test::pi;

/// A cap of a sphere as rings of triangles, wound at random as files may have them.
surface::SurfaceMesh cap(const Vector<3>& centre, double radius, double width, int rings, int sectors)
{
  surface::SurfaceMesh mesh;
  mesh.points.push_back(centre + Vector<3>{0.0, 0.0, radius});
  for (int r = 1; r <= rings; ++r)
    for (int k = 0; k < sectors; ++k)
    {
      const double polar = std::asin(width / radius) * r / rings, around = 2.0 * pi * k / sectors;
      mesh.points.push_back(centre + radius * Vector<3>{std::sin(polar) * std::cos(around),
                                                        std::sin(polar) * std::sin(around), std::cos(polar)});
    }
  const auto at = [&](int r, int k) { return r == 0 ? 0 : 1 + (r - 1) * sectors + k % sectors; };
  for (int r = 0; r < rings; ++r)
    for (int k = 0; k < sectors; ++k)
    {
      mesh.triangles.push_back({at(r, k), at(r + 1, k), at(r + 1, k + 1)});
      if (r > 0)
        mesh.triangles.push_back({at(r, k), at(r, k + 1), at(r + 1, k + 1)}); // in the opposite order
    }
  return mesh;
}

} // namespace

/// A disk has the area that its radii say, to the cut, and one closed front; an ellipse the same.
TEST(CrackSurfaces, AreDisksAndEllipses)
{
  for (const double second : {2.4e-3, 1.6e-3})
  {
    Teuchos::ParameterList scene = blockScene({8e-3, 8e-3, 8e-3});
    Teuchos::ParameterList& crack = scene.sublist("Cracks").sublist("Cut");
    crack.set("Centre", numbers({4e-3, 4e-3, 4.2e-3}));
    crack.set("Normal", numbers({0.0, 1.0, 2.0}));
    crack.set("Radius", 2.4e-3);
    crack.set("Second Radius", second);
    const auto run = start<3>(scene);
    const CrackSet<3>& cracks = run->state().cracks;
    ASSERT_EQ(cracks.fronts.size(), 1u);
    EXPECT_NEAR(measureOpening(cracks, 0).size, pi * 2.4e-3 * second, 1e-9 * pi * 2.4e-3 * second);
    const std::vector<FrontNode<3>>& nodes = cracks.fronts[0].nodes;
    ASSERT_GE(nodes.size(), 10u);
    double length = 0.0;
    for (const FrontNode<3>& s : nodes)
    {
      EXPECT_GE(s.facet, 0); // it is closed
      EXPECT_NEAR(dot(s.normal, Vector<3>{0.0, 1.0, 2.0}), std::sqrt(5.0), 1e-12);
      EXPECT_NEAR(dot(s.normal, s.direction), 0.0, 1e-12);
      EXPECT_GT(dot(s.direction, s.position - Vector<3>{4e-3, 4e-3, 4.2e-3}), 0.0);
      length += s.tributaryLength;
    }
    EXPECT_NEAR(length, cracks.fronts[0].length, 1e-12);
  }
}

/// Edges of triangles are as long as the cells that are to be at fronts, but at most those of a second level,
/// so that there are four times as many with each; without refinement at fronts, as long as the coarse cells.
TEST(CrackSurfaces, AreAsFineAsTheCellsAtFronts)
{
  const auto triangles = [](int level, double frontCells)
  {
    Teuchos::ParameterList scene = blockScene({8e-3, 8e-3, 8e-3});
    Teuchos::ParameterList& crack = scene.sublist("Cracks").sublist("Cut");
    crack.set("Centre", numbers({4e-3, 4e-3, 4.2e-3}));
    crack.set("Normal", numbers({0.0, 0.0, 1.0}));
    crack.set("Radius", 2.4e-3);
    if (level > 0)
    {
      scene.sublist("Adaptivity").set("Maximum Level", level);
      scene.sublist("Adaptivity").set("Front Cells", frontCells);
      scene.sublist("Adaptivity").set("Velocity Change", 1.0);
    }
    const auto run = start<3>(scene);
    EXPECT_NEAR(measureOpening(run->state().cracks, 0).size, pi * 5.76e-6, 1e-9 * pi * 5.76e-6);
    return static_cast<double>(run->state().cracks.simplex.extent(0));
  };
  const double one = triangles(1, 3.0), two = triangles(2, 2.0);
  // The disk's area over that of equilateral triangles, more at the rim, where their edges are shorter.
  const double large = pi * 2.4 * 2.4 / (std::sqrt(3.0) / 4.0);
  EXPECT_GT(one, 0.8 * 4.0 * large);
  EXPECT_LT(one, 1.6 * 4.0 * large);
  EXPECT_GT(two, 0.8 * 16.0 * large);
  EXPECT_LT(two, 1.6 * 16.0 * large);
  EXPECT_EQ(triangles(1, 0.0), triangles(0, 0.0));
}

/// A quarter of a disk in the corner of a block: its nodes at the two surfaces run on along these.
TEST(CrackSurfaces, HaveFrontsThatEndAtTheSurface)
{
  Teuchos::ParameterList scene = blockScene({8e-3, 8e-3, 8e-3});
  Teuchos::ParameterList& crack = scene.sublist("Cracks").sublist("Cut");
  crack.set("Centre", numbers({0.0, 0.0, 4.2e-3}));
  crack.set("Normal", numbers({0.0, 0.0, 1.0}));
  crack.set("Radius", 4e-3);
  const auto run = start<3>(scene);
  const CrackSet<3>& cracks = run->state().cracks;
  ASSERT_EQ(cracks.fronts.size(), 1u);
  const std::vector<FrontNode<3>>& nodes = cracks.fronts[0].nodes;
  ASSERT_GE(nodes.size(), 5u);
  EXPECT_EQ(nodes.back().facet, -1);
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k)
    EXPECT_EQ(nodes[k].facet, cracks.fronts[0].firstFacet + static_cast<int>(k));
  // The rim goes round against its order of growth: from the x axis to the y axis seen from above.
  EXPECT_NEAR(nodes.front().direction[0], 1.0, 1e-6);
  EXPECT_NEAR(nodes.back().direction[1], 1.0, 1e-6);
  EXPECT_NEAR(measureOpening(cracks, 0).size, 4e-6 * pi, 0.01 * 4e-6 * pi);
}

/// A spherical cap cuts its neighbourhood into inside and outside: every particle that has a side is on the
/// right one of the sphere, but for those within what the triangles lie off it, h^2 / (8 R) for edges h.
/// Parts that then fly apart from rest are strained nowhere: each side moves as a rigid body, and its own
/// functions reproduce that.
TEST(CrackSurfaces, CutCurvedNeighbourhoodsInTwo)
{
  const Vector<3> centre{6e-3, 6e-3, -4.3e-3};
  const double radius = 1e-2, width = 9.5e-3; // the cap reaches beyond the block all round
  const surface::SurfaceMesh sphere = cap(centre, radius, width, 12, 40);
  const File file("cap.stl", binaryStl(sphere));
  Teuchos::ParameterList scene = blockScene({12e-3, 12e-3, 12e-3});
  scene.sublist("Cracks").sublist("Cut").set("Surface File", file.path);
  const auto run = start<3>(scene);
  State<3>& state = run->state();
  EXPECT_TRUE(state.cracks.fronts.empty());
  const double off = std::pow(1.4 * cell, 2) / (8.0 * radius) + 1e-3 * cell;
  run->step(1e-9, false);
  const auto side = onHost(state.particles.integer(fields::side));
  const auto x = onHost(state.particles.real<3>(fields::position));
  // Which side is outside is up to the file.
  int sided = 0, wrong = 0, outside = 0;
  for (int p = 0; p < state.particles.size(); ++p)
  {
    const double out = norm(Vector<3>{x(p, 0), x(p, 1), x(p, 2)} - centre) - radius;
    if (side(p) != 0 && out > 0.5 * cell)
      outside += side(p);
  }
  ASSERT_NE(outside, 0);
  for (int p = 0; p < state.particles.size(); ++p)
  {
    const double out = norm(Vector<3>{x(p, 0), x(p, 1), x(p, 2)} - centre) - radius;
    if (side(p) == 0 || std::abs(out) < off)
      continue;
    ++sided;
    wrong += (out > 0.0) == (side(p) * outside > 0) ? 0 : 1;
  }
  EXPECT_GT(sided, 1000);
  EXPECT_EQ(wrong, 0);

  setVelocity(state,
              [&](const Vector<3>& at) {
                return Vector<3>{0.0, 0.0, norm(at - centre) > radius ? 10.0 : 0.0};
              });
  for (int k = 0; k < 20; ++k)
    run->step(1.0, false);
  measureEnergy(state);
  EXPECT_GT(measureOpening(state.cracks, 0).largest, 0.9 * 10.0 * state.clock.time);
  EXPECT_LT(state.energy.strain, 1e-3 * state.energy.kinetic);
}
