#include "cracks/CellsForCracks.hpp"

#include "base/ReadList.hpp"
#include "cracks/ReadCrack.hpp"
#include "geometry/Cross.hpp"
#include "geometry/NearBoxes.hpp"
#include "scene/SceneBodies.hpp"
#include "scene/Validation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Rhegma::cracks
{

namespace
{

using Teuchos::ParameterList;

/// Fraction of a crack's length: an end that is nearer to a surface is surface-breaking.
constexpr double breakingDepth = 0.01;

/// Part of a polyline crack that lies in bodies, and which of its ends are fronts.
struct Line
{
  std::string name;
  std::vector<Vector<2>> points;
  bool front[2] = {false, false}; ///< of the first and the last position
  double length = 0.0;
};

/// What is known of one crack.
struct Lengths
{
  Line line{};                        ///< in 2D
  double ligament = CellNeeds::none;  ///< from its fronts to the nearest surface
  double crack = CellNeeds::none;     ///< its (half) length, or radius
  double ahead = CellNeeds::none;     ///< from its fronts along their directions to a surface
  double thickness = CellNeeds::none; ///< as in CellNeeds
  bool inside = false;                ///< whether any of it is in a body

  void front(double depth) { ligament = std::min(ligament, depth); }
};

template <int D>
std::vector<Vector<D>> readPositions(const ParameterList& crack)
{
  const auto& values = crack.get<Teuchos::Array<double>>("Points");
  std::vector<Vector<D>> points(values.size() / D);
  for (std::size_t k = 0; k < points.size(); ++k)
    for (int d = 0; d < D; ++d)
      points[k][d] = values[D * k + d];
  return points;
}

/// The first of two positions if it is in a body, else the point where the segment to the second enters one.
Vector<2> enter(const Vector<2>& from, const Vector<2>& to, const SceneBodies<2>& bodies)
{
  double outside = 0.0, inside = 1.0;
  if (bodies.contain(from))
    return from;
  for (int halving = 0; halving < 50; ++halving)
  {
    const double middle = 0.5 * (outside + inside);
    (bodies.contain(from + middle * (to - from)) ? inside : outside) = middle;
  }
  return from + inside * (to - from);
}

/// How much longer than thick a part next to a crack is that bends as an arm. At a distance s from a front
/// cells grow to a fraction of s anyway, which resolves parts that are thicker.
constexpr double slenderness = 1.5;

Vector<2> turned(const Vector<2>& direction) { return {-direction[1], direction[0]}; }

/// What the body has ahead of a front, and its thickness there. \param direction of the front, of length one
void measureAhead(const Vector<2>& front, const Vector<2>& direction, const SceneBodies<2>& bodies,
                  Lengths& found)
{
  const auto reach = [&](const Vector<2>& to) { return bodies.reach(front, to, 2.0 * bodies.extent()); };
  const double ahead = reach(direction);
  const Vector<2> normal = turned(direction);
  found.ahead = std::min(found.ahead, ahead);
  found.thickness = std::min({found.thickness, 0.5 * (ahead + reach(-1.0 * direction)),
                              0.5 * (reach(normal) + reach(-1.0 * normal))});
}

/// The length of a polyline inside the bodies, its ligament, and what is around it.
Lengths measureLine(const ParameterList& crack, const SceneBodies<2>& bodies)
{
  std::vector<Vector<2>> points = readPositions<2>(crack);
  for (std::size_t k = 1; k < points.size(); ++k)
    if (!(norm(points[k] - points[k - 1]) > 0.0))
      throw std::invalid_argument(samePoints);
  Lengths found;
  constexpr int samples = 400;
  const auto into = [&](const Vector<2>& a, const Vector<2>& b, Vector<2>& first)
  {
    for (int k = 0; k <= samples; ++k)
      if (bodies.contain(a + (double(k) / samples) * (b - a)))
      {
        first = enter(a, a + (double(k) / samples) * (b - a), bodies);
        return true;
      }
    return false;
  };
  for (int end = 0; end < 2; ++end)
  {
    while (points.size() > 1 && !into(points[0], points[1], points[0]))
      points.erase(points.begin());
    std::reverse(points.begin(), points.end());
  }
  found.inside = points.size() > 1;
  if (!found.inside)
    return found;
  double& length = found.line.length;
  for (std::size_t k = 1; k < points.size(); ++k)
    length += norm(points[k] - points[k - 1]);
  const std::string wanted = crack.get<std::string>("Fronts");
  int fronts = 0;
  for (const bool first : {true, false})
  {
    const double depth = bodies.depth(first ? points.front() : points.back());
    if (depth <= breakingDepth * length || wanted == "None" || wanted == (first ? "Last" : "First"))
      continue;
    ++fronts;
    found.line.front[first ? 0 : 1] = true;
    found.front(depth);
    const Vector<2> last = first ? points[0] - points[1] : points.back() - points[points.size() - 2];
    measureAhead(first ? points.front() : points.back(), (1.0 / norm(last)) * last, bodies, found);
  }
  if (fronts > 0)
    found.crack = length / fronts;
  found.line.points = std::move(points);
  return found;
}

/// Part of the depth of a crack that breaks the surface: where its rim is less deep, the nearest surface is
/// the one that it breaks.
constexpr double clearDepth = 0.3;

/// Some positions in order round a crack, of a polygon all corners.
struct Rim
{
  std::vector<Vector<3>> points;
  Vector<3> middle{};
  double radius; ///< the smallest
};

Rim rimOfPolygon(const ParameterList& crack)
{
  Rim rim{readPositions<3>(crack), {}, CellNeeds::none};
  for (const Vector<3>& position : rim.points)
    rim.middle = rim.middle + (1.0 / rim.points.size()) * position;
  for (const Vector<3>& position : rim.points)
    rim.radius = std::min(rim.radius, norm(position - rim.middle));
  if (!(rim.radius > 0.0))
    throw std::invalid_argument("the polygon has no area; write the corners of a polygon with an area");
  return rim;
}

Rim rimOfDisk(const ParameterList& crack)
{
  const double radius = crack.get<double>("Radius");
  const double other = crack.isType<double>("Second Radius") ? crack.get<double>("Second Radius") : radius;
  Rim rim{{}, readVector<3>(crack, "Centre"), std::min(radius, other)};
  const Vector<3> normal = readVector<3>(crack, "Normal");
  if (!(norm(normal) > 0.0))
    throw std::invalid_argument("its Normal has no length; write a direction such as {0, 0, 1}");
  int least = 0; // the axis that the normal is furthest from being along
  for (int d = 1; d < 3; ++d)
    least = std::fabs(normal[d]) < std::fabs(normal[least]) ? d : least;
  Vector<3> along{};
  along[least] = 1.0;
  // Of an ellipse the smaller radius all round: so that samples lie rather inside the ellipse than outside.
  Vector<3> a = cross(normal, along);
  Vector<3> b = cross(normal, a);
  a = (rim.radius / norm(a)) * a;
  b = (rim.radius / norm(b)) * b;
  constexpr int count = 16;
  for (int k = 0; k < count; ++k)
  {
    const double angle = 2.0 * M_PI * k / count;
    rim.points.push_back(rim.middle + std::cos(angle) * a + std::sin(angle) * b);
  }
  return rim;
}

/// The rim and positions between: a front that goes through a body has its corners at the surface or beyond
/// it.
std::vector<Vector<3>> sampled(const Rim& rim)
{
  constexpr int samples = 8;
  std::vector<Vector<3>> all;
  for (std::size_t k = 0; k < rim.points.size(); ++k)
    for (int i = 0; i < samples; ++i)
    {
      const Vector<3>& from = rim.points[k];
      all.push_back(from + (double(i) / samples) * (rim.points[(k + 1) % rim.points.size()] - from));
    }
  return all;
}

/// Distances ahead of a rim that breaks the surface and across it, where it is deep enough. The crack counts
/// as no longer than twice its depth, however far it is drawn outside of the bodies; of one that goes through
/// a plate that is the thickness of the plate.
void measureBreaking(const Rim& rim, const SceneBodies<3>& bodies, Lengths& found)
{
  Vector<3> across{};
  for (std::size_t k = 0; k < rim.points.size(); ++k)
    across = across + cross(rim.points[k] - rim.middle, rim.points[(k + 1) % rim.points.size()] - rim.middle);
  double deepest = 0.0;
  const std::vector<Vector<3>> positions = sampled(rim);
  for (const Vector<3>& x : positions)
    deepest = std::max(deepest, bodies.depth(x));
  for (const Vector<3>& x : positions)
  {
    const double depth = bodies.depth(x);
    if (!(depth > clearDepth * std::min(rim.radius, deepest)))
      continue;
    found.inside = true;
    for (const Vector<3>& to : {x - rim.middle, across, -1.0 * across})
      if (const double size = norm(to); size > 0.0)
        found.front(bodies.reach(x, (1.0 / size) * to, bodies.extent()));
  }
  if (found.inside)
    found.crack = std::min({rim.radius, found.ligament, 2.0 * deepest});
}

Lengths measureRim(const Rim& rim, const SceneBodies<3>& bodies)
{
  Lengths found;
  found.inside = bodies.contain(rim.middle);
  found.crack = rim.radius;
  if (std::any_of(rim.points.begin(), rim.points.end(),
                  [&](const Vector<3>& x) { return !bodies.contain(x); }))
  {
    measureBreaking(rim, bodies, found);
    return found;
  }
  const auto probe = [&](const Vector<3>& position)
  {
    const double depth = bodies.depth(position);
    found.inside = found.inside || depth > 0.0;
    if (depth > breakingDepth * rim.radius)
      found.front(depth);
  };
  for (const Vector<3>& position : rim.points)
    probe(position);
  if (found.ligament < CellNeeds::none)
    return found;
  for (const Vector<3>& position : sampled(rim))
    probe(position);
  found.crack = std::min(rim.radius, found.ligament);
  return found;
}

Lengths measure(const ParameterList& crack, const SceneBodies<2>& bodies)
{
  return measureLine(crack, bodies);
}
Lengths measure(const ParameterList& crack, const SceneBodies<3>& bodies)
{
  return measureRim(crack.isType<double>("Radius") ? rimOfDisk(crack) : rimOfPolygon(crack), bodies);
}

/// Whether the crack has what its shape is made of; else the section's check says what is missing.
bool isWhole(const ParameterList& crack)
{
  return crack.isParameter("Points") || crack.isParameter("Surface File") ||
         (crack.isType<double>("Radius") && crack.isParameter("Centre") && crack.isParameter("Normal"));
}

double distanceTo(const Line& line, const Vector<2>& x)
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
void addNarrow(const Line& line, const std::vector<const Line*>& others, const SceneBodies<2>& bodies,
               std::vector<NarrowGap>& narrow)
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
      for (const Line* other : others)
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
void measureNeighbours(const std::vector<Line>& lines, const SceneBodies<2>& bodies, CellNeeds& needs)
{
  std::vector<Geometry::Bounds<2>> bounds;
  for (const Line& line : lines)
  {
    bounds.push_back(Geometry::emptyBounds<2>());
    for (const Vector<2>& x : line.points)
      bounds.back().include(x);
  }
  const Geometry::NearBoxes<2> boxes(bounds);
  for (std::size_t a = 0; a < lines.size(); ++a)
  {
    const Line& line = lines[a];
    const std::vector<int> near = boxes.near(bounds[a], 0.5 * line.length);
    std::vector<const Line*> others;
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
      for (const Line* other : others)
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
  std::vector<Line> lines;
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
      Lengths found = measure(crack, bodies);
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
