#include "cracks/Growth.hpp"

#include "base/Numbers.hpp"
#include "cracks/Chains.hpp"
#include "cracks/CrackFrames.hpp"
#include "cracks/CrackGeometry.hpp"
#include "cracks/WayAhead.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace Rhegma::cracks
{

namespace
{

double distanceToSegment(const Vector<2>& x, const Vector<2>& a, const Vector<2>& b)
{
  const Vector<2> corner[2] = {a, b};
  return norm(x - placeOf<2>(corner, footOn(corner, x)));
}

/// Length of a straight way after which it crosses a segment [m]; huge where it does not.
double wayTo(const Vector<2>& a, const Vector<2>& b, const Vector<2>& from, const Vector<2>& direction)
{
  const Vector<2> along = b - a, to = a - from;
  const double across = direction[0] * along[1] - direction[1] * along[0];
  if (across == 0.0)
    return 1e300;
  const double way = (to[0] * along[1] - to[1] * along[0]) / across;
  const double at = (to[0] * direction[1] - to[1] * direction[0]) / across;
  return way > 0.0 && at >= 0.0 && at <= 1.0 ? way : 1e300;
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
  const std::vector<Chain>& chains;
  int own;    ///< the front's crack
  bool first; ///< it lies at the first end of that
  double back;

  /// Calls segment(crack, one end, other end).
  template <class Segment>
  void forEach(const Segment& segment) const
  {
    for (std::size_t c = 0; c < chains.size(); ++c)
    {
      const std::vector<Link>& links = chains[c].links;
      const int segments = static_cast<int>(links.size()) - 1;
      double behind = 0.0;
      for (int k = 0; k < segments; ++k)
      {
        const int s = first ? k : segments - 1 - k;
        const Vector<2>&a = links[s].vertex, &b = links[s + 1].vertex;
        if (static_cast<int>(c) != own || behind > back)
          segment(static_cast<int>(c), a, b);
        behind += norm(b - a);
      }
    }
  }

  /// The one that is nearest to a place.
  Neighbour nearestTo(const Vector<2>& x) const
  {
    Neighbour found;
    forEach(
        [&](int crack, const Vector<2>& a, const Vector<2>& b)
        {
          const double distance = distanceToSegment(x, a, b);
          if (distance < found.distance)
            found = {distance, crack};
        });
    return found;
  }

  /// The one that a straight way meets first, and the length of that way. \param only this crack; -1: all
  Neighbour firstAlong(const Vector<2>& from, const Vector<2>& direction, int only = -1) const
  {
    Neighbour found;
    forEach(
        [&](int crack, const Vector<2>& a, const Vector<2>& b)
        {
          const double way = wayTo(a, b, from, direction);
          if (way < found.distance && (only < 0 || crack == only))
            found = {way, crack};
        });
    return found;
  }
};

/// Forgets the sides of particles ahead of a front: they lie beside the crack that will be there.
void forgetSidesAhead(const State<2>& state, const CrackFront<2>& front, double reach)
{
  const auto position = state.particles.real<2>(fields::position);
  const auto side = state.particles.integer(fields::side);
  const Vector<2> centre = front.position, direction = front.direction;
  const int name = front.crack + 1;
  Kokkos::parallel_for(
      "rhegma::cracks::forgetSidesAhead", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p) {
        const Vector<2> from{{position(p, 0) - centre[0], position(p, 1) - centre[1]}};
        if ((side(p) == name || side(p) == -name) && dot(from, direction) > 0.0 &&
            dot(from, from) < reach * reach)
          side(p) = 0;
      });
}

std::string nameOf(const State<2>& state, const CrackFront<2>& front)
{
  return state.cracks.cracks[front.crack].name + "." + std::to_string(front.number);
}

std::string placeOf(const Vector<2>& x) { return formatReal(x[0]) + ", " + formatReal(x[1]) + " m"; }

/// A front closer than this to another crack has cells that can't tell the two apart [cells], and this far
/// ahead it looks for where it would meet that.
constexpr double tooClose = bandWidth, lookAhead = 2.0 * bandWidth;

/// Cosine of the angle within which a front that lies ahead is in the way: 15 degrees.
constexpr double inTheWay = 0.966;

/// Which crack a front ended on, on its face or at a front of it.
struct Meeting
{
  int front, other;
  bool atFront;
};

/// The nearest front of another crack that lies in the way of a front, less than `reach` ahead, with no crack
/// in between, or -1.
int frontInTheWay(const CrackSet<2>& set, const Obstacles& obstacles, int own, const Vector<2>& direction,
                  double reach)
{
  const CrackFront<2>& front = set.fronts[own];
  int nearest = -1;
  for (std::size_t f = 0; f < set.fronts.size(); ++f)
  {
    const CrackFront<2>& other = set.fronts[f];
    if (other.ended || other.crack == front.crack)
      continue;
    const std::vector<Link>& links = obstacles.chains[other.crack].links;
    const Vector<2> way = (atFirstEnd(set, other) ? links.front() : links.back()).vertex - front.position;
    const double length = norm(way);
    if (length < reach && dot(way, direction) > inTheWay * length &&
        // The crack of the front may be its own end.
        !(obstacles.firstAlong(front.position, (1.0 / length) * way).distance < (1.0 - 1e-9) * length))
    {
      reach = length;
      nearest = static_cast<int>(f);
    }
  }
  return nearest;
}

/// Whether there is material all the way to another crack. What lacks in the last cell is its opening.
bool isSolid(const State<2>& state, const Chain& chain, bool first, FrontAdvance<2> advance,
             const Vector<2>& way)
{
  const CrackFront<2>& front = state.cracks.fronts[advance.front];
  const double length = norm(way);
  advance.nodes[0].direction = (1.0 / length) * way;
  advance.nodes[0].length = length - 1.5 * spacingAt(state, front.position);
  return advance.nodes[0].length <= 0.0 || !findRoom(state, chain, first, front, advance).ends;
}

void lengthen(State<2>& state, Chain& chain, bool first, const FrontAdvance<2>& advance, double length)
{
  CrackFront<2>& front = state.cracks.fronts[advance.front];
  if (dot(advance.nodes[0].direction, front.direction) < 1.0 - 1e-12)
    forgetSidesAhead(state, front, (bandWidth + 4.0) * state.mesh.grid.spacing + length);
  // A piece too short to have a direction is left out.
  if (length > 1e-3 * advance.nodes[0].length)
    chain.links.insert(first ? chain.links.begin() : chain.links.end(),
                       closedLink(front.position + length * advance.nodes[0].direction));
  front.grown = true;
  front.budget.require(advance.nodes[0].toughness * length * state.method.thickness);
}

/// What a front has ended on.
enum class EndedOn
{
  Surface,
  Crack
};

void end(State<2>& state, Chain& chain, bool first, int number, EndedOn on, const std::string& how,
         const Vector<2>& where)
{
  CrackFront<2>& front = state.cracks.fronts[number];
  chain.front[first ? 0 : 1] = false;
  chain.joined[first ? 0 : 1] = on == EndedOn::Crack;
  front.ended = true;
  front.nodes[0].speed = 0.0;
  front.nodes[0].driving = {};
  state.warnings.push_back("the front " + nameOf(state, front) + " " + how + " at time " +
                           formatReal(state.clock.time) + " s at " + placeOf(where));
}

/// Two fronts meet where the one that was in the way is.
void meet(State<2>& state, std::vector<Chain>& chains, FrontAdvance<2> advance, int met)
{
  const CrackFront<2>&front = state.cracks.fronts[advance.front], &tip = state.cracks.fronts[met];
  const bool first = atFirstEnd(state.cracks, front), tipFirst = atFirstEnd(state.cracks, tip);
  Chain &chain = chains[front.crack], &beyond = chains[tip.crack];
  const Vector<2> where = (tipFirst ? beyond.links.front() : beyond.links.back()).vertex;
  const Vector<2> way = where - front.position;
  advance.nodes[0].direction = (1.0 / norm(way)) * way;
  lengthen(state, chain, first, advance, norm(way));
  end(state, chain, first, advance.front, EndedOn::Crack, "met the front " + nameOf(state, tip), where);
  end(state, beyond, tipFirst, met, EndedOn::Crack, "was met by the front " + nameOf(state, front), where);
}

void grow(State<2>& state, std::vector<Chain>& chains, const FrontAdvance<2>& advance,
          std::vector<Meeting>& meetings)
{
  CrackFront<2>& front = state.cracks.fronts[advance.front];
  const double spacing = state.mesh.grid.spacing, reach = lookAhead * spacing;
  const bool first = atFirstEnd(state.cracks, front);
  Chain& chain = chains[front.crack];
  const Outcome outcome = findRoom(state, chain, first, front, advance);
  const Obstacles obstacles{chains, front.crack, first, (bandWidth + 3.0) * spacing};
  const Neighbour across = obstacles.firstAlong(front.position, advance.nodes[0].direction);
  // No further than to the first crack in the way, so that a long increment leaps none.
  const Vector<2> ahead =
      front.position + std::min(outcome.length, across.distance) * advance.nodes[0].direction;
  const Neighbour other = obstacles.nearestTo(ahead);
  const bool isAlone = !(other.distance < tooClose * spacing);
  const int met =
      isAlone ? -1 : frontInTheWay(state.cracks, obstacles, advance.front, advance.nodes[0].direction, reach);
  // The nearest crack is not always the first in the way, but if that is not in the way at all, it is beside.
  const bool isAcross =
      !isAlone && across.distance < reach &&
      obstacles.firstAlong(front.position, advance.nodes[0].direction, other.crack).distance < reach;
  Vector<2> leap = {0.0, 0.0};
  if (met >= 0)
  {
    const CrackFront<2>& tip = state.cracks.fronts[met];
    const std::vector<Link>& links = chains[tip.crack].links;
    leap = (atFirstEnd(state.cracks, tip) ? links.front() : links.back()).vertex - front.position;
  }
  else if (isAcross && across.crack != front.crack)
    leap = across.distance * advance.nodes[0].direction;
  const bool leaps = dot(leap, leap) > 0.0;
  // Where a gap lies before the other crack, that is none that this one can meet.
  if (isAlone || (leaps && !isSolid(state, chain, first, advance, leap)))
  {
    lengthen(state, chain, first, advance, outcome.length);
    if (outcome.ends)
      end(state, chain, first, advance.front, EndedOn::Surface, "reached the surface of its body", ahead);
    return;
  }
  const int obstacle = isAcross ? across.crack : other.crack;
  const std::string& name = state.cracks.cracks[obstacle].name;
  if (met >= 0)
  {
    meetings.push_back({advance.front, state.cracks.fronts[met].crack, true});
    meet(state, chains, advance, met);
    return;
  }
  if (leaps)
  {
    lengthen(state, chain, first, advance, across.distance);
    end(state, chain, first, advance.front, EndedOn::Crack, "joined the crack " + name,
        front.position + leap);
    meetings.push_back({advance.front, obstacle, false});
    return;
  }
  front.nodes[0].stopped = true;
  front.nodes[0].speed = 0.0;
  state.warnings.push_back("the front " + nameOf(state, front) + " halted at time " +
                           formatReal(state.clock.time) + " s at " + placeOf(front.position) +
                           ": the crack " + name +
                           " is less than three cells beside its way, and cells can't tell cracks apart that "
                           "are closer; smaller cells (Domain > Cell Size) let it come nearer");
}

} // namespace

void growCracks(State<2>& state, Junctions& junctions)
{
  CrackSet<2>& set = state.cracks;
  if (set.advances.empty())
    return;
  std::vector<Chain> chains = readChains(set);
  std::vector<bool> first;
  for (const CrackFront<2>& front : set.fronts)
    first.push_back(atFirstEnd(set, front));
  std::vector<Meeting> meetings;
  for (const FrontAdvance<2>& advance : set.advances)
    if (!set.fronts[advance.front].ended) // one that has been met goes no further
      grow(state, chains, advance, meetings);
  set.advances.clear();
  writeChains(set, chains, state.mesh.grid.spacing);
  for (std::size_t f = 0; f < set.fronts.size(); ++f)
    if (set.fronts[f].ended)
    {
      const Crack<2>& crack = set.cracks[set.fronts[f].crack];
      set.fronts[f].vertex = first[f] ? crack.firstVertex : crack.firstVertex + crack.numVertices - 1;
    }
  updateFronts(set);
  for (const Meeting& meeting : meetings)
    if (meeting.atFront)
      junctions.join(state, set.fronts[meeting.front].crack, first[meeting.front], meeting.other);
    else
      junctions.add(state, set.fronts[meeting.front].crack, first[meeting.front], meeting.other);
}

} // namespace Rhegma::cracks
