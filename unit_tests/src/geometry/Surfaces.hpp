#pragma once
/// Closed surfaces of triangles for tests, with normals outwards, and their volumes.

#include "../surface/StlFileOf.hpp"
#include "Pi.hpp"

#include "geometry/Cross.hpp"
#include "geometry/Frame.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace Surfaces
{

using Rhegma::Vector;
using Rhegma::Geometry::SurfaceMesh;
using Rhegma::Test::pi;

inline void addTriangle(SurfaceMesh& mesh, const Vector<3>& a, const Vector<3>& b, const Vector<3>& c)
{
  const int first = static_cast<int>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), {a, b, c});
  mesh.triangles.push_back({first, first + 1, first + 2});
}

inline void addQuadrangle(SurfaceMesh& mesh, const Vector<3>& a, const Vector<3>& b, const Vector<3>& c,
                          const Vector<3>& d)
{
  addTriangle(mesh, a, b, c);
  addTriangle(mesh, a, c, d);
}

inline SurfaceMesh brick(const Vector<3>& low, const Vector<3>& high)
{
  SurfaceMesh mesh;
  for (int d = 0; d < 3; ++d)
    for (const bool upper : {false, true})
    {
      const int e = (d + 1) % 3, f = (d + 2) % 3;
      Vector<3> corner[4];
      for (int k = 0; k < 4; ++k)
      {
        corner[k][d] = upper ? high[d] : low[d];
        corner[k][e] = k == 1 || k == 2 ? high[e] : low[e];
        corner[k][f] = k >= 2 ? high[f] : low[f];
      }
      if (upper)
        addQuadrangle(mesh, corner[0], corner[1], corner[2], corner[3]);
      else
        addQuadrangle(mesh, corner[0], corner[3], corner[2], corner[1]);
    }
  return mesh;
}

/// From parallels and meridians. \param count of parallels
inline SurfaceMesh sphere(int count, double radius, const Vector<3>& centre = {})
{
  SurfaceMesh mesh;
  const auto at = [&](int i, int j)
  {
    const double polar = pi * i / count, turn = pi * (j % (2 * count)) / count;
    const double across = i == 0 || i == count ? 0.0 : std::sin(polar);
    return centre + radius * Vector<3>{across * std::cos(turn), across * std::sin(turn), std::cos(polar)};
  };
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < 2 * count; ++j)
    {
      if (i < count - 1)
        addTriangle(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1));
      if (i > 0)
        addTriangle(mesh, at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

/// \param around pieces round its axis \param across round its tube
inline SurfaceMesh torus(int around, int across, double radius, double tube)
{
  SurfaceMesh mesh;
  const auto at = [&](int i, int j)
  {
    const double a = 2.0 * pi * (i % around) / around, b = 2.0 * pi * (j % across) / across;
    const double r = radius + tube * std::cos(b);
    return Vector<3>{r * std::cos(a), r * std::sin(a), tube * std::sin(b)};
  };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j)
      addQuadrangle(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  return mesh;
}

/// An L of three square plates of side 1 and a thickness, with a round hole in each.
inline SurfaceMesh bracket(int perSide, double hole, double thickness)
{
  SurfaceMesh mesh;
  const int all = 4 * perSide;
  const double tiles[3][2] = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}};
  for (const auto& tile : tiles)
  {
    const auto outer = [&](int k, double z)
    {
      const int side = k % all / perSide;
      const double s = static_cast<double>(k % perSide) / perSide;
      const double x = side == 0 ? s : side == 1 ? 1.0 : side == 2 ? 1.0 - s : 0.0;
      const double y = side == 0 ? 0.0 : side == 1 ? s : side == 2 ? 1.0 : 1.0 - s;
      return Vector<3>{tile[0] + x, tile[1] + y, z};
    };
    const auto inner = [&](int k, double z)
    {
      const double turn = 2.0 * pi * (k % all) / all - 0.75 * pi;
      return Vector<3>{tile[0] + 0.5 + hole * std::cos(turn), tile[1] + 0.5 + hole * std::sin(turn), z};
    };
    for (int k = 0; k < all; ++k)
    {
      addQuadrangle(mesh, outer(k, thickness), outer(k + 1, thickness), inner(k + 1, thickness),
                    inner(k, thickness));
      addQuadrangle(mesh, outer(k, 0.0), inner(k, 0.0), inner(k + 1, 0.0), outer(k + 1, 0.0));
      addQuadrangle(mesh, inner(k, 0.0), inner(k, thickness), inner(k + 1, thickness), inner(k + 1, 0.0));
      const Vector<3> middle = 0.5 * (outer(k, 0.0) + outer(k + 1, 0.0));
      const bool common = (middle[0] == 1.0 && middle[1] < 1.0) || (middle[1] == 1.0 && middle[0] < 1.0);
      if (!common)
        addQuadrangle(mesh, outer(k, 0.0), outer(k + 1, 0.0), outer(k + 1, thickness), outer(k, thickness));
    }
  }
  return mesh;
}

inline SurfaceMesh both(SurfaceMesh one, const SurfaceMesh& other)
{
  const int first = static_cast<int>(one.points.size());
  one.points.insert(one.points.end(), other.points.begin(), other.points.end());
  for (const auto& t : other.triangles)
    one.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  return one;
}

inline SurfaceMesh insideOut(SurfaceMesh mesh)
{
  for (auto& t : mesh.triangles)
    std::swap(t[1], t[2]);
  return mesh;
}

inline SurfaceMesh moved(SurfaceMesh mesh, const std::function<Vector<3>(const Vector<3>&)>& motion)
{
  for (Vector<3>& x : mesh.points)
    x = motion(x);
  return mesh;
}

/// Turned about an axis through the origin and moved, both at random.
inline SurfaceMesh anywhere(const SurfaceMesh& mesh, std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const Vector<3> about{unit(random), unit(random), unit(random) + 1.5};
  const Rhegma::Geometry::Frame<3> frame{Rhegma::Geometry::turnedAxes(180.0 * unit(random), about), {}};
  const Vector<3> by{unit(random), unit(random), unit(random)};
  return moved(mesh, [&](const Vector<3>& x) { return frame.toSpace(x) + by; });
}

inline double volumeOf(const SurfaceMesh& mesh)
{
  double sum = 0.0;
  for (const auto& t : mesh.triangles)
    sum += dot(mesh.points[t[0]], Rhegma::cross(mesh.points[t[1]], mesh.points[t[2]])) / 6.0;
  return sum;
}

/// Text with all digits.
inline std::string asciiStl(const SurfaceMesh& mesh)
{
  std::ostringstream text;
  text.precision(17);
  text << "solid part\n";
  for (const auto& t : mesh.triangles)
  {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const int v : t)
      text << "vertex " << mesh.points[v][0] << " " << mesh.points[v][1] << " " << mesh.points[v][2] << "\n";
    text << "endloop\nendfacet\n";
  }
  return text.str() + "endsolid part\n";
}

/// Expects that a message says all of these.
inline void expectWords(const std::string& message, const std::vector<std::string>& words)
{
  for (const std::string& word : words)
    EXPECT_NE(message.find(word), std::string::npos)
        << "\"" << message << "\" does not say \"" << word << '"';
}

/// The seed of a test's random numbers, which it prints; RHEGMA_SEED in the environment repeats one.
inline unsigned seedOf(const char* test)
{
  const char* const given = std::getenv("RHEGMA_SEED");
  const unsigned seed = given != nullptr ? std::atoi(given) : std::random_device()();
  std::cout << test << ": RHEGMA_SEED=" << seed << "\n";
  return seed;
}

} // namespace Surfaces
