#include "ShapeLists.hpp"
#include "Surfaces.hpp"

#include "geometry/Seeds.hpp"
#include "geometry/ShapeFile.hpp"
#include "geometry/SurfacePoints.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

using namespace Rhegma;
using namespace ShapeLists;
using namespace Surfaces;
using Rhegma::surface::test::binaryStl;
using Rhegma::surface::test::File;
using Teuchos::ParameterList;

namespace
{

ParameterList fileShape(const std::string& path)
{
  ParameterList list = body("File");
  list.set("File", path);
  return list;
}

template <int D>
double volumeOf(const Seeds<D>& seeds)
{
  double sum = 0.0;
  for (const double volume : seeds.volume)
    sum += volume;
  return sum;
}

template <int D>
std::string errorOfFile(const ParameterList& list)
{
  try
  {
    makeShape<D>(list);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

/// A regular polygon, counter-clockwise, as lines of a file.
std::string ring(int count, double radius)
{
  std::ostringstream text;
  text.precision(17);
  for (int k = 0; k < count; ++k)
    text << radius * std::cos(2.0 * pi * k / count) << ' ' << radius * std::sin(2.0 * pi * k / count) << '\n';
  return text.str() + "\n";
}

double ringArea(int count, double radius)
{
  return 0.5 * count * radius * radius * std::sin(2.0 * pi / count);
}

} // namespace

/// The volume is that of the triangles but for rounding (of binary files: of 24 bits), in any position: in
/// the file, and by the rotation of the body.
TEST(FileShapes, KeepTheirVolume)
{
  std::mt19937 random(seedOf("FileShapes.KeepTheirVolume"));
  struct Case
  {
    const char* name;
    SurfaceMesh mesh;
    double feature; ///< thinnest width
  };
  for (const Case& one :
       {Case{"sphere", sphere(40, 1.0), 2.0}, Case{"cube", brick({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}), 1.0},
        Case{"torus", torus(60, 30, 1.0, 0.4), 0.8}, Case{"bracket", bracket(8, 0.25, 0.4), 0.4}})
    for (const bool inFile : {true, false})
    {
      const SurfaceMesh placed = inFile ? anywhere(one.mesh, random) : one.mesh;
      const File file("part.stl", inFile ? asciiStl(placed) : binaryStl(placed));
      ParameterList list = fileShape(file.path);
      list.set("Scale", 1e-3);
      if (!inFile)
        list.set("Rotation", 360.0 * std::uniform_real_distribution<double>()(random));
      const auto seeds = seedParticles<3>(makeShape<3>(list), 1e-3 * one.feature / 8.0, 2, "Bodies > Part");
      const double right = 1e-9 * volumeOf(one.mesh);
      EXPECT_NEAR(volumeOf(seeds), right, (inFile ? 1e-10 : 1e-6) * right) << one.name << ' ' << inFile;
    }
}

/// The particles of a cube on cell lines are those of a box, whatever the order of its triangles.
TEST(FileShapes, OfACubeHaveTheParticlesOfABox)
{
  const Vector<3> low{0.1, -0.2, 0.3}, high{0.5, 0.4, 0.6};
  const File file("cube.stl", asciiStl(Surfaces::brick(low, high)));
  const auto right =
      seedParticles<3>(makeShape<3>(ShapeLists::box({0.1, -0.2, 0.3}, {0.5, 0.4, 0.6})), 0.05, 2, "");
  const auto found = seedParticles<3>(makeShape<3>(fileShape(file.path)), 0.05, 2, "");
  ASSERT_EQ(found.position.size(), right.position.size());
  for (std::size_t p = 0; p < right.position.size(); ++p)
  {
    EXPECT_EQ(found.volume[p], right.volume[p]);
    for (int d = 0; d < 3; ++d)
    {
      EXPECT_EQ(found.position[p][d], right.position[p][d]);
      EXPECT_EQ(found.box[p][d], right.box[p][d]);
    }
  }
}

/// A disk with a hole from a file of polygons, at any angle.
TEST(FileShapes, InTwoDimensionsKeepTheirArea)
{
  std::mt19937 random(seedOf("FileShapes.InTwoDimensionsKeepTheirArea"));
  const File file("ring.txt", ring(200, 1.0) + ring(100, 0.6));
  for (int k = 0; k < 5; ++k)
  {
    ParameterList list = fileShape(file.path);
    list.set("Rotation", 360.0 * std::uniform_real_distribution<double>()(random));
    const auto seeds = seedParticles<2>(makeShape<2>(list), 0.4 / 8.0, 2, "Bodies > Ring");
    const double right = ringArea(200, 1.0) - ringArea(100, 0.6);
    EXPECT_NEAR(volumeOf(seeds), right, 1e-3 * right);
  }
}

/// Scale, origin and rotation act one after another: 90 degrees about the origin take x to y.
TEST(FileShapes, AreScaledMovedAndTurned)
{
  const File file("box.stl", binaryStl(Surfaces::brick({0.0, 0.0, 0.0}, {3.0, 2.0, 1.0})));
  ParameterList list = fileShape(file.path);
  list.set("Scale", 0.1);
  list.set("Origin", numbers({1.0, 0.0, -0.5}));
  list.set("Rotation", 90.0);
  list.set("Rotation Centre", numbers({0.0, 0.0, 0.0}));
  const auto shape = makeShape<3>(list);
  const auto bounds = shape.bounds();
  const double lower[] = {-0.2, 1.0, -0.5}, upper[] = {0.0, 1.3, -0.4};
  for (int d = 0; d < 3; ++d)
  {
    EXPECT_NEAR(bounds.lower[d], lower[d], 1e-15);
    EXPECT_NEAR(bounds.upper[d], upper[d], 1e-15);
  }
  EXPECT_TRUE(shape.contains({-0.1, 1.2, -0.45}));
  EXPECT_TRUE(shape.contains({0.0, 1.2, -0.45})); // a point on the surface
  EXPECT_FALSE(shape.contains({1e-6, 1.2, -0.45}));
  EXPECT_NEAR(shape.depth({-0.1, 1.2, -0.48}), 0.02, 1e-15);
}

/// A shape from a file is cut and added as others are.
TEST(FileShapes, TakePartInOperations)
{
  const File file("cube.obj",
                  "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 1 4 3 2\n"
                  "f -4 -3 -2 -1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  ParameterList list = ShapeLists::box({0.0, 0.0, 0.0}, {4.0, 4.0, 4.0});
  ParameterList& hole = list.sublist("Operations").sublist("Hole");
  hole.set("Operation", "Cut");
  hole.set("Shape", "File");
  hole.set("File", file.path);
  hole.set("Scale", 2.0);
  hole.set("Origin", numbers({1.0, 1.0, 1.0}));
  const auto seeds = seedParticles<3>(makeShape<3>(list), 0.5, 2, "");
  EXPECT_NEAR(volumeOf(seeds), 64.0 - 8.0, 1e-9);
}

/// As many points as pieces of the area, which lie on the surface.
TEST(FileShapes, HavePointsAllOverTheirSurface)
{
  const File file("box.stl", binaryStl(Surfaces::brick({0.0, 0.0, 0.0}, {3.0, 2.0, 1.0})));
  const auto shape = makeShape<3>(fileShape(file.path));
  const auto points = Geometry::surfacePoints(shape, 0, 0.1);
  EXPECT_NEAR(static_cast<double>(points.size()), 22.0 / 0.01, 10.0);
  Vector<3> sum{};
  for (const auto& point : points)
  {
    EXPECT_NEAR(shape.depth(point.x), 0.0, 1e-12);
    EXPECT_NEAR(shape.depth(point.x - 0.01 * point.normal), 0.01, 0.01);
    sum = sum + point.normal;
  }
  EXPECT_LT(norm(sum), 0.02 * static_cast<double>(points.size())); // normals of a closed surface cancel
}

TEST(FileShapes, SayWhatIsWrong)
{
  expectWords(errorOfFile<3>(body("File")), {"Bodies > Beam > File: is missing"});
  expectWords(errorOfFile<3>(fileShape("/no/such.stl")),
              {"Bodies > Beam > File: /no/such.stl: there is no such file"});
  expectWords(errorOfFile<3>(fileShape("part.step")), {".stl or .obj"});
  const File text("text.stl",
                  "This is a letter, and not a surface, although it is called one; it has no triangles, but "
                  "it has more than eighty-four letters.");
  expectWords(errorOfFile<3>(fileShape(text.path)), {text.path + ": ", "is no STL file"});
  SurfaceMesh mesh = Surfaces::brick({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0});
  mesh.points[7][1] = std::nan("");
  const File wrong("nan.stl", binaryStl(mesh));
  expectWords(errorOfFile<3>(fileShape(wrong.path)), {"triangle 3", "no number"});
  mesh.points[7][1] = 0.5;
  const File open("open.stl", binaryStl(mesh));
  expectWords(errorOfFile<3>(fileShape(open.path)), {open.path, "not closed"});
  ParameterList list = fileShape(open.path);
  list.set("Scale", 0.0);
  expectWords(errorOfFile<3>(list), {"Scale", "positive"});
}

/// A file that changes is read again.
TEST(FileShapes, FollowTheirFile)
{
  const std::string path = (std::filesystem::temp_directory_path() / "rhegma_changing.stl").string();
  for (const double size : {1.0, 2.0})
  {
    SurfaceMesh mesh = Surfaces::brick({0.0, 0.0, 0.0}, {size, 1.0, 1.0});
    if (size == 2.0)
      mesh = both(mesh, Surfaces::brick({5.0, 0.0, 0.0}, {6.0, 1.0, 1.0})); // another length of the file
    std::ofstream(path, std::ios::binary) << binaryStl(mesh);
    EXPECT_NEAR(Geometry::readSolid<3>(path).solid->volume(), size == 1.0 ? 1.0 : 3.0, 1e-12);
  }
  std::filesystem::remove(path);
}
