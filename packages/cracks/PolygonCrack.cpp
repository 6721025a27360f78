#include "base/Numbers.hpp"
#include "cracks/ReadCrack.hpp"
#include "geometry/Primitives.hpp"
#include "surface/Border.hpp"
#include "surface/PlanarPolygon.hpp"
#include "surface/Triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Rhegma::cracks
{

namespace
{

using surface::BorderKind;
using surface::Plane;

/// How far a point may lie off the plane of the others, in cells.
constexpr double flatness = 0.01;

/// Area of the largest polygon, in squares of cells.
constexpr double mostCells = 4e4;

/// Cells by which the middle of a border edge may lie off the outline: a corner of that may have been moved
/// by a third of a cell, round itself, on to the surface of the body (CutTriangles.cpp). A surface-breaking
/// edge that lies as near has no material ahead of it.
constexpr double cutCorner = 0.15;
constexpr double rounding = 1e-6; ///< the same where no corner was moved [cells]

std::string number(std::size_t k) { return std::to_string(k + 1); }

std::vector<Vector<3>> readCorners(const Teuchos::ParameterList& list, const std::string& where, double cell)
{
  const auto values = list.get<Teuchos::Array<double>>("Points");
  std::vector<Vector<3>> points;
  for (int k = 0; k + 2 < values.size(); k += 3)
    points.push_back({values[k], values[k + 1], values[k + 2]});
  // The first point may be repeated at the end.
  if (points.size() > 3 && norm(points.front() - points.back()) < 1e-9 * cell)
    points.pop_back();
  if (points.size() < 3)
    throw std::invalid_argument(where +
                                ": a crack in 3D is a polygon and needs at least three points; it has " +
                                std::to_string(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k)
    if (norm(points[(k + 1) % points.size()] - points[k]) < 1e-6 * cell)
      throw std::invalid_argument(
          where + ": points " + number(k) + " and " + number((k + 1) % points.size()) +
          " are the same, so an edge of the crack has no length; leave one of them out");
  return points;
}

/// Parts outside of the bodies are cut off later, so a wrong unit or exponent would make too many triangles.
void refuseLarge(double area, const std::string& where, double cell)
{
  const double cells = area / (cell * cell);
  if (!(cells <= mostCells))
    throw std::invalid_argument(where + ": the crack covers " + formatReal(cells) +
                                " cells; write its points in metres, not far outside of the body");
}

/// The plane of the polygon, which must be flat.
Plane readPlane(const std::vector<Vector<3>>& points, const std::string& where, double cell)
{
  double longest = 0.0, area = 0.0;
  for (const Vector<3>& x : points)
    longest = std::max(longest, norm(x - points[0]));
  const Plane plane = surface::planeOf(points, area);
  if (area < 1e-6 * longest * longest)
    throw std::invalid_argument(where +
                                ": the polygon has no area; write the corners of a polygon with an area");
  refuseLarge(area, where, cell);
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const double off = std::abs(dot(points[k] - plane.origin, plane.normal));
    if (off > flatness * cell)
      throw std::invalid_argument(where + ": point " + number(k) + " lies " + formatReal(off) +
                                  " m off the plane of the polygon, which must be plane to a hundredth of a "
                                  "cell; move it, or write several cracks");
  }
  return plane;
}

/// Which edges the scene declares as fronts; empty where it does not say.
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

/// Triangles over an outline in a plane, cut to the bodies. \param chosen which edges of the outline are
/// fronts; empty: those with material ahead
surface::CrackMesh<3> meshPlane(const Plane& plane, const std::vector<Vector<2>>& outline,
                                const std::vector<bool>& chosen, const std::string& where,
                                const ReadingContext<3>& context, std::vector<std::string>& warnings)
{
  const auto isIn = [&](const Vector<3>& x) { return context.bodies.contains(x); };
  const surface::Triangulation flat = surface::cutToRegion(
      surface::triangulate(outline, context.edge), [&](const Vector<2>& x) { return isIn(plane.in3D(x)); });
  if (flat.triangles.empty())
    throw std::invalid_argument(where + ": " + outsideOfBodies);
  surface::CrackMesh<3> mesh;
  for (const Vector<2>& x : flat.points)
    mesh.vertices.push_back(plane.in3D(x));
  mesh.simplices = flat.triangles;
  const auto kindOf = [&](const Vector<3>& middle)
  {
    const Vector<2> x = plane.inPlane(middle);
    const int side = surface::nearestEdge(outline, x, cutCorner * context.cell);
    if (side < 0 || (!chosen.empty() && !chosen[side]))
      return BorderKind::SurfaceBreaking;
    const bool isOnIt = surface::nearestEdge(outline, x, rounding * context.cell) >= 0;
    return chosen.empty() || !isOnIt ? BorderKind::FrontIfMaterialAhead : BorderKind::Front;
  };
  warnOfLigament(surface::markBorder(mesh, kindOf, isIn, context.front), where, context.front, warnings);
  return mesh;
}

} // namespace

void warnOfLigament(const surface::BrokenLigament& broken, const std::string& where, double cell,
                    std::vector<std::string>& warnings)
{
  if (broken.length > 0.0)
    warnings.push_back(
        where + ": less than a cell of material is left ahead of " + readableLength(broken.length) +
        " of the crack's border, as at " + formatReal(broken.middle[0]) + ", " +
        formatReal(broken.middle[1]) + ", " + formatReal(broken.middle[2]) + ", where cells are " +
        readableLength(cell) +
        ", so it is treated as broken through there and no energy release is found; use "
        "smaller cells there (Domain > Cell Size, Adaptivity), or let the crack end at the surface");
}

surface::CrackMesh<3> readPolygon(const Teuchos::ParameterList& list, const std::string& where,
                                  const ReadingContext<3>& context, std::vector<std::string>& warnings)
{
  const std::vector<Vector<3>> corners = readCorners(list, where + " > Points", context.cell);
  const Plane plane = readPlane(corners, where + " > Points", context.cell);
  std::vector<Vector<2>> outline;
  outline.reserve(corners.size());
  for (const Vector<3>& x : corners)
    outline.push_back(plane.inPlane(x));
  const std::array<int, 2> crossing = Geometry::crossingEdges(outline);
  if (crossing[0] >= 0)
    throw std::invalid_argument(where + " > Points: the edges that start at points " + number(crossing[0]) +
                                " and " + number(crossing[1]) +
                                " cross or touch; list the points in order around the polygon");
  const std::vector<bool> chosen = readFrontEdges(list, where + " > Front Edges", corners.size());
  return meshPlane(plane, outline, chosen, where + " > Points", context, warnings);
}

surface::CrackMesh<3> readDisk(const Teuchos::ParameterList& list, const std::string& where,
                               const ReadingContext<3>& context, std::vector<std::string>& warnings)
{
  const auto vector = [&](const char* name)
  {
    const auto values = list.get<Teuchos::Array<double>>(name);
    return Vector<3>{values[0], values[1], values[2]};
  };
  Plane plane;
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
  if (!(norm(along - dot(along, plane.normal) * plane.normal) > 1e-6))
    throw std::invalid_argument(where + " > Radius Direction: it runs along Normal; write a direction in the "
                                        "plane of the crack");
  plane.orientAlong(along);
  const double pi = std::acos(-1.0), perimeter = pi * (radius + other);
  refuseLarge(pi * radius * other, where + " > Radius", context.cell);
  const int corners = std::max(12, static_cast<int>(std::ceil(perimeter / context.edge)));
  return meshPlane(plane, surface::ellipseOutline({radius, other}, corners), {}, where, context, warnings);
}

template <>
surface::CrackMesh<3> readCrack(const Teuchos::ParameterList& list, const std::string& where,
                                const ReadingContext<3>& context, std::vector<std::string>& warnings)
{
  return list.isParameter("Surface File") ? readSurface(list, where, context, warnings)
         : list.isParameter("Radius")     ? readDisk(list, where, context, warnings)
                                          : readPolygon(list, where, context, warnings);
}

} // namespace Rhegma::cracks
