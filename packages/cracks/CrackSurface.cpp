#include "base/Numbers.hpp"
#include "cracks/Border.hpp"
#include "cracks/CutTriangles.hpp"
#include "cracks/SurfaceFile.hpp"
#include "cracks/Triangulation.hpp"
#include "geometry/Cross.hpp"

#include <algorithm>
#include <stdexcept>

namespace Rhegma::cracks
{

namespace
{

constexpr double mostCells = 4e4; ///< area of the largest surface, in squares of cells
constexpr double welded = 1e-3;   ///< points nearer than that are one [cells]
/// How far off the border the middle of one of its edges may lie, a corner of which may have been moved by a
/// third of a cell on to the surface of the body [cells].
constexpr double onEdge = 0.15;

/// The edges that have one triangle.
std::vector<std::array<Vector<3>, 2>> borderOf(const SurfaceMesh& mesh)
{
  std::vector<std::array<Vector<3>, 2>> border;
  const auto beyond = findNeighbours(mesh.triangles);
  for (std::size_t t = 0; t < beyond.size(); ++t)
    for (int i = 0; i < 3; ++i)
      if (beyond[t][i] < 0)
        border.push_back(
            {mesh.points[mesh.triangles[t][(i + 1) % 3]], mesh.points[mesh.triangles[t][(i + 2) % 3]]});
  return border;
}

double distance(const Vector<3>& x, const std::array<Vector<3>, 2>& edge)
{
  const Vector<3> along = edge[1] - edge[0];
  const double at = std::clamp(dot(x - edge[0], along) / dot(along, along), 0.0, 1.0);
  return norm(x - edge[0] - at * along);
}

void refuseLarge(const SurfaceMesh& mesh, double spacing)
{
  double cells = 0.0;
  for (const auto& t : mesh.triangles)
    cells += 0.5 * norm(cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]])) /
             (spacing * spacing);
  if (!(cells <= mostCells))
    throw std::invalid_argument("the surface covers " + formatReal(cells) +
                                " cells; its points are taken to be in metres, so scale them");
}

} // namespace

CrackMesh<3> readSurface(const Teuchos::ParameterList& list, const std::string& where,
                         const MaterialPlaces<3>& material, double spacing, double edge)
{
  const auto path = list.get<std::string>("Surface File");
  const std::string name = where + " > Surface File";
  SurfaceMesh surface;
  try
  {
    surface = readSurfaceFile(path);
  }
  catch (const std::invalid_argument& wrong)
  {
    throw std::invalid_argument(name + ": " + wrong.what());
  }
  try
  {
    refuseLarge(surface, spacing);
    weld(surface, welded * spacing);
    orient(surface);
  }
  catch (const std::invalid_argument& wrong)
  {
    throw std::invalid_argument(name + ": " + path + ": " + wrong.what());
  }
  remesh(surface, edge);
  const auto border = borderOf(surface);
  cutTriangles<3>(surface.points, surface.triangles, [&](const Vector<3>& x) { return material.fills(x); });
  if (surface.triangles.empty())
    throw std::invalid_argument(
        name + ": " + path + ": the crack lies outside of all bodies; its points are taken to be in metres");
  CrackMesh<3> mesh;
  mesh.vertices = surface.points;
  mesh.simplices = surface.triangles;
  const auto kindOf = [&](const Vector<3>& middle)
  {
    const bool own =
        std::any_of(border.begin(), border.end(),
                    [&](const auto& piece) { return distance(middle, piece) < onEdge * spacing; });
    return own ? BorderKind::FrontIfMaterialAhead : BorderKind::Mouth;
  };
  markBorder(mesh, kindOf, material, spacing);
  return mesh;
}

} // namespace Rhegma::cracks
