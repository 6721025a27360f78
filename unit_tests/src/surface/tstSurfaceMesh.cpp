#include "Pi.hpp"
#include "StlFileOf.hpp"

#include "geometry/Cross.hpp"
#include "geometry/SurfaceFile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <sstream>
#include <stdexcept>

using namespace Rhegma;
using namespace Rhegma::Geometry;
using namespace Rhegma::surface;
using namespace Rhegma::surface::test;

namespace
{

using Rhegma::Test::pi;

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

std::string refusal(const std::function<void()>& act)
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

} // namespace

/// All kinds contain the same triangles, in small letters or capitals, whatever the name of the solid, with a
/// mark of UTF-8 or without, binary files in single precision.
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

TEST(SurfaceFiles, AreRefusedWithAMessage)
{
  const std::string ascii = asciiStl(square()), binary = binaryStl(square());
  expectPiece(refusal([&] { parseStl(ascii.substr(0, ascii.size() / 2)); }), "cut short");
  expectPiece(refusal([&] { parseStl(binary.substr(0, binary.size() - 7)); }), "cut short");
  expectPiece(refusal([&] { parseStl(binary + std::string(50, 'x')); }), "has space for");
  const std::string solid = "solid" + binary.substr(5);
  expectPiece(refusal([&] { parseStl(solid.substr(0, solid.size() - 7)); }), "it says that it has 2");
  expectPiece(refusal([&] { parseStl(solid + std::string(50, 'x')); }), "has space for");
  expectPiece(refusal([&] { parseStl(std::string(40, 'x')); }), "no STL file");
  expectPiece(refusal([&] { parseStl("solid a\nfacet\nvertex 0 0\nendloop\nendsolid"); }), "triangle 1");
  expectPiece(refusal([&] { parseObj("v 0 0\n"); }), "line 1");
  expectPiece(refusal([&] { parseObj("v 0 0 0\nf 1 2 3\n"); }), "\"2\" that is not there");
  expectPiece(refusal([&] { readSurfaceFile("/no/such/file.stl"); }), "there is no such file");
  expectPiece(refusal([&] { readSurfaceFile("crack.ply"); }), ".stl or .obj");
  const File empty("empty.stl", ""), none("none.obj", "# nothing\n");
  expectPiece(refusal([&] { readSurfaceFile(empty.path); }), "is empty");
  expectPiece(refusal([&] { readSurfaceFile(none.path); }), "no triangle");
}

TEST(SurfaceMeshes, ThatAreNoSheetAreRefused)
{
  SurfaceMesh branch = square();
  branch.points.push_back({0.5, 0.5, 1.0});
  branch.triangles.push_back({0, 2, 4});
  expectPiece(refusal([&] { orient(branch); }), "three triangles");
  SurfaceMesh flat = square();
  flat.points[1] = {0.5, 0.5, 0.0};
  expectPiece(refusal([&] { orient(flat); }), "no area");
  SurfaceMesh pieces = square();
  for (const Vector<3>& x : square().points)
    pieces.points.push_back(x + Vector<3>{5.0, 0.0, 0.0});
  pieces.triangles.push_back({4, 5, 6});
  expectPiece(refusal([&] { orient(pieces); }), "pieces");
  SurfaceMesh ball{{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}},
                   {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
  expectPiece(refusal([&] { orient(ball); }), "closed");
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
  expectPiece(refusal([&] { orient(strip); }), "one side");
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
