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

using namespace surface;

/// Lengths in cells.
constexpr double leastLigament = 0.5; ///< a station that has less ahead of it runs on to the surface
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
Vector<3> evening(const GrowingSurface& surface, const FrontLines<3>& lines, std::size_t k, double length)
{
  const int last = previousPoint(lines, k);
  if (last < 0 || !lines[k].joined)
    return {0.0, 0.0, 0.0};
  const Vector<3>&a = surface.vertices[lines[last].vertex], &x = surface.vertices[lines[k].vertex],
        &b = surface.vertices[lines[nextPoint(lines, k)].vertex];
  const Vector<3> along = cross(lines[k].direction, lines[k].normal);
  const double uneven = std::clamp(0.5 * (norm(b - x) - norm(x - a)), -sideways * length, sideways * length);
  return (dot(along, b - a) < 0.0 ? -uneven : uneven) * along;
}

/// Forgets the sides of particles that are ahead of the station nearest to them: they lie beside the crack
/// that will be there.
void forgetSidesAhead(const State<3>& state, const CrackFront<3>& front, double reach)
{
  const int count = static_cast<int>(front.stations.size());
  const View<double* [6]> stations("rhegma::cracks::stations", count);
  const auto host = Kokkos::create_mirror_view(stations);
  for (int k = 0; k < count; ++k)
    for (int d = 0; d < 3; ++d)
    {
      host(k, d) = front.stations[k].position[d];
      host(k, 3 + d) = front.stations[k].direction[d];
    }
  Kokkos::deep_copy(stations, host);
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
            const double from = position(p, d) - stations(k, d);
            square += from * from;
            along += from * stations(k, 3 + d);
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
  toldHalted_.resize(set.fronts.size(), false);
  for (std::size_t f = 0; f < set.fronts.size(); ++f)
  {
    const CrackFront<3>& front = set.fronts[f];
    marks_[f].resize(front.stations.size());
    FrontLines<3> lines;
    for (std::size_t k = 0; k < front.stations.size() && !front.ended; ++k)
    {
      FrontPoint<3> point;
      point.origin = static_cast<int>(k);
      point.stopped = front.stations[k].halted;
      point.direction = front.stations[k].direction;
      point.normal = front.stations[k].normal;
      point.vertex = front.stations[k].vertex - set.cracks[front.crack].firstVertex;
      point.name = front.stations[k].name;
      point.joined = front.stations[k].facet >= 0;
      point.landed = marks_[f][k].landed;
      point.toughness = marks_[f][k].toughness;
      lines.push_back(point);
    }
    cracks[front.crack].fronts.push_back(lines);
    cracks[front.crack].numbers.push_back(static_cast<int>(f));
    FrontPoint<3> end{};
    end.vertex = front.vertex - set.cracks[front.crack].firstVertex;
    cracks[front.crack].ends.push_back(end);
  }
  return cracks;
}

void SurfaceGrowth::write(CrackSet<3>& set, std::vector<Crack>& cracks, double spacing)
{
  std::vector<surface::CrackMesh<3>> meshes;
  std::vector<int> last(set.fronts.size(), 0);
  for (Crack& crack : cracks)
  {
    std::vector<FrontLines<3>*> lines;
    for (FrontLines<3>& front : crack.fronts)
      lines.push_back(&front);
    std::vector<FrontLines<3>*> numbered = lines;
    numbered.push_back(&crack.ends);
    crack.surface.tidy(numbered);
    meshes.push_back(crack.surface.mesh({lines.begin(), lines.end()}));
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
      const int f = crack.numbers[i];
      CrackFront<3>& front = set.fronts[f];
      last[f] = i < crack.ends.size() ? crack.ends[i].vertex : 0;
      front.ended = lines[i]->empty();
      const std::vector<FrontStation<3>> before = std::move(front.stations);
      front.stations.clear();
      marks_[f].clear();
      for (const FrontPoint<3>& point : *lines[i])
      {
        FrontStation<3> station = before[point.origin];
        if (point.stopped && !station.halted)
          station.speed = 0.0;
        station.vertex = point.vertex;
        station.name = point.name;
        station.from = point.from;
        station.facet = point.joined ? 0 : -1;
        station.halted = point.stopped || point.landed;
        front.stations.push_back(station);
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
  FrontLines<3>& lines = crack.fronts[place];
  GrowingSurface& surface = crack.surface;
  const std::size_t count = lines.size();

  std::vector<StationAdvance<3>> asked = advance.stations;
  std::vector<double> cells(count, 0.0);
  std::vector<bool> mirrored(count, false);
  bool turns = false;
  double longest = 0.0;
  for (std::size_t k = 0; k < count; ++k)
  {
    cells[k] = spacingAt(state, front.stations[k].position);
    mirrored[k] = std::any_of(mirrors_.begin(), mirrors_.end(),
                              [&](const MirrorPlane& plane)
                              { return isOn(plane, front.stations[k].position[plane.axis], cells[k]); });
    if (lines[k].landed || lines[k].stopped)
      asked[k].length = 0.0;
    longest = std::max(longest, asked[k].length);
    turns = turns || (asked[k].length > 0.0 && dot(asked[k].direction, lines[k].direction) < turned);
  }
  smoothAlongFront(surface, lines, front.stations, cells, mirrored, asked);
  if (turns)
    forgetSidesAhead(state, front, (bandWidth + 4.0) * state.mesh.grid.spacing + longest);

  std::vector<Way> ways;
  std::vector<std::size_t> moving;
  std::vector<Vector<3>> aside;
  for (std::size_t k = 0; k < count; ++k)
    if (asked[k].length > 0.0)
    {
      ways.push_back(
          {front.stations[k].position, asked[k].direction, asked[k].length + leastLigament * cells[k]});
      moving.push_back(k);
      aside.push_back(evening(surface, lines, k, asked[k].length));
    }
  const std::vector<double> room = roomAhead(state, ways);
  double energy = 0.0, area = 0.0;
  std::size_t landed = count;
  for (std::size_t i = 0; i < moving.size(); ++i)
  {
    const std::size_t k = moving[i];
    FrontPoint<3>& point = lines[k];
    const bool lands = room[i] < ways[i].length * (1.0 - 1e-9);
    const double length = lands ? room[i] : asked[k].length;
    Vector<3> x = ways[i].from + length * ways[i].direction;
    if (!lands)
      x = x + aside[i];
    const auto [distance, other] = nearestOther(state.cracks, front.crack, x);
    const bool near = distance < bandWidth * state.mesh.grid.spacing;
    if (near || (!lands && meetsItself(state.cracks, front.crack, x, ways[i].direction, cells[k])))
    {
      point.stopped = true;
      const std::string which =
          near ? "the crack " + state.cracks.cracks[other].name + " is" : "faces of its own crack are";
      if (!toldHalted_[advance.front])
        state.warnings.push_back("the front " + nameOf(state, front) + " halted at time " +
                                 formatReal(state.clock.time) + " s at " +
                                 inWords(front.stations[k].position) + ": " + which +
                                 " less than three cells ahead, and cells can't tell faces apart that are "
                                 "closer; smaller cells (Domain > Cell Size) let it come nearer");
      toldHalted_[advance.front] = true;
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
  // A front goes on where a part of it does.
  front.halted =
      std::all_of(lines.begin(), lines.end(), [](const FrontPoint<3>& p) { return p.landed || p.stopped; });
  front.grown = front.grown || !moving.empty();
  if (landed < count && !told_[advance.front])
  {
    told_[advance.front] = true;
    state.warnings.push_back("the front " + nameOf(state, front) +
                             " reached the surface of its body at time " + formatReal(state.clock.time) +
                             " s at " + inWords(surface.vertices[lines[landed].vertex]));
  }

  int names = 0; // no new station has the name of one that goes now: its past is another's
  for (const FrontPoint<3>& point : lines)
    names = std::max(names, point.name + 1);
  cutLanded(lines);
  const double cell = *std::min_element(cells.begin(), cells.end());
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (lines[k].joined && surface.pieceAt(lines, k) > longestPiece * cell)
      surface.split(lines, k, names++);
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (lines[k].joined && surface.pieceAt(lines, k) < shortestPiece * cell)
    {
      const double toughness = meanToughness(lines[k], lines[nextPoint(lines, k)]);
      double added = 0.0;
      if (surface.collapse(lines, k, added))
        energy += toughness * added;
    }
  front.taken += energy;
  front.unspent += energy;
  if (!lines.empty())
    return;
  front.ended = true;
  front.speed = 0.0;
  front.driving = {};
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
