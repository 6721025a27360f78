#include "cracks/CrackLengths.hpp"

#include "cracks/ReadCrack.hpp"
#include "geometry/Cross.hpp"
#include "geometry/NearBoxes.hpp"

#include <cmath>
#include <stdexcept>

namespace Rhegma::cracks
{

namespace
{

using Teuchos::ParameterList;

/// Fraction of a crack's length: an end that is nearer to a surface is surface-breaking.
constexpr double breakingDepth = 0.01;

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

/// What the body has ahead of a front, and its thickness there. \param direction of the front, of length one
void measureAhead(const Vector<2>& front, const Vector<2>& direction, const SceneBodies<2>& bodies,
                  CrackLengths& found)
{
  const auto reach = [&](const Vector<2>& to) { return bodies.reach(front, to, 2.0 * bodies.extent()); };
  const double ahead = reach(direction);
  const Vector<2> normal = turned(direction);
  found.ahead = std::min(found.ahead, ahead);
  found.thickness = std::min({found.thickness, 0.5 * (ahead + reach(-1.0 * direction)),
                              0.5 * (reach(normal) + reach(-1.0 * normal))});
}

/// The length of a polyline inside the bodies, its ligament, and what is around it.
CrackLengths measureLine(const ParameterList& crack, const SceneBodies<2>& bodies)
{
  std::vector<Vector<2>> points = readPositions<2>(crack);
  for (std::size_t k = 1; k < points.size(); ++k)
    if (!(norm(points[k] - points[k - 1]) > 0.0))
      throw std::invalid_argument(samePoints);
  CrackLengths found;
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
void measureBreaking(const Rim& rim, const SceneBodies<3>& bodies, CrackLengths& found)
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

CrackLengths measureRim(const Rim& rim, const SceneBodies<3>& bodies)
{
  CrackLengths found;
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

} // namespace

CrackLengths measureCrack(const Teuchos::ParameterList& crack, const SceneBodies<2>& bodies)
{
  return measureLine(crack, bodies);
}
CrackLengths measureCrack(const Teuchos::ParameterList& crack, const SceneBodies<3>& bodies)
{
  return measureRim(crack.isType<double>("Radius") ? rimOfDisk(crack) : rimOfPolygon(crack), bodies);
}

} // namespace Rhegma::cracks
