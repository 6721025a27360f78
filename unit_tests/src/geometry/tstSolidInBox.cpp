/// Parts of boxes in closed surfaces: the boxes of any lattice have together the volume and the moments that
/// the surface encloses.

#include "ShapeLists.hpp"
#include "Surfaces.hpp"

#include "geometry/Primitives.hpp"
#include "geometry/Shape.hpp"
#include "geometry/SolidInBox.hpp"

#include <gtest/gtest.h>

using namespace Rhegma;
using namespace Rhegma::Geometry;
using Surfaces::SurfaceMesh;

namespace
{

/// Volume and moments about the origin.
template <int D>
struct Whole
{
  double volume = 0.0;
  Vector<D> first{}, second{};

  void add(double v, const Vector<D>& mean, const Vector<D>& square)
  {
    volume += v;
    first = first + v * mean;
    second = second + v * square;
  }
};

/// Of simplices from the origin to each item: second moments are V / ((D + 1)(D + 2)) (squares + square of
/// the sum).
template <int D>
Whole<D> enclosed(const Simplices<D>& surface)
{
  Whole<D> whole;
  for (int k = 0; k < static_cast<int>(surface.items.size()); ++k)
  {
    Vector<D> corner[D], sum{}, square{};
    surface.corners(k, corner);
    for (const Vector<D>& x : corner)
      sum = sum + x;
    for (int d = 0; d < D; ++d)
    {
      square[d] = sum[d] * sum[d];
      for (const Vector<D>& x : corner)
        square[d] += x[d] * x[d];
    }
    whole.add(dot(corner[0], surface.normalOf(k)) / (D == 2 ? 2.0 : 6.0), (1.0 / (D + 1)) * sum,
              (1.0 / ((D + 1) * (D + 2))) * square);
  }
  return whole;
}

/// Of the parts in boxes that fill the bounds.
template <int D>
Whole<D> ofBoxes(const Solid<D>& solid, const Vector<D>& edge, const Vector<D>& from)
{
  Whole<D> whole;
  long counts[3] = {1, 1, 1}, index[3];
  double box = 1.0;
  for (int d = 0; d < D; ++d)
  {
    counts[d] = 2 + static_cast<long>((solid.bounds().upper[d] - solid.bounds().lower[d]) / edge[d]);
    box *= edge[d];
  }
  for (index[0] = 0; index[0] < counts[0]; ++index[0])
    for (index[1] = 0; index[1] < counts[1]; ++index[1])
      for (index[2] = 0; index[2] < counts[2]; ++index[2])
      {
        Vector<D> low;
        for (int d = 0; d < D; ++d)
          low[d] = solid.bounds().lower[d] + (static_cast<double>(index[d]) - from[d]) * edge[d];
        const BoxPart<D> part = partInSolid(solid, low, low + edge);
        EXPECT_GE(part.fraction, 0.0);
        EXPECT_LE(part.fraction, 1.0);
        Vector<D> mean, square;
        for (int d = 0; d < D; ++d)
        {
          mean[d] = low[d] + (0.5 + part.centroid[d]) * edge[d];
          square[d] = mean[d] * mean[d] + part.variance[d] * edge[d] * edge[d];
        }
        whole.add(part.fraction * box, mean, square);
      }
  return whole;
}

template <int D>
void expectSame(const Whole<D>& found, const Whole<D>& right, const char* name)
{
  constexpr double rounding = 1e-11; // some 10^4 boxes of some 100 items
  EXPECT_NEAR(found.volume, right.volume, rounding * right.volume) << name;
  for (int d = 0; d < D; ++d)
  {
    EXPECT_NEAR(found.first[d], right.first[d], rounding * right.volume) << name << ' ' << d;
    EXPECT_NEAR(found.second[d], right.second[d], rounding * right.volume) << name << ' ' << d;
  }
}

template <int D>
std::shared_ptr<const Solid<D>> solidOf(const std::string& path)
{
  Teuchos::ParameterList list = ShapeLists::body("File");
  list.set("File", path);
  return std::get<FileShape<D>>(makeShape<D>(list).base().primitive).solid;
}

} // namespace

TEST(SolidInBox, BoxesAnywhereHaveTheMomentsOfTheSurface)
{
  std::mt19937 random(Surfaces::seedOf("SolidInBox.BoxesAnywhere"));
  std::uniform_real_distribution<double> unit;
  struct Case
  {
    const char* name;
    SurfaceMesh mesh;
  };
  for (const Case& one :
       {Case{"sphere", Surfaces::sphere(20, 1.0)}, Case{"brick", Surfaces::brick({}, {1.0, 0.6, 0.3})},
        Case{"torus", Surfaces::torus(30, 12, 1.0, 0.4)}, Case{"bracket", Surfaces::bracket(8, 0.25, 0.1)},
        Case{"shell",
             Surfaces::both(Surfaces::sphere(20, 1.0), Surfaces::insideOut(Surfaces::sphere(16, 0.93)))}})
    for (const bool turned : {false, true})
    {
      const surface::test::File file(
          "part.stl", Surfaces::asciiStl(turned ? Surfaces::anywhere(one.mesh, random) : one.mesh));
      const auto solid = solidOf<3>(file.path);
      Vector<3> edge, from;
      for (int d = 0; d < 3; ++d)
      {
        edge[d] = 0.07 + 0.2 * unit(random);
        from[d] = turned ? unit(random) : 0.0; // else the first boxes begin on the surface
      }
      expectSame(ofBoxes(*solid, edge, from), enclosed(solid->surface()), one.name);
    }
}

TEST(SolidInBox, BoxesAnywhereHaveTheMomentsOfTheOutline)
{
  std::mt19937 random(Surfaces::seedOf("SolidInBox.Outline"));
  std::uniform_real_distribution<double> unit;
  for (int repeat = 0; repeat < 5; ++repeat)
  {
    // A star with a triangular hole.
    std::ostringstream text;
    text.precision(17);
    const double turn = 6.0 * unit(random);
    for (int k = 0; k < 18; ++k)
    {
      const double r = k % 2 == 0 ? 1.0 : 0.45 + 0.3 * unit(random), a = turn + 2.0 * Surfaces::pi * k / 18.0;
      text << r * std::cos(a) << ' ' << r * std::sin(a) << '\n';
    }
    text << "\n0.1 0.1\n-0.2 0.05\n0.02 -0.15\n";
    const surface::test::File file("part.txt", text.str());
    const auto solid = solidOf<2>(file.path);
    const Vector<2> edge{0.03 + 0.2 * unit(random), 0.03 + 0.2 * unit(random)};
    expectSame(ofBoxes(*solid, edge, {unit(random), unit(random)}), enclosed(solid->surface()), "star");
  }
}

/// Sides and edges of the box on those of the solid.
TEST(SolidInBox, BoxesOnTheSurfaceAreWholeOrEmpty)
{
  const surface::test::File file("part.stl",
                                 Surfaces::asciiStl(Surfaces::brick({0.1, -0.2, 0.3}, {0.5, 0.4, 0.6})));
  const auto solid = solidOf<3>(file.path);
  const auto fraction = [&](const Vector<3>& low, const Vector<3>& high)
  { return partInSolid(*solid, low, high).fraction; };
  EXPECT_NEAR(fraction({0.1, -0.2, 0.3}, {0.5, 0.4, 0.6}), 1.0, 1e-14);
  EXPECT_NEAR(fraction({0.1, -0.2, 0.3}, {0.2, 0.0, 0.5}), 1.0, 1e-14);
  EXPECT_NEAR(fraction({0.5, -0.2, 0.3}, {0.7, 0.4, 0.6}), 0.0, 1e-14);
  EXPECT_NEAR(fraction({0.5, 0.4, 0.6}, {0.7, 0.5, 0.7}), 0.0, 1e-14);
  EXPECT_NEAR(fraction({-0.1, -0.4, 0.1}, {0.1, -0.2, 0.3}), 0.0, 1e-14);
  EXPECT_NEAR(fraction({0.3, -0.2, 0.3}, {0.7, 0.4, 0.6}), 0.5, 1e-14);
  const BoxPart<3> corner = partInSolid(*solid, Vector<3>{0.4, 0.3, 0.5}, Vector<3>{0.6, 0.5, 0.7});
  EXPECT_NEAR(corner.fraction, 0.125, 1e-14);
  for (int d = 0; d < 3; ++d)
  {
    EXPECT_NEAR(corner.centroid[d], -0.25, 1e-13);
    EXPECT_NEAR(corner.variance[d], 0.25 / 12.0, 1e-13);
  }
}
