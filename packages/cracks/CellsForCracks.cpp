#include "cracks/CellsForCracks.hpp"

#include "base/ReadList.hpp"
#include "cracks/CrackLengths.hpp"
#include "cracks/ReadCrack.hpp"
#include "scene/Validation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Rhegma::cracks
{

namespace
{

using Teuchos::ParameterList;

/// How much longer than thick a part next to a crack is that bends as an arm. At a distance s from a front
/// cells grow to a fraction of s anyway, which resolves parts that are thicker.
constexpr double slenderness = 1.5;

/// Whether the crack has what its shape is made of; else the section's check says what is missing.
bool isWhole(const ParameterList& crack)
{
  return crack.isParameter("Points") || crack.isParameter("Surface File") ||
         (crack.isType<double>("Radius") && crack.isParameter("Centre") && crack.isParameter("Normal"));
}

double distanceTo(const CrackLine& line, const Vector<2>& x)
{
  double least = CellNeeds::none;
  for (std::size_t k = 1; k < line.points.size(); ++k)
  {
    const Vector<2> along = line.points[k] - line.points[k - 1], away = x - line.points[k - 1];
    const double at = std::clamp(dot(away, along) / dot(along, along), 0.0, 1.0);
    least = std::min(least, norm(away - at * along));
  }
  return least;
}

/// Distance from a front to the nearest surface in 32 directions; infinite where none is nearer than a
/// length.
double clearOf(const Vector<2>& front, double most, const SceneBodies<2>& bodies)
{
  constexpr int directions = 32;
  double least = most;
  for (int k = 0; k < directions; ++k)
  {
    const double angle = 2.0 * M_PI * k / directions;
    least = std::min(least, bodies.reach(front, {std::cos(angle), std::sin(angle)}, least));
  }
  return least < most ? least : CellNeeds::none;
}

/// Boxes along a crack where the body is narrow next to it: up to other cracks that are nearer than half the
/// length of both, and up to surfaces on both sides, as far as the part is an arm (slenderness) with respect
/// to the nearest end of the crack.
void addNarrow(const CrackLine& line, const std::vector<const CrackLine*>& others,
               const SceneBodies<2>& bodies, std::vector<NarrowGap>& narrow)
{
  constexpr double first = 0.05; // fraction of the length: at the very end of a crack all parts are narrow
  const double last = (1.0 - first) * line.length, longest = 0.5 * line.length / slenderness;
  double at = first * line.length, passed = 0.0; // along the line
  for (std::size_t k = 1; k < line.points.size(); ++k)
  {
    const Vector<2> from = line.points[k - 1];
    const double length = norm(line.points[k] - from);
    const Vector<2> along = (1.0 / length) * (line.points[k] - from);
    while (at <= std::min(passed + length, last))
    {
      const Vector<2> x = from + (at - passed) * along;
      double width = CellNeeds::none;
      for (const CrackLine* other : others)
        if (const double gap = distanceTo(*other, x);
            gap > 0.0 && gap < 0.5 * std::min(line.length, other->length))
          width = std::min(width, gap);
      for (const double side : {1.0, -1.0})
        if (const double arm = bodies.reach(x, side * turned(along), longest);
            std::min(at, line.length - at) > slenderness * arm)
          width = std::min(width, arm);
      const bool isNarrow = width > 0.0 && width < CellNeeds::none;
      if (isNarrow)
        narrow.push_back({{x[0] - width, x[1] - width}, {x[0] + width, x[1] + width}, width});
      at += line.length * std::max(0.005, std::min(isNarrow ? width / line.length : first, first));
    }
    passed += length;
  }
}

/// Distances of fronts to all that is near, and places where cracks are near each other.
void measureNeighbours(const std::vector<CrackLine>& lines, const SceneBodies<2>& bodies, CellNeeds& needs)
{
  std::vector<Geometry::Bounds<2>> bounds;
  for (const CrackLine& line : lines)
  {
    bounds.push_back(Geometry::emptyBounds<2>());
    for (const Vector<2>& x : line.points)
      bounds.back().include(x);
  }
  const Geometry::NearBoxes<2> boxes(bounds);
  for (std::size_t a = 0; a < lines.size(); ++a)
  {
    const CrackLine& line = lines[a];
    const std::vector<int> near = boxes.near(bounds[a], 0.5 * line.length);
    std::vector<const CrackLine*> others;
    for (const int b : near)
      if (b != static_cast<int>(a))
        others.push_back(&lines[b]);
    addNarrow(line, others, bodies, needs.narrow);
    for (const int end : {0, 1})
    {
      if (!line.front[end])
        continue;
      const Vector<2>& front = end == 0 ? line.points.front() : line.points.back();
      double clear = clearOf(front, 0.5 * line.length, bodies);
      for (const CrackLine* other : others)
        clear = std::min(clear, distanceTo(*other, front));
      if (clear < std::min({needs.clear, needs.across, needs.atFronts}))
        needs.shortestAcross = line.name;
      needs.clear = std::min(needs.clear, clear);
    }
  }
}

template <int D>
void reportCellsOf(const ParameterList& scene, CellNeeds& needs, std::vector<SceneError>& errors)
{
  const SceneBodies<D> bodies(scene);
  const ParameterList& cracks = scene.sublist("Cracks");
  if (cracks.get<std::string>("Formulation") == "Corrected Broken Cell")
    needs.equal = true;
  std::vector<CrackLine> lines;
  for (const std::string& name : sublistNames(cracks))
  {
    const ParameterList& crack = cracks.sublist(name);
    if (!isWhole(crack))
      continue;
    const std::string where = "Cracks > " + name;
    const std::string points = where + (crack.isParameter("Points") ? " > Points" : "");
    try
    {
      if (crack.isParameter("Surface File"))
        throw std::domain_error("can't be used with a crack from a file; write Domain > Cell Size");
      CrackLengths found = measureCrack(crack, bodies);
      if (!found.inside)
        errors.push_back({points, outsideOfBodies});
      else if (D == 2)
      {
        found.line.name = where;
        lines.push_back(std::move(found.line));
      }
      if (!(found.ligament < CellNeeds::none))
        continue;
      if (std::min(found.ligament, found.crack) < needs.across)
        needs.shortestAcross = where;
      needs.across = std::min({needs.across, found.ligament, found.crack});
      needs.atFronts = std::min(needs.atFronts, found.crack);
      if (found.ahead < CellNeeds::none)
        needs.ahead = std::min({needs.ahead, found.ahead, found.crack});
      needs.thickness = std::min(needs.thickness, found.thickness);
    }
    catch (const std::invalid_argument& wrong)
    {
      errors.push_back({points, wrong.what()});
    }
  }
  if constexpr (D == 2)
    measureNeighbours(lines, bodies, needs);
}

} // namespace

void reportCells(const ParameterList& scene, CellNeeds& needs, std::vector<SceneError>& errors)
{
  if (dimensionOf(scene) == 2)
    reportCellsOf<2>(scene, needs, errors);
  else
    reportCellsOf<3>(scene, needs, errors);
}

} // namespace Rhegma::cracks
