#include "base/Numbers.hpp"
#include "cracks/Border.hpp"
#include "cracks/CrackMesh.hpp"
#include "cracks/Triangulation.hpp"
#include "geometry/Cross.hpp"
#include "geometry/Primitives.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Rhegma::cracks
{

namespace
{

/// How far a point may lie off the plane of the others, in cells.
constexpr double flatness = 0.01;

/// Area of the largest polygon, in squares of cells.
constexpr double mostCells = 4e4;

std::string number(std::size_t k) { return std::to_string(k + 1); }

/// A plane with axes of its own; the normal is a x b.
struct OwnPlane
{
  Vector<3> origin, a, b, normal;

  Vector<2> own(const Vector<3>& x) const { return {dot(x - origin, a), dot(x - origin, b)}; }
  Vector<3> space(const Vector<2>& x) const { return origin + x[0] * a + x[1] * b; }
};

std::vector<Vector<3>> readCorners(const Teuchos::ParameterList& list, const std::string& where,
                                   double spacing)
{
  const auto values = list.get<Teuchos::Array<double>>("Points");
  std::vector<Vector<3>> points;
  for (int k = 0; k + 2 < values.size(); k += 3)
    points.push_back({values[k], values[k + 1], values[k + 2]});
  // Who closes the polygon with its first point means the same.
  if (points.size() > 3 && norm(points.front() - points.back()) < 1e-9 * spacing)
    points.pop_back();
  if (points.size() < 3)
    throw std::invalid_argument(where +
                                ": a crack in 3D is a polygon and needs at least three points; it has " +
                                std::to_string(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k)
    if (norm(points[(k + 1) % points.size()] - points[k]) < 1e-6 * spacing)
      throw std::invalid_argument(
          where + ": points " + number(k) + " and " + number((k + 1) % points.size()) +
          " are the same, so an edge of the crack has no length; leave one of them out");
  return points;
}

/// What lies outside of the bodies is cut off later; a unit or an exponent that is wrong would make too many
/// triangles.
void refuseLarge(double area, const std::string& where, double spacing)
{
  const double cells = area / (spacing * spacing);
  if (!(cells <= mostCells))
    throw std::invalid_argument(where + ": the crack covers " + formatReal(cells) +
                                " cells; write its points in metres, not far outside of the body");
}

/// The plane of the polygon; its normal is that from which the points go round anticlockwise (Newell's sum).
OwnPlane planeOf(const std::vector<Vector<3>>& points, const std::string& where, double spacing)
{
  Vector<3> area{0.0, 0.0, 0.0}, middle{0.0, 0.0, 0.0};
  double longest = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    area = area + 0.5 * cross(points[k] - points[0], points[(k + 1) % points.size()] - points[0]);
    middle = middle + (1.0 / double(points.size())) * points[k];
    longest = std::max(longest, norm(points[k] - points[0]));
  }
  if (norm(area) < 1e-6 * longest * longest)
    throw std::invalid_argument(where + ": the polygon has no area; give points that go round one");
  refuseLarge(norm(area), where, spacing);
  OwnPlane plane;
  plane.origin = middle;
  plane.normal = (1.0 / norm(area)) * area;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const double off = std::abs(dot(points[k] - middle, plane.normal));
    if (off > flatness * spacing)
      throw std::invalid_argument(
          where + ": point " + number(k) + " lies " + formatReal(off) +
          " m off the plane of the polygon, which must be flat to a hundredth of a cell; "
          "move it, or give several cracks");
  }
  const Vector<3> along = points[1] - points[0];
  plane.a = along - dot(along, plane.normal) * plane.normal;
  plane.a = (1.0 / norm(plane.a)) * plane.a;
  plane.b = cross(plane.normal, plane.a);
  return plane;
}

/// Cells by which the middle of a piece of border may lie off the outline: a corner of that may have been
/// moved by a third of a cell, round itself, on to the surface of the body (CutTriangles.cpp). A mouth that
/// lies as near has no material ahead of it.
constexpr double cutCorner = 0.15;
constexpr double rounding = 1e-6; ///< the same where none was [cells]

/// The edge of the outline that is nearest to a place and within a distance of it, or -1.
int edgeAt(const std::vector<Vector<2>>& outline, const Vector<2>& x, double reach)
{
  int found = -1;
  for (std::size_t k = 0; k < outline.size(); ++k)
  {
    const Vector<2> along = outline[(k + 1) % outline.size()] - outline[k], from = x - outline[k];
    const double at = std::clamp(dot(from, along) / dot(along, along), 0.0, 1.0);
    if (const double distance = norm(from - at * along); distance < reach)
    {
      reach = distance;
      found = static_cast<int>(k);
    }
  }
  return found;
}

/// Which edges the scene calls fronts; empty where it leaves that open.
std::vector<bool> readFrontEdges(const Teuchos::ParameterList& list, const std::string& where,
                                 std::size_t edges)
{
  if (!list.isParameter("Front Edges"))
    return {};
  std::vector<bool> chosen(edges, false);
  for (const int k : list.get<Teuchos::Array<int>>("Front Edges"))
  {
    if (k < 1 || k > static_cast<int>(edges))
      throw std::invalid_argument(where + ": there is no edge " + std::to_string(k) +
                                  "; the polygon has edges 1 to " + std::to_string(edges) +
                                  ", edge k from point k to the next");
    chosen[k - 1] = true;
  }
  return chosen;
}

/// Triangles over an outline in a plane, cut to the bodies.
CrackMesh<3> meshPlane(const OwnPlane& plane, const std::vector<Vector<2>>& outline, const std::string& where,
                       const KindOfBorder& kindOf, const MaterialPlaces<3>& material, double spacing,
                       double edge)
{
  const Triangulation flat = cutToRegion(triangulate(outline, edge),
                                         [&](const Vector<2>& x) { return material.fills(plane.space(x)); });
  if (flat.triangles.empty())
    throw std::invalid_argument(where + ": " + outsideOfBodies);
  CrackMesh<3> mesh;
  for (const Vector<2>& x : flat.points)
    mesh.vertices.push_back(plane.space(x));
  mesh.simplices = flat.triangles;
  markBorder(mesh, kindOf, material, spacing);
  return mesh;
}

} // namespace

CrackMesh<3> readPolygon(const Teuchos::ParameterList& list, const std::string& where,
                         const MaterialPlaces<3>& material, double spacing, double edge)
{
  const std::vector<Vector<3>> corners = readCorners(list, where + " > Points", spacing);
  const OwnPlane plane = planeOf(corners, where + " > Points", spacing);
  std::vector<Vector<2>> outline;
  outline.reserve(corners.size());
  for (const Vector<3>& x : corners)
    outline.push_back(plane.own(x));
  const std::array<int, 2> crossing = Geometry::crossingEdges(outline);
  if (crossing[0] >= 0)
    throw std::invalid_argument(where + " > Points: the edges that start at points " + number(crossing[0]) +
                                " and " + number(crossing[1]) +
                                " cross or touch; list the points in order around the polygon");
  const std::vector<bool> chosen = readFrontEdges(list, where + " > Front Edges", corners.size());
  const auto kindOf = [&](const Vector<3>& middle)
  {
    const int side = edgeAt(outline, plane.own(middle), cutCorner * spacing);
    if (side < 0 || (!chosen.empty() && !chosen[side]))
      return BorderKind::Mouth;
    const bool isOnIt = edgeAt(outline, plane.own(middle), rounding * spacing) >= 0;
    return chosen.empty() || !isOnIt ? BorderKind::FrontIfMaterialAhead : BorderKind::Front;
  };
  return meshPlane(plane, outline, where + " > Points", kindOf, material, spacing, edge);
}

CrackMesh<3> readDisk(const Teuchos::ParameterList& list, const std::string& where,
                      const MaterialPlaces<3>& material, double spacing, double edge)
{
  const auto vector = [&](const char* name)
  {
    const auto values = list.get<Teuchos::Array<double>>(name);
    return Vector<3>{values[0], values[1], values[2]};
  };
  OwnPlane plane;
  plane.origin = vector("Centre");
  plane.normal = vector("Normal");
  if (!(norm(plane.normal) > 0.0))
    throw std::invalid_argument(where + " > Normal: it has no length; write a direction such as {0, 0, 1}");
  plane.normal = (1.0 / norm(plane.normal)) * plane.normal;
  const double radius = list.get<double>("Radius");
  const double other = list.isParameter("Second Radius") ? list.get<double>("Second Radius") : radius;
  Vector<3> along{0.0, 0.0, 0.0};
  if (list.isParameter("Radius Direction"))
    along = vector("Radius Direction");
  else
  {
    int steepest = 0; // the axis that the normal is furthest from being along
    for (int d = 1; d < 3; ++d)
      steepest = std::abs(plane.normal[d]) < std::abs(plane.normal[steepest]) - 1e-9 ? d : steepest;
    along[steepest] = 1.0;
  }
  along = along - dot(along, plane.normal) * plane.normal;
  if (!(norm(along) > 1e-6))
    throw std::invalid_argument(where + " > Radius Direction: it runs along Normal; write a direction in the "
                                        "plane of the crack");
  plane.a = (1.0 / norm(along)) * along;
  plane.b = cross(plane.normal, plane.a);
  const double pi = std::acos(-1.0), perimeter = pi * (radius + other);
  refuseLarge(pi * radius * other, where + " > Radius", spacing);
  const int corners = std::max(12, static_cast<int>(std::ceil(perimeter / edge)));
  // As large as the ellipse.
  const double stretch = std::sqrt(2.0 * pi / corners / std::sin(2.0 * pi / corners));
  std::vector<Vector<2>> outline;
  for (int k = 0; k < corners; ++k)
  {
    const double angle = 2.0 * pi * k / corners;
    outline.push_back({stretch * radius * std::cos(angle), stretch * other * std::sin(angle)});
  }
  const auto kindOf = [&](const Vector<3>& middle)
  {
    return edgeAt(outline, plane.own(middle), cutCorner * spacing) >= 0 ? BorderKind::FrontIfMaterialAhead
                                                                        : BorderKind::Mouth;
  };
  return meshPlane(plane, outline, where, kindOf, material, spacing, edge);
}

} // namespace Rhegma::cracks
