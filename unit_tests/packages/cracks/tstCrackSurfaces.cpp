#include "CubeScene.hpp"

#include "cracks/Opening.hpp"
#include "cracks/SurfaceFile.hpp"
#include "state/EnergySums.hpp"
#include "geometry/Cross.hpp"
#include "output/CoreRow.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <set>
#include <sstream>

using namespace Rhegma;
using namespace Rhegma::cracks;
using namespace Rhegma::cracks::test;

namespace
{

const double pi = std::acos(-1.0);

SurfaceMesh square()
{
  return {{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {0.0, 1.0, 0.0}}, {{0, 1, 2}, {0, 2, 3}}};
}

double areaOf(const SurfaceMesh& mesh)
{
  double sum = 0.0;
  for (const auto& t : mesh.triangles)
    sum += 0.5 * norm(cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]));
  return sum;
}

std::string asciiStl(const SurfaceMesh& mesh, const std::string& name = "crack")
{
  std::ostringstream text;
  text.precision(17);
  text << "solid " << name << "\n";
  for (const auto& t : mesh.triangles)
  {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const int v : t)
      text << "vertex " << mesh.points[v][0] << " " << mesh.points[v][1] << " " << mesh.points[v][2] << "\n";
    text << "endloop\nendfacet\n";
  }
  return text.str() + "endsolid " + name + "\n";
}

std::string binaryStl(const SurfaceMesh& mesh)
{
  std::string bytes(80, ' ');
  const auto append = [&](const void* data, std::size_t size)
  { bytes.append(static_cast<const char*>(data), size); };
  const std::uint32_t count = static_cast<std::uint32_t>(mesh.triangles.size());
  append(&count, sizeof count);
  for (const auto& t : mesh.triangles)
  {
    float numbers[12] = {};
    for (int i = 0; i < 3; ++i)
      for (int d = 0; d < 3; ++d)
        numbers[3 + 3 * i + d] = static_cast<float>(mesh.points[t[i]][d]);
    append(numbers, sizeof numbers);
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string obj(const SurfaceMesh& mesh)
{
  std::ostringstream text;
  text.precision(17);
  text << "# a crack\n";
  for (const Vector<3>& x : mesh.points)
    text << "v " << x[0] << " " << x[1] << " " << x[2] << "\n";
  for (const auto& t : mesh.triangles)
    text << "f " << t[0] + 1 << "/1/1 " << t[1] + 1 << "//2 " << t[2] + 1 << "\n";
  return text.str();
}

std::string complaint(const std::function<void()>& act)
{
  try
  {
    act();
  }
  catch (const std::invalid_argument& wrong)
  {
    return wrong.what();
  }
  return "";
}

void expectPiece(const std::string& message, const std::string& piece)
{
  EXPECT_NE(message.find(piece), std::string::npos) << "\"" << message << "\" does not say " << piece;
}

/// A cap of a sphere as rings of triangles, wound at random as files may have them.
SurfaceMesh cap(const Vector<3>& centre, double radius, double width, int rings, int sectors)
{
  SurfaceMesh mesh;
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
        mesh.triangles.push_back({at(r, k), at(r, k + 1), at(r + 1, k + 1)}); // the other way round
    }
  return mesh;
}

/// A file that goes with the test.
struct File
{
  std::string path;
  File(const std::string& name, const std::string& bytes)
      : path((std::filesystem::temp_directory_path() / ("rhegma_" + name)).string())
  {
    std::ofstream(path, std::ios::binary) << bytes;
  }
  ~File() { std::filesystem::remove(path); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
};

} // namespace

/// All kinds hold the same triangles, in small letters or capitals, whatever the solid is called, with a mark
/// of UTF-8 or without, binary files in single precision.
TEST(SurfaceFiles, HoldWhatWasWritten)
{
  const SurfaceMesh mesh = square();
  std::string capitals = asciiStl(mesh);
  std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  for (const auto& read :
       {parseStl(asciiStl(mesh)), parseStl(capitals), parseStl(asciiStl(mesh, "Solid")),
        parseStl(asciiStl(mesh, "a vertex, endloop")), parseStl("\xEF\xBB\xBF" + asciiStl(mesh, "vertex")),
        parseStl(binaryStl(mesh)), parseObj(obj(mesh)), parseObj("\xEF\xBB\xBF" + obj(mesh))})
  {
    SurfaceMesh welded = read;
    weld(welded, 1e-6);
    EXPECT_EQ(welded.points.size(), 4u);
    ASSERT_EQ(welded.triangles.size(), 2u);
    orient(welded);
    EXPECT_NEAR(areaOf(welded), 1.0, 1e-7);
  }
  // Faces of more than three corners are cut; negative numbers count back.
  const SurfaceMesh face = parseObj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1\n");
  ASSERT_EQ(face.triangles.size(), 2u);
  EXPECT_NEAR(areaOf(face), 1.0, 1e-15);
}

TEST(SurfaceFiles, AreRefusedInASentence)
{
  const std::string ascii = asciiStl(square()), binary = binaryStl(square());
  expectPiece(complaint([&] { parseStl(ascii.substr(0, ascii.size() / 2)); }), "cut short");
  expectPiece(complaint([&] { parseStl(binary.substr(0, binary.size() - 7)); }), "cut short");
  expectPiece(complaint([&] { parseStl(binary + std::string(50, 'x')); }), "there is room for");
  const std::string solid = "solid" + binary.substr(5);
  expectPiece(complaint([&] { parseStl(solid.substr(0, solid.size() - 7)); }), "it says that it has 2");
  expectPiece(complaint([&] { parseStl(solid + std::string(50, 'x')); }), "there is room for");
  expectPiece(complaint([&] { parseStl(std::string(40, 'x')); }), "cut short");
  expectPiece(complaint([&] { parseStl("solid a\nfacet\nvertex 0 0\nendloop\nendsolid"); }), "triangle 1");
  expectPiece(complaint([&] { parseObj("v 0 0\n"); }), "line 1");
  expectPiece(complaint([&] { parseObj("v 0 0 0\nf 1 2 3\n"); }), "\"2\" that is not there");
  expectPiece(complaint([&] { readSurfaceFile("/no/such/file.stl"); }), "there is no such file");
  expectPiece(complaint([&] { readSurfaceFile("crack.ply"); }), ".stl or .obj");
  const File empty("empty.stl", ""), none("none.obj", "# nothing\n");
  expectPiece(complaint([&] { readSurfaceFile(empty.path); }), "is empty");
  expectPiece(complaint([&] { readSurfaceFile(none.path); }), "no triangle");
}

TEST(SurfaceMeshes, ThatAreNoSheetAreRefused)
{
  SurfaceMesh branch = square();
  branch.points.push_back({0.5, 0.5, 1.0});
  branch.triangles.push_back({0, 2, 4});
  expectPiece(complaint([&] { orient(branch); }), "three triangles");
  SurfaceMesh flat = square();
  flat.points[1] = {0.5, 0.5, 0.0};
  expectPiece(complaint([&] { orient(flat); }), "no area");
  SurfaceMesh pieces = square();
  for (const Vector<3>& x : square().points)
    pieces.points.push_back(x + Vector<3>{5.0, 0.0, 0.0});
  pieces.triangles.push_back({4, 5, 6});
  expectPiece(complaint([&] { orient(pieces); }), "pieces");
  SurfaceMesh ball{{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}},
                   {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
  expectPiece(complaint([&] { orient(ball); }), "closed");
  SurfaceMesh strip; // a Moebius strip of six squares
  for (int k = 0; k < 6; ++k)
    for (const double side : {-0.3, 0.3})
    {
      const double around = 2.0 * pi * k / 6, twist = 0.5 * around;
      strip.points.push_back({(1.0 + side * std::cos(twist)) * std::cos(around),
                              (1.0 + side * std::cos(twist)) * std::sin(around), side * std::sin(twist)});
    }
  for (int k = 0; k < 6; ++k)
  {
    const int a = 2 * k, b = a + 1, c = k < 5 ? a + 2 : 1, d = k < 5 ? a + 3 : 0;
    strip.triangles.push_back({a, b, c});
    strip.triangles.push_back({b, d, c});
  }
  expectPiece(complaint([&] { orient(strip); }), "one side");
}

/// Edges come out between half and one and a half of what is asked for where the input leaves that open; a
/// flat sheet keeps its area to rounding, and one orientation.
TEST(SurfaceMeshes, GetEdgesOfAboutACell)
{
  for (const int input : {1, 40})
  {
    SurfaceMesh mesh;
    for (int i = 0; i <= input; ++i)
      for (int j = 0; j <= input; ++j)
        mesh.points.push_back({double(i) / input, double(j) / input, 0.0});
    const auto at = [&](int i, int j) { return i * (input + 1) + j; };
    for (int i = 0; i < input; ++i)
      for (int j = 0; j < input; ++j)
      {
        mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      }
    orient(mesh);
    const double edge = 0.11;
    remesh(mesh, edge);
    EXPECT_NEAR(areaOf(mesh), 1.0, 1e-12) << input;
    for (const auto& t : mesh.triangles)
    {
      const Vector<3> area =
          cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]);
      EXPECT_GT(area[2], 0.0);
      for (int i = 0; i < 3; ++i)
      {
        const double length = norm(mesh.points[t[(i + 1) % 3]] - mesh.points[t[i]]);
        EXPECT_LT(length, 1.41 * edge) << input;
        EXPECT_GT(length, 0.3 * edge) << input;
      }
    }
  }
}

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
    const std::vector<FrontNode<3>>& frontNodes = cracks.fronts[0].nodes;
    ASSERT_GE(frontNodes.size(), 10u);
    double length = 0.0;
    for (const FrontNode<3>& s : frontNodes)
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
/// so that there are four times as many with each; where fronts do not matter to cells, large ones do.
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

/// A quarter of a disk in the corner of a block: its front nodes at the two mouths run on along these.
TEST(CrackSurfaces, HaveFrontsThatEndAtMouths)
{
  Teuchos::ParameterList scene = blockScene({8e-3, 8e-3, 8e-3});
  Teuchos::ParameterList& crack = scene.sublist("Cracks").sublist("Cut");
  crack.set("Centre", numbers({0.0, 0.0, 4.2e-3}));
  crack.set("Normal", numbers({0.0, 0.0, 1.0}));
  crack.set("Radius", 4e-3);
  const auto run = start<3>(scene);
  const CrackSet<3>& cracks = run->state().cracks;
  ASSERT_EQ(cracks.fronts.size(), 1u);
  const std::vector<FrontNode<3>>& frontNodes = cracks.fronts[0].nodes;
  ASSERT_GE(frontNodes.size(), 5u);
  EXPECT_EQ(frontNodes.back().facet, -1);
  for (std::size_t k = 0; k + 1 < frontNodes.size(); ++k)
    EXPECT_EQ(frontNodes[k].facet, cracks.fronts[0].firstFacet + static_cast<int>(k));
  // The rim goes round against its order of growth: from the x axis to the y axis seen from above.
  EXPECT_NEAR(frontNodes.front().direction[0], 1.0, 1e-6);
  EXPECT_NEAR(frontNodes.back().direction[1], 1.0, 1e-6);
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
  const SurfaceMesh surface = cap(centre, radius, width, 12, 40);
  const File file("cap.stl", binaryStl(surface));
  Teuchos::ParameterList scene = blockScene({12e-3, 12e-3, 12e-3});
  scene.sublist("Cracks").sublist("Cut").set("Surface File", file.path);
  const auto run = start<3>(scene);
  State<3>& state = run->state();
  EXPECT_TRUE(state.cracks.fronts.empty());
  const double off = std::pow(1.4 * cell, 2) / (8.0 * radius) + 1e-3 * cell;
  run->step(1e-9, false);
  const auto side =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.particles.integer(fields::side));
  const auto x =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.particles.real<3>(fields::position));
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
