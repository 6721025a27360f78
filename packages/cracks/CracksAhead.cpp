#include "cracks/CrackGeometry.hpp"
#include "cracks/Encounter.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>

namespace Rhegma::cracks
{

namespace
{

/// Distance to another crack within which cells can't resolve the two cracks, and distance ahead within which
/// the crack that a front would meet is searched [cells].
constexpr double tooClose = bandWidth, searchLength = 2.0 * bandWidth;

/// Cosine of the angle within which a front that lies ahead is in the path: 15 degrees.
constexpr double inThePath = 0.966;

/// Length of a straight path after which it crosses a segment [m]; huge where it does not.
double lengthTo(const Vector<2>& a, const Vector<2>& b, const Vector<2>& from, const Vector<2>& direction)
{
  const Vector<2> along = b - a, to = a - from;
  const double across = direction[0] * along[1] - direction[1] * along[0];
  if (across == 0.0)
    return 1e300;
  const double length = (to[0] * along[1] - to[1] * along[0]) / across;
  const double at = (to[0] * direction[1] - to[1] * direction[0]) / across;
  return length > 0.0 && at >= 0.0 && at <= 1.0 ? length : 1e300;
}

/// A crack and how far it is [m].
struct Neighbour
{
  double distance = 1e300;
  int crack = -1;
};

/// What a front may run into: all other cracks, and its own further back than `back` [m].
struct Obstacles
{
  const std::vector<GrowingCrack<2>>& cracks;
  int own;    ///< the front's crack
  bool first; ///< it lies at the first end of that
  double back;

  /// Calls segment(crack, one end, other end).
  template <class Segment>
  void forEach(const Segment& segment) const
  {
    for (std::size_t c = 0; c < cracks.size(); ++c)
    {
      const surface::GrowingPolyline& line = cracks[c].mesh;
      const int segments = static_cast<int>(line.order().size()) - 1;
      double behind = 0.0;
      for (int k = 0; k < segments; ++k)
      {
        const int s = first ? k : segments - 1 - k;
        const Vector<2>&a = line.vertices[line.order()[s]], &b = line.vertices[line.order()[s + 1]];
        if (static_cast<int>(c) != own || behind > back)
          segment(static_cast<int>(c), a, b);
        behind += norm(b - a);
      }
    }
  }

  /// The obstacle nearest to a point.
  Neighbour nearestTo(const Vector<2>& x) const
  {
    Neighbour found;
    forEach(
        [&](int crack, const Vector<2>& a, const Vector<2>& b)
        {
          const Vector<2> corner[2] = {a, b};
          const double distance = surface::distanceToSimplex(corner, x);
          if (distance < found.distance)
            found = {distance, crack};
        });
    return found;
  }

  /// The obstacle that a straight path crosses first, and the length up to it. \param only this crack; -1:
  /// all
  Neighbour firstAlong(const Vector<2>& from, const Vector<2>& direction, int only = -1) const
  {
    Neighbour found;
    forEach(
        [&](int crack, const Vector<2>& a, const Vector<2>& b)
        {
          const double length = lengthTo(a, b, from, direction);
          if (length < found.distance && (only < 0 || crack == only))
            found = {length, crack};
        });
    return found;
  }
};

/// The present position of a front.
Vector<2> tipOf(const std::vector<GrowingCrack<2>>& cracks, const CrackFront<2>& front, int number)
{
  const GrowingCrack<2>& crack = cracks[front.crack];
  for (std::size_t i = 0; i < crack.numbers.size(); ++i)
    if (crack.numbers[i] == number)
      return crack.mesh.vertices[crack.fronts[i].at(0).vertex];
  return front.position;
}

/// The nearest front of another crack that lies in the path of a front, less than `reach` ahead, with no
/// crack in between, or -1.
int frontInThePath(const CrackSet<2>& set, const Obstacles& obstacles, const AdvancingNode<2>& node,
                   double reach)
{
  int nearest = -1;
  for (std::size_t f = 0; f < set.fronts.size(); ++f)
  {
    const CrackFront<2>& other = set.fronts[f];
    if (other.ended || other.crack == set.fronts[node.front].crack)
      continue;
    const Vector<2> to = tipOf(obstacles.cracks, other, static_cast<int>(f)) - node.path.from;
    const double length = norm(to);
    if (length < reach && dot(to, node.path.direction) > inThePath * length &&
        // The crack of the front may be its own end.
        !(obstacles.firstAlong(node.path.from, (1.0 / length) * to).distance < (1.0 - 1e-9) * length))
    {
      reach = length;
      nearest = static_cast<int>(f);
    }
  }
  return nearest;
}

/// Whether there is material from a crack up to another one. A gap in the last cell is the opening of that
/// crack.
bool isSolid(const State<2>& state, int own, Path<2> path, const Vector<2>& to)
{
  const double length = norm(to);
  path.direction = (1.0 / length) * to;
  path.length = length - 1.5 * path.cell;
  return path.length <= 0.0 || !ligamentsAhead<2>(state, own, {path})[0].ends;
}

} // namespace

template <>
Encounter<2> findEncounter(const State<2>& state, const std::vector<GrowingCrack<2>>& cracks,
                           const AdvancingNode<2>& node)
{
  using Kind = Encounter<2>::Kind;
  const CrackSet<2>& set = state.cracks;
  const int own = set.fronts[node.front].crack;
  const double spacing = state.mesh.grid.spacing, reach = searchLength * spacing;
  const Obstacles obstacles{cracks, own, cracks[own].mesh.isFirst(node.vertex), (bandWidth + 3.0) * spacing};
  const Path<2>& path = node.path;
  const Neighbour across = obstacles.firstAlong(path.from, path.direction);
  // No further than to the first crack in the path, so that a long increment passes none.
  const Neighbour other =
      obstacles.nearestTo(path.from + std::min(node.ligament.length, across.distance) * path.direction);
  if (!(other.distance < tooClose * spacing))
    return {};
  if (const int met = frontInThePath(set, obstacles, node, reach); met >= 0)
  {
    const Vector<2> to = tipOf(cracks, set.fronts[met], met) - path.from;
    // A front cannot reach the other crack across a gap.
    return isSolid(state, own, path, to)
               ? Encounter<2>{Kind::Meets, set.fronts[met].crack, met, norm(to), (1.0 / norm(to)) * to}
               : Encounter<2>{};
  }
  // The nearest crack is not always the first in the path; one that is not in the path at all is next to it.
  const bool isAcross = across.distance < reach &&
                        obstacles.firstAlong(path.from, path.direction, other.crack).distance < reach;
  if (!isAcross || across.crack == own)
    return {Kind::Stops, isAcross ? across.crack : other.crack, -1, 0.0, {}};
  return isSolid(state, own, path, across.distance * path.direction)
             ? Encounter<2>{Kind::Joins, across.crack, -1, across.distance, path.direction}
             : Encounter<2>{};
}

} // namespace Rhegma::cracks
