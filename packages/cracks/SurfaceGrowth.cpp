#include "cracks/SurfaceGrowth.hpp"

#include "base/Numbers.hpp"
#include "cracks/CrackFrames.hpp"
#include "cracks/CrackGeometry.hpp"
#include "cracks/FacesAhead.hpp"
#include "cracks/FrontSmoothing.hpp"
#include "cracks/Layout.hpp"
#include "cracks/RoomAhead.hpp"
#include "geometry/Cross.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace Rhegma::cracks
{

namespace
{

/// Lengths in cells.
constexpr double leastLigament = 0.5; ///< a front node that has less ahead of it runs on to the surface
constexpr double longestPiece = 1.5, shortestPiece = 0.5;
constexpr double rowHeight = 1.0;
/// Most that a point moves along its front, in parts of its advance: less than a turn that begins a row.
constexpr double sideways = 0.15;
constexpr double turned = 1.0 - 1e-6; ///< cosine of a turn that is none

std::string nameOf(const State<3>& state, const CrackFront<3>& front)
{
  return state.cracks.cracks[front.crack].name + "." + std::to_string(front.number);
}

std::string inWords(const Vector<3>& x)
{
  return formatReal(x[0]) + ", " + formatReal(x[1]) + ", " + formatReal(x[2]) + " m";
}

/// How far a point of a front is to move along it beside its advance, towards the middle of its neighbours
/// [m].
///
/// Neighbours advance one after the other, so that a front is never quite normal to the ways of its points.
/// What that moves them sideways does not even out where one neighbour is always the first.
Vector<3> evening(const GrowingSurface& surface, const FrontLines& lines, std::size_t k, double length)
{
  const int last = before(lines, k);
  if (last < 0 || !lines[k].joined)
    return {0.0, 0.0, 0.0};
  const Vector<3>&a = surface.vertices[lines[last].vertex], &x = surface.vertices[lines[k].vertex],
        &b = surface.vertices[lines[GrowingSurface::next(lines, k)].vertex];
  const Vector<3> along = cross(lines[k].node.direction, lines[k].node.normal);
  const double uneven = std::clamp(0.5 * (norm(b - x) - norm(x - a)), -sideways * length, sideways * length);
  return (dot(along, b - a) < 0.0 ? -uneven : uneven) * along;
}

/// Forgets the sides of particles that are ahead of the front node nearest to them: they lie beside the crack
/// that will be there.
void forgetSidesAhead(const State<3>& state, const CrackFront<3>& front, double reach)
{
  const int count = static_cast<int>(front.nodes.size());
  const View<double* [6]> frontNodes("rhegma::cracks::frontNodes", count);
  const auto host = Kokkos::create_mirror_view(frontNodes);
  for (int k = 0; k < count; ++k)
    for (int d = 0; d < 3; ++d)
    {
      host(k, d) = front.nodes[k].position[d];
      host(k, 3 + d) = front.nodes[k].direction[d];
    }
  Kokkos::deep_copy(frontNodes, host);
  const auto position = state.particles.real<3>(fields::position);
  const auto side = state.particles.integer(fields::side);
  const int name = front.crack + 1;
  Kokkos::parallel_for(
      "rhegma::cracks::forgetSidesAhead", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p) {
        if (side(p) != name && side(p) != -name)
          return;
        double least = reach * reach, ahead = 0.0;
        for (int k = 0; k < count; ++k)
        {
          double square = 0.0, along = 0.0;
          for (int d = 0; d < 3; ++d)
          {
            const double from = position(p, d) - frontNodes(k, d);
            square += from * from;
            along += from * frontNodes(k, 3 + d);
          }
          if (square < least)
          {
            least = square;
            ahead = along;
          }
        }
        if (ahead > 0.0)
          side(p) = 0;
      });
}

} // namespace

std::vector<SurfaceGrowth::Crack> SurfaceGrowth::read(const CrackSet<3>& set)
{
  const auto vertex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, set.vertex);
  const auto face = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, set.face);
  const auto simplex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, set.simplex);
  std::vector<Crack> cracks(set.cracks.size());
  for (std::size_t c = 0; c < cracks.size(); ++c)
  {
    GrowingSurface& surface = cracks[c].surface;
    const int v0 = set.cracks[c].firstVertex, s0 = set.cracks[c].firstSimplex;
    for (int v = v0; v < v0 + set.cracks[c].numVertices; ++v)
    {
      surface.vertices.push_back({vertex(v, 0), vertex(v, 1), vertex(v, 2)});
      surface.faces.push_back({Vector<3>{face(v, 0, 0), face(v, 0, 1), face(v, 0, 2)},
                               {face(v, 1, 0), face(v, 1, 1), face(v, 1, 2)}});
    }
    for (int s = s0; s < s0 + set.cracks[c].numSimplices; ++s)
      surface.triangles.push_back({simplex(s, 0) - v0, simplex(s, 1) - v0, simplex(s, 2) - v0});
    surface.prepare();
  }
  marks_.resize(set.fronts.size());
  lastToughness_.resize(set.fronts.size(), 0.0);
  told_.resize(set.fronts.size(), false);
  toldStopped_.resize(set.fronts.size(), false);
  for (std::size_t f = 0; f < set.fronts.size(); ++f)
  {
    const CrackFront<3>& front = set.fronts[f];
    marks_[f].resize(front.nodes.size());
    FrontLines lines;
    for (std::size_t k = 0; k < front.nodes.size() && !front.ended; ++k)
    {
      LinePoint point{};
      point.node = front.nodes[k];
      point.vertex = front.nodes[k].vertex - set.cracks[front.crack].firstVertex;
      point.name = front.nodes[k].name;
      point.from = -1;
      point.joined = front.nodes[k].facet >= 0;
      point.landed = marks_[f][k].landed;
      point.toughness = marks_[f][k].toughness;
      lines.push_back(point);
    }
    cracks[front.crack].fronts.push_back(lines);
    cracks[front.crack].numbers.push_back(static_cast<int>(f));
    LinePoint end{};
    end.vertex = front.vertex - set.cracks[front.crack].firstVertex;
    cracks[front.crack].ends.push_back(end);
  }
  return cracks;
}

void SurfaceGrowth::write(CrackSet<3>& set, std::vector<Crack>& cracks, double spacing)
{
  std::vector<CrackMesh<3>> meshes;
  std::vector<int> last(set.fronts.size(), 0);
  for (Crack& crack : cracks)
  {
    std::vector<FrontLines*> lines;
    for (FrontLines& front : crack.fronts)
      lines.push_back(&front);
    std::vector<FrontLines*> numbered = lines;
    numbered.push_back(&crack.ends);
    crack.surface.tidy(numbered);
    meshes.push_back(crack.surface.mesh({lines.begin(), lines.end()}));
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
      const int f = crack.numbers[i];
      CrackFront<3>& front = set.fronts[f];
      last[f] = i < crack.ends.size() ? crack.ends[i].vertex : 0;
      front.ended = lines[i]->empty();
      front.nodes.clear();
      marks_[f].clear();
      for (const LinePoint& point : *lines[i])
      {
        FrontNode<3> frontNode = point.node;
        frontNode.vertex = point.vertex;
        frontNode.name = point.name;
        frontNode.from = point.from;
        frontNode.facet = point.joined ? 0 : -1;
        frontNode.stopped = frontNode.stopped || point.landed;
        front.nodes.push_back(frontNode);
        marks_[f].push_back({point.toughness, point.landed});
      }
    }
  }
  layOut(set, meshes, spacing);
  const auto face = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, set.face);
  for (std::size_t c = 0; c < cracks.size(); ++c)
    for (std::size_t v = 0; v < cracks[c].surface.faces.size(); ++v)
      for (int side = 0; side < 2; ++side)
        for (int d = 0; d < 3; ++d)
          face(set.cracks[c].firstVertex + v, side, d) = cracks[c].surface.faces[v][side][d];
  Kokkos::deep_copy(set.face, face);
  bool ended = false;
  for (std::size_t f = 0; f < set.fronts.size(); ++f)
    if (set.fronts[f].ended)
    {
      const Rhegma::Crack<3>& crack = set.cracks[set.fronts[f].crack];
      set.fronts[f].vertex = crack.firstVertex + std::clamp(last[f], 0, crack.numVertices - 1);
      ended = true;
    }
  if (ended)
    updateFronts(set);
}

void SurfaceGrowth::growFront(State<3>& state, std::vector<Crack>& cracks, const FrontAdvance<3>& advance)
{
  CrackFront<3>& front = state.cracks.fronts[advance.front];
  Crack& crack = cracks[front.crack];
  const std::size_t place =
      std::find(crack.numbers.begin(), crack.numbers.end(), advance.front) - crack.numbers.begin();
  FrontLines& lines = crack.fronts[place];
  GrowingSurface& surface = crack.surface;
  const std::size_t count = lines.size();

  std::vector<FrontNodeAdvance<3>> asked = advance.nodes;
  std::vector<double> cells(count, 0.0);
  std::vector<bool> mirrored(count, false);
  bool turns = false;
  double longest = 0.0;
  for (std::size_t k = 0; k < count; ++k)
  {
    cells[k] = spacingAt(state, lines[k].node.position);
    mirrored[k] = std::any_of(mirrors_.begin(), mirrors_.end(),
                              [&](const MirrorPlane& plane)
                              { return isOn(plane, lines[k].node.position[plane.axis], cells[k]); });
    if (lines[k].landed || lines[k].node.stopped)
      asked[k].length = 0.0;
    longest = std::max(longest, asked[k].length);
    turns = turns || (asked[k].length > 0.0 && dot(asked[k].direction, lines[k].node.direction) < turned);
  }
  smoothAlongFront(surface, lines, cells, mirrored, asked);
  if (turns)
    forgetSidesAhead(state, front, (bandWidth + 4.0) * state.mesh.grid.spacing + longest);

  std::vector<Way> ways;
  std::vector<std::size_t> moving;
  std::vector<Vector<3>> aside;
  for (std::size_t k = 0; k < count; ++k)
    if (asked[k].length > 0.0)
    {
      ways.push_back(
          {lines[k].node.position, asked[k].direction, asked[k].length + leastLigament * cells[k]});
      moving.push_back(k);
      aside.push_back(evening(surface, lines, k, asked[k].length));
    }
  const std::vector<double> room = roomAhead(state, ways);
  double energy = 0.0, area = 0.0;
  std::size_t landed = count;
  for (std::size_t i = 0; i < moving.size(); ++i)
  {
    const std::size_t k = moving[i];
    LinePoint& point = lines[k];
    const bool lands = room[i] < ways[i].length * (1.0 - 1e-9);
    const double length = lands ? room[i] : asked[k].length;
    Vector<3> x = ways[i].from + length * ways[i].direction;
    if (!lands)
      x = x + aside[i];
    const auto [distance, other] = nearestOther(state.cracks, front.crack, x);
    const bool near = distance < bandWidth * state.mesh.grid.spacing;
    if (near || (!lands && meetsItself(state.cracks, front.crack, x, ways[i].direction, cells[k])))
    {
      point.node.stopped = true;
      point.node.speed = 0.0;
      const std::string which =
          near ? "the crack " + state.cracks.cracks[other].name + " is" : "faces of its own crack are";
      if (!toldStopped_[advance.front])
        state.warnings.push_back("the front " + nameOf(state, front) + " halted at time " +
                                 formatReal(state.clock.time) + " s at " + inWords(point.node.position) +
                                 ": " + which +
                                 " less than three cells ahead, and cells can't tell faces apart that are "
                                 "closer; smaller cells (Domain > Cell Size) let it come nearer");
      toldStopped_[advance.front] = true;
      continue;
    }
    point.toughness = asked[k].toughness;
    // A piece too short to have a direction is left out.
    if (length > 1e-3 * asked[k].length)
    {
      const double more = surface.advance(lines, k, x, rowHeight * cells[k]);
      area += more;
      energy += point.toughness * more;
    }
    point.landed = lands;
    landed = lands ? k : landed;
  }
  if (area > 0.0 && energy > 0.0)
    lastToughness_[advance.front] = energy / area;
  if (landed < count)
    crack.ends[place].vertex = lines[landed].vertex;
  front.grown = front.grown || !moving.empty();
  if (landed < count && !told_[advance.front])
  {
    told_[advance.front] = true;
    state.warnings.push_back("the front " + nameOf(state, front) +
                             " reached the surface of its body at time " + formatReal(state.clock.time) +
                             " s at " + inWords(surface.vertices[lines[landed].vertex]));
  }

  int names = 0; // no new front node has the name of one that goes now: its past is another's
  for (const LinePoint& point : lines)
    names = std::max(names, point.name + 1);
  cutLanded(lines);
  const double cell = *std::min_element(cells.begin(), cells.end());
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (lines[k].joined && surface.pieceAt(lines, k) > longestPiece * cell)
      surface.split(lines, k, names++);
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (lines[k].joined && surface.pieceAt(lines, k) < shortestPiece * cell)
    {
      const double toughness = meanToughness(lines[k], lines[GrowingSurface::next(lines, k)]);
      double added = 0.0;
      if (surface.collapse(lines, k, added))
        energy += toughness * added;
    }
  front.budget.require(energy);
  front.ended = lines.empty();
}

void SurfaceGrowth::grow(State<3>& state)
{
  CrackSet<3>& set = state.cracks;
  if (set.advances.empty())
    return;
  std::vector<Crack> cracks = read(set);
  for (const FrontAdvance<3>& advance : set.advances)
    growFront(state, cracks, advance);
  set.advances.clear();
  write(set, cracks, state.mesh.grid.spacing);
}

} // namespace Rhegma::cracks
