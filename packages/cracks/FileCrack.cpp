#include "base/Numbers.hpp"
#include "cracks/ReadCrack.hpp"
#include "geometry/Cross.hpp"
#include "geometry/SurfaceFile.hpp"
#include "surface/Border.hpp"
#include "surface/CutTriangles.hpp"
#include "surface/NearestOnSimplex.hpp"
#include "surface/SurfaceMesh.hpp"
#include "surface/Triangulation.hpp"

#include <algorithm>
#include <stdexcept>

namespace Rhegma::cracks
{

namespace
{

using surface::BorderKind;
using surface::SurfaceMesh;

constexpr double mostCells = 4e4; ///< area of the largest surface, in squares of cells
constexpr double welded = 1e-3;   ///< points nearer than that are one [cells]
/// How far off the border the middle of one of its edges may lie, a corner of which may have been moved by a
/// third of a cell on to the surface of the body [cells].
constexpr double onEdge = 0.15;

/// The edges of a single triangle.
std::vector<std::array<Vector<3>, 2>> borderOf(const SurfaceMesh& mesh)
{
  std::vector<std::array<Vector<3>, 2>> border;
  const auto beyond = surface::findNeighbours(mesh.triangles);
  for (std::size_t t = 0; t < beyond.size(); ++t)
    for (int i = 0; i < 3; ++i)
      if (beyond[t][i] < 0)
        border.push_back(
            {mesh.points[mesh.triangles[t][(i + 1) % 3]], mesh.points[mesh.triangles[t][(i + 2) % 3]]});
  return border;
}

void refuseLarge(const SurfaceMesh& mesh, double cell)
{
  double cells = 0.0;
  for (const auto& t : mesh.triangles)
    cells += 0.5 * norm(cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]])) /
             (cell * cell);
  if (!(cells <= mostCells))
    throw std::invalid_argument("the surface covers " + formatReal(cells) +
                                " cells; check that its points are in metres");
}

/// Runs a step of reading; adds the name of the file to its errors.
template <class Step>
void attempt(const std::string& name, const Step& step)
{
  try
  {
    step();
  }
  catch (const std::invalid_argument& wrong)
  {
    throw std::invalid_argument(name + ": " + wrong.what());
  }
}

} // namespace

surface::CrackMesh<3> readSurface(const Teuchos::ParameterList& list, const std::string& where,
                                  const ReadingContext<3>& context, std::vector<std::string>& warnings)
{
  const auto path = list.get<std::string>("Surface File");
  const std::string name = where + " > Surface File";
  SurfaceMesh sheet;
  attempt(name, [&] { sheet = Geometry::readSurfaceFile(path); });
  attempt(name + ": " + path,
          [&]
          {
            refuseLarge(sheet, context.cell);
            surface::weld(sheet, welded * context.cell);
            surface::orient(sheet);
          });
  surface::remesh(sheet, context.edge);
  const auto border = borderOf(sheet);
  const surface::Region<3> isIn = [&](const Vector<3>& x) { return context.bodies.contains(x); };
  surface::cutTriangles(sheet.points, sheet.triangles, isIn);
  if (sheet.triangles.empty())
    throw std::invalid_argument(
        name + ": " + path + ": the crack lies outside of all bodies; check that its points are in metres");
  surface::CrackMesh<3> mesh;
  mesh.vertices = sheet.points;
  mesh.simplices = sheet.triangles;
  const auto kindOf = [&](const Vector<3>& middle)
  {
    const bool own =
        std::any_of(border.begin(), border.end(),
                    [&](const auto& piece) {
                      return surface::distanceToSegment(middle, piece[0], piece[1]) < onEdge * context.cell;
                    });
    return own ? BorderKind::FrontIfMaterialAhead : BorderKind::SurfaceBreaking;
  };
  warnOfLigament(surface::markBorder(mesh, kindOf, isIn, context.front), name, context.front, warnings);
  return mesh;
}

} // namespace Rhegma::cracks
