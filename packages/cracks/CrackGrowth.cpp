#include "cracks/CrackGrowth.hpp"

#include "cracks/CrackGeometry.hpp"
#include "cracks/ForgetSides.hpp"
#include "cracks/FrontSmoothing.hpp"
#include "geometry/Cross.hpp"
#include "state/RecordStop.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace Rhegma::cracks
{

using namespace surface;

namespace
{

/// Lengths in cells.
constexpr double longestPiece = 1.5, shortestPiece = 0.5, rowHeight = 1.0;
/// Largest motion of a front node along its front, as a fraction of its advance: less than a turn that begins
/// a new row.
constexpr double sideways = 0.15;
/// Cosine of the largest angle that counts as straight. Directions of 3D fronts are less accurate.
template <int D>
constexpr double straight = D == 2 ? 1.0 - 1e-12 : 1.0 - 1e-6;
/// Depth [cells] from which on an end of a front is taken back to the surface, and by how much the reach of
/// particles is beyond that.
constexpr double leastInside = 0.5, particleOverhang = 0.2;
/// A piece shorter than this fraction of its advance has no direction.
constexpr double leastPiece = 1e-3;

/// What helps a front that faces next to it have stopped.
constexpr const char* stopAdvice =
    "; cells can't resolve faces that are closer: use smaller cells (Domain > Cell Size)";

template <int D>
std::string nameOf(const State<D>& state, int f)
{
  return frontName(state.cracks, state.cracks.fronts[f]);
}

/// How far a front node moves along its front in addition to its advance, towards the middle of its
/// neighbours [m].
///
/// Neighbours advance one after the other, so that a front is never quite normal to the paths of its nodes.
/// The sideways motion does not average out where one neighbour always advances first.
Vector<3> evening(const GrowingSurface& mesh, const FrontLines<3>& lines, std::size_t k, double length)
{
  const int last = previousPoint(lines, k);
  if (last < 0 || !lines[k].joined)
    return {0.0, 0.0, 0.0};
  const Vector<3>&a = mesh.vertices[lines[last].vertex], &x = mesh.vertices[lines[k].vertex],
        &b = mesh.vertices[lines[nextPoint(lines, k)].vertex];
  const Vector<3> along = cross(lines[k].direction, lines[k].normal);
  const double uneven = std::clamp(0.5 * (norm(b - x) - norm(x - a)), -sideways * length, sideways * length);
  return (dot(along, b - a) < 0.0 ? -uneven : uneven) * along;
}

/// The neighbour of a node on its line, after it or before it.
template <int D>
std::size_t innerOf(const FrontLines<D>& lines, std::size_t k, bool forward)
{
  return forward ? nextPoint(lines, k) : static_cast<std::size_t>(previousPoint(lines, k));
}

} // namespace

template <int D>
bool CrackGrowth<D>::isMirrored(const Vector<D>& x, double cell) const
{
  return std::any_of(mirrors_.begin(), mirrors_.end(),
                     [&](const MirrorPlane& plane) { return isOn(plane, x[plane.axis], cell); });
}

/// Sizes of cells, and lengths smoothed along the front. \return whether the front turns \param longest of
/// the lengths before smoothing [m]
template <int D>
bool CrackGrowth<D>::prepare(const State<D>& state, Advancing& f, double& longest) const
{
  const std::size_t count = f.lines.size();
  f.cells.resize(count);
  f.lands.resize(count, false);
  std::vector<bool> mirrored(count, false);
  bool turns = false;
  for (std::size_t k = 0; k < count; ++k)
  {
    const Vector<D>& x = f.front.nodes[k].position;
    f.cells[k] = spacingAt(state, x);
    mirrored[k] = isMirrored(x, f.cells[k]);
    if (f.lines[k].landed || f.lines[k].stopped)
      f.advances[k].length = 0.0;
    longest = std::max(longest, f.advances[k].length);
    turns = turns ||
            (f.advances[k].length > 0.0 && dot(f.advances[k].direction, f.lines[k].direction) < straight<D>);
  }
  if constexpr (D == 3)
  {
    smoothAlongFront(f.crack.mesh, f.lines, f.front.nodes, f.cells, mirrored, f.advances);
    landOvertaken(state, f);
  }
  return turns;
}

/// Takes ends of a 3D front that would leave the surface of the body back to it, along the front. A surface
/// that curves, or a border of the crack that does not follow it, leads them into the body, where the front
/// would turn round them. The vertex itself is moved first: an edge from where it was to the surface would
/// lie along the front, and as the surface-breaking edge at its end would give the end its direction.
template <int D>
void CrackGrowth<D>::keepOnSurface(const State<D>& state, const Advancing& f,
                                   std::vector<AdvancingNode<D>>& nodes) const
{
  std::vector<Path<D>> paths;
  std::vector<AdvancingNode<D>*> ends;
  for (AdvancingNode<D>& node : nodes)
  {
    const std::size_t k = node.node;
    const int last = previousPoint(f.lines, k);
    const Vector<D>& x = f.front.nodes[k].position;
    const double cell = node.path.cell;
    if (node.ligament.ends || (last >= 0) == f.lines[k].joined || isMirrored(x, cell))
      continue;
    const Vector<D> along = x - f.front.nodes[last >= 0 ? last : nextPoint(f.lines, k)].position;
    paths.push_back({node.to, (1.0 / norm(along)) * along, cell, cell});
    ends.push_back(&node);
  }
  const std::vector<Ligament> ligaments = ligamentsAhead(state, f.front.crack, paths);
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (ligaments[i].ends && ligaments[i].length > leastInside * paths[i].cell)
    {
      ends[i]->aside = (ligaments[i].length - particleOverhang * paths[i].cell) * paths[i].direction;
      ends[i]->to = ends[i]->to + ends[i]->aside;
    }
}

/// Lets pieces at the ends of a 3D front land that the rest of the front has overtaken, one after the other:
/// less than half a cell of material is left ahead of their middle. Their outer node lands then, where its
/// own path or that of the inner node ends, and the inner node, where its own does. They may have no drive
/// left; the J integral of a front that leads out of the body means nothing, and is negative. New faces have
/// the toughness of those behind them.
template <int D>
void CrackGrowth<D>::landOvertaken(const State<D>& state, Advancing& f) const
{
  std::vector<Piece> pieces;
  for (std::size_t k = 0; k < f.lines.size(); ++k)
    if ((previousPoint(f.lines, k) >= 0) != f.lines[k].joined &&
        !isMirrored(f.front.nodes[k].position, f.cells[k]))
      pieces.push_back({k, innerOf(f.lines, k, f.lines[k].joined), f.lines[k].joined});
  for (std::size_t round = 0; round < f.lines.size() && !pieces.empty(); ++round)
    pieces = landPieces(state, f, pieces);
}

/// One round of it. \return the pieces behind those of which both nodes have landed
template <int D>
auto CrackGrowth<D>::landPieces(const State<D>& state, Advancing& f, const std::vector<Piece>& pieces) const
    -> std::vector<Piece>
{
  constexpr double step = 0.01; // advance by which a node that has no drive lands [cells]
  std::vector<Path<D>> paths;   // of the middle of each piece, its outer and its inner node
  for (const auto& [outer, inner, forward] : pieces)
  {
    const Vector<D>&a = f.front.nodes[outer].position, &b = f.front.nodes[inner].position;
    const Vector<D> both = f.advances[outer].direction + f.advances[inner].direction;
    const Vector<D> mean = norm(both) > 0.0 ? (1.0 / norm(both)) * both : f.advances[inner].direction;
    const double cell = f.cells[outer];
    paths.push_back({0.5 * (a + b), mean, step * cell, cell});
    paths.push_back({a, f.advances[outer].direction, step * cell, cell});
    paths.push_back({b, f.advances[inner].direction, step * cell, cell});
  }
  const std::vector<Ligament> ligaments = ligamentsAhead(state, f.front.crack, paths);
  std::vector<Piece> next;
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    const auto& [outer, inner, forward] = pieces[i];
    const bool overtaken = ligaments[3 * i].ends, innerLands = overtaken && ligaments[3 * i + 2].ends;
    if (innerLands || (overtaken && ligaments[3 * i + 1].ends))
      land(f, outer, paths[3 * i].length);
    if (!innerLands)
      continue;
    land(f, inner, paths[3 * i].length);
    const bool goesOn = forward ? f.lines[inner].joined : previousPoint(f.lines, inner) >= 0;
    if (goesOn)
      next.push_back({inner, innerOf(f.lines, inner, forward), forward});
  }
  return next;
}

/// Lets a node reach the surface with an advance of at least a length [m].
template <int D>
void CrackGrowth<D>::land(Advancing& f, std::size_t k, double length) const
{
  if (f.lines[k].landed || f.lines[k].stopped)
    return;
  f.lands[k] = true;
  f.advances[k].length = std::max(f.advances[k].length, length);
  if (f.lines[k].toughness > 0.0)
    f.advances[k].toughness = f.lines[k].toughness;
}

/// Mean advance along a front [m]. The mean of its nodes, and not the sum of new area over the length of the
/// front at each time: where parts of a front have landed, that sum counts the advance of the rest as one of
/// the whole front, and exceeds the largest advance.
template <int D>
double meanAdvance(const CrackFront<D>& front)
{
  double sum = 0.0, along = 0.0;
  for (const FrontNode<D>& node : front.nodes)
  {
    sum += node.tributaryLength * node.advance;
    along += node.tributaryLength;
  }
  return along > 0.0 ? sum / along : 0.0;
}

/// The end point of each advance, limited by the ligament.
template <int D>
std::vector<AdvancingNode<D>> CrackGrowth<D>::findPaths(const State<D>& state, const Advancing& f,
                                                        const FrontAdvance<D>& advance) const
{
  std::vector<AdvancingNode<D>> nodes;
  std::vector<Path<D>> paths;
  for (std::size_t k = 0; k < f.lines.size(); ++k)
  {
    if (!(f.advances[k].length > 0.0))
      continue;
    Path<D> path{f.front.nodes[k].position, f.advances[k].direction, f.advances[k].length, f.cells[k]};
    if constexpr (D == 2)
      path.gap =
          std::max(leastLigament * path.cell, f.crack.mesh.openingBehind(f.lines[k].vertex, path.cell));
    nodes.push_back(
        {f.number, static_cast<int>(k), f.lines[k].vertex, path, {}, {}, advance.nodes[k].length > 0.0});
    paths.push_back(path);
  }
  const std::vector<Ligament> ligaments = ligamentsAhead(state, f.front.crack, paths);
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    AdvancingNode<D>& node = nodes[i];
    node.ligament = ligaments[i];
    node.ligament.ends = node.ligament.ends || f.lands[node.node];
    node.to = node.path.from + ligaments[i].length * node.path.direction;
    if constexpr (D == 3)
      if (!node.ligament.ends)
        node.to = node.to + evening(f.crack.mesh, f.lines, node.node, node.path.length);
  }
  if constexpr (D == 3)
    keepOnSurface(state, f, nodes);
  return nodes;
}

/// Ends the front that another front has met.
template <int D>
void CrackGrowth<D>::endMet(State<D>& state, std::vector<GrowingCrack<D>>& cracks, const Advancing& f,
                            int met)
{
  if constexpr (D == 2)
  {
    CrackFront<D>& front = state.cracks.fronts[met];
    GrowingCrack<D>& crack = cracks[front.crack];
    const std::size_t i = std::find(crack.numbers.begin(), crack.numbers.end(), met) - crack.numbers.begin();
    const int vertex = crack.fronts[i].at(0).vertex;
    crack.mesh.joined[crack.mesh.isFirst(vertex) ? 0 : 1] = true;
    crack.ends[i].vertex = vertex;
    crack.fronts[i].clear();
    front.ended = true;
    recordArrival(state, met, "was met by " + nameOf(state, f.number), crack.mesh.vertices[vertex]);
  }
}

namespace
{

/// Mean radius of what lies between two points of an axisymmetric scene [m]; 1 in others.
template <int D>
double radiusBetween(const State<D>& state, const Vector<D>& from, const Vector<D>& to)
{
  return state.method.axisymmetric ? 0.5 * (from[0] + to[0]) : 1.0;
}

} // namespace

/// Advances one node, or stops it. \return whether it has advanced
template <int D>
bool CrackGrowth<D>::advanceNode(State<D>& state, std::vector<GrowingCrack<D>>& cracks, Advancing& f,
                                 const AdvancingNode<D>& node, std::vector<Meeting>& meetings)
{
  using Kind = typename Encounter<D>::Kind;
  FrontPoint<D>& point = f.lines[node.node];
  const Encounter<D> encounter = findEncounter(state, cracks, node);
  const std::string& other = encounter.crack < 0 ? "" : state.cracks.cracks[encounter.crack].name;
  if (encounter.kind == Kind::Stops)
  {
    // One that only its neighbours take along may advance later.
    if (!node.due)
      return false;
    point.stopped = true;
    recordStop(state, f.front,
               {encounter.crack == f.front.crack ? "less than three cells from faces of its own crack"
                                                 : "less than three cells from crack " + other,
                state.clock.time, node.path.from, f.front.nodes[node.node].driving.release,
                f.advances[node.node].toughness},
               stopAdvice);
    return false;
  }
  const bool joins = encounter.kind != Kind::None;
  const double length = joins ? encounter.length : node.ligament.length;
  const Vector<D> to = joins ? node.path.from + length * encounter.direction : node.to;
  const bool first = [&]
  {
    if constexpr (D == 2)
      return f.crack.mesh.isFirst(point.vertex);
    return false;
  }();
  point.toughness = f.advances[node.node].toughness;
  if (length > leastPiece * f.advances[node.node].length)
  {
    double more = 0.0;
    if constexpr (D == 3)
      if (norm(node.aside) > 0.0)
        more += f.crack.mesh.shift(point.vertex, node.aside);
    more += f.crack.mesh.advance(f.lines, node.node, to, D == 2 ? length : rowHeight * f.cells[node.node]);
    f.area += more;
    more *= radiusBetween(state, node.path.from, to);
    f.swept += more;
    f.energy += point.toughness * more * state.method.thickness;
    FrontNode<D>& own = f.front.nodes[node.node];
    own.advance += length;
    f.front.extension.largest = std::max(f.front.extension.largest, own.advance);
  }
  point.landed = joins || node.ligament.ends;
  if (!point.landed)
    return true;
  f.landed = node.node;
  f.end.vertex = point.vertex;
  if constexpr (D == 2)
    f.crack.mesh.joined[first ? 0 : 1] = joins;
  recordArrival(state, f.number,
                encounter.kind == Kind::Meets   ? "met " + nameOf(state, encounter.front)
                : encounter.kind == Kind::Joins ? "joined crack " + other
                                                : "reached the surface of its body",
                to);
  if (encounter.kind == Kind::Meets)
    endMet(state, cracks, f, encounter.front);
  if (joins)
    meetings.push_back({f.front.crack, first, encounter.crack, encounter.kind == Kind::Meets});
  return true;
}

/// Splits long pieces of a front and removes short ones.
template <int D>
void CrackGrowth<D>::evenPieces(Advancing& f)
{
  int names = 0; // no new node may have the name of a node that is removed now, whose history is another
  for (const FrontPoint<D>& point : f.lines)
    names = std::max(names, point.name + 1);
  cutLanded(f.lines);
  if constexpr (D == 3)
  {
    GrowingSurface& mesh = f.crack.mesh;
    const double cell = *std::min_element(f.cells.begin(), f.cells.end());
    for (std::size_t k = 0; k < f.lines.size(); ++k)
      if (f.lines[k].joined && mesh.pieceAt(f.lines, k) > longestPiece * cell)
        mesh.split(f.lines, k, names++);
    for (std::size_t k = 0; k < f.lines.size(); ++k)
      if (f.lines[k].joined && mesh.pieceAt(f.lines, k) < shortestPiece * cell)
      {
        const double toughness = meanToughness(f.lines[k], f.lines[nextPoint(f.lines, k)]);
        double added = 0.0;
        if (mesh.collapse(f.lines, k, added))
        {
          f.energy += toughness * added;
          f.area += added;
          f.swept += added;
        }
      }
  }
}

template <int D>
void CrackGrowth<D>::growFront(State<D>& state, std::vector<GrowingCrack<D>>& cracks,
                               const FrontAdvance<D>& advance, std::vector<Meeting>& meetings)
{
  CrackFront<D>& front = state.cracks.fronts[advance.front];
  GrowingCrack<D>& crack = cracks[front.crack];
  const std::size_t i =
      std::find(crack.numbers.begin(), crack.numbers.end(), advance.front) - crack.numbers.begin();
  Advancing f{advance.front, front, crack, crack.fronts[i], crack.ends[i], advance.nodes, {}, {}};
  double longest = 0.0;
  const bool turns = prepare(state, f, longest);
  bool moves = false;
  for (const AdvancingNode<D>& node : findPaths(state, f, advance))
  {
    const double before = f.area;
    moves = advanceNode(state, cracks, f, node, meetings) || moves;
    longest = std::max(longest, D == 2 ? f.area - before : 0.0);
  }
  if (moves && turns)
    forgetSidesAhead(state, front, (bandWidth + 4.0) * state.mesh.grid.spacing + longest);
  front.grown = front.grown || moves;
  if (f.area > 0.0 && f.energy > 0.0)
    lastToughness_[f.number] = f.energy / (f.swept * state.method.thickness);
  front.extension.mean = std::max(front.extension.mean, meanAdvance(front));
  evenPieces(f);
  front.extension.area += f.swept;
  front.budget.require(f.energy);
  front.ended = f.lines.empty();
}

template <int D>
std::vector<Meeting> CrackGrowth<D>::grow(State<D>& state)
{
  CrackSet<D>& set = state.cracks;
  std::vector<Meeting> meetings;
  if (set.advances.empty())
    return meetings;
  lastToughness_.resize(set.fronts.size(), 0.0);
  std::vector<GrowingCrack<D>> cracks = readGrowing(set, toughness_);
  for (const FrontAdvance<D>& advance : set.advances)
    if (!set.fronts[advance.front].ended) // a front that has been met stops
      growFront(state, cracks, advance, meetings);
  set.advances.clear();
  writeGrowing(set, cracks, toughness_, state.mesh.grid.spacing);
  return meetings;
}

template class CrackGrowth<2>;
template class CrackGrowth<3>;

} // namespace Rhegma::cracks
