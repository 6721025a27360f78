#include "cracks/Growth.hpp"

#include "checkpoint/Archive.hpp"
#include "cracks/CrackFrames.hpp"
#include "cracks/CrackGeometry.hpp"
#include "cracks/Layout.hpp"
#include "parallel/Subdomain.hpp"
#include "scene/Numbers.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace Rhegma::cracks
{

namespace
{

/// A vertex on the crack and its places on both faces.
struct Link
{
  Vector<2> vertex, face[2];
};

/// A crack from its first end to its last.
struct Chain
{
  std::vector<Link> links;
  bool front[2] = {false, false}; ///< whether its first and its last end are fronts
};

Link closedLink(const Vector<2>& x) { return {x, {x, x}}; }

std::vector<Chain> readChains(const CrackSet<2>& set)
{
  const auto vertex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, set.vertex);
  const auto face = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, set.face);
  const auto neighbour = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, set.neighbour);
  std::vector<Chain> chains;
  for (const Crack<2>& crack : set.cracks)
  {
    Chain chain;
    for (int v = crack.firstVertex; v < crack.firstVertex + crack.numVertices; ++v)
    {
      Link link;
      for (int d = 0; d < 2; ++d)
      {
        link.vertex[d] = vertex(v, d);
        link.face[0][d] = face(v, 0, d);
        link.face[1][d] = face(v, 1, d);
      }
      chain.links.push_back(link);
    }
    chain.front[0] = neighbour(crack.firstSimplex, 1) == facet::front;
    chain.front[1] = neighbour(crack.firstSimplex + crack.numSimplices - 1, 0) == facet::front;
    chains.push_back(chain);
  }
  return chains;
}

CrackMesh<2> meshOf(const Chain& chain)
{
  CrackMesh<2> mesh;
  mesh.vertices.reserve(chain.links.size());
  for (const Link& link : chain.links)
    mesh.vertices.push_back(link.vertex);
  const int segments = static_cast<int>(chain.links.size()) - 1;
  for (int s = 0; s < segments; ++s)
  {
    mesh.simplices.push_back({s, s + 1});
    mesh.beyond.push_back({s + 1, s - 1});
  }
  mesh.beyond.front()[1] = chain.front[0] ? facet::front : facet::mouth;
  mesh.beyond.back()[0] = chain.front[1] ? facet::front : facet::mouth;
  return mesh;
}

void writeChains(CrackSet<2>& set, const std::vector<Chain>& chains, double spacing)
{
  std::vector<CrackMesh<2>> meshes;
  for (const Chain& chain : chains)
    meshes.push_back(meshOf(chain));
  layOut(set, meshes, spacing);
  const auto face = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, set.face);
  for (std::size_t c = 0; c < chains.size(); ++c)
    for (std::size_t v = 0; v < chains[c].links.size(); ++v)
      for (int side = 0; side < 2; ++side)
        for (int d = 0; d < 2; ++d)
          face(set.cracks[c].firstVertex + v, side, d) = chains[c].links[v].face[side][d];
  Kokkos::deep_copy(set.face, face);
}

/// Whether a front lies at the first end of its crack.
bool atFirstEnd(const CrackSet<2>& set, const CrackFront<2>& front)
{
  return front.vertex == set.cracks[front.crack].firstVertex;
}

constexpr int places = 48; ///< that are looked at along an advance

/// Which of the places x + k step (k = 1 .. places) lie within a half diagonal of a particle's centre. \param
/// of a body; -1: any
std::uint64_t filledPlaces(const State<2>& state, const Vector<2>& x, const Vector<2>& step, int of = -1)
{
  const auto body = state.particles.integer(fields::body);
  const auto position = state.particles.real<2>(fields::position);
  const auto edge = state.particles.real<2>(fields::edge);
  const auto F = state.particles.real<gradientSize<2>>(fields::deformation);
  const double length = norm(step);
  std::uint64_t filled = 0;
  Kokkos::parallel_reduce(
      "rhegma::cracks::filledPlaces", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, std::uint64_t& bits) {
        if (of >= 0 && body(p) != of)
          return;
        // Half the diagonal of the deformed particle and a little more. (Edges are along the body's axes.)
        const double stretch =
            std::fmax(F(p, 0) * F(p, 0) + F(p, 2) * F(p, 2), 1.0) * edge(p, 0) * edge(p, 0) +
            std::fmax(F(p, 1) * F(p, 1) + F(p, 3) * F(p, 3), 1.0) * edge(p, 1) * edge(p, 1);
        const double reach = 0.55 * std::sqrt(stretch);
        const Vector<2> from{{position(p, 0) - x[0], position(p, 1) - x[1]}};
        const double along = dot(from, step) / length;
        const double aside = dot(from, from) - along * along;
        if (aside > reach * reach || along < -reach || along > places * length + reach)
          return;
        const double half = std::sqrt(reach * reach - aside);
        for (int k = 1; k <= places; ++k)
          if (std::fabs(k * length - along) <= half)
            bits |= std::uint64_t(1) << k;
      },
      Kokkos::BOr<std::uint64_t>(filled));
  if (!state.subdomain)
    return filled;
  double found[places + 1];
  for (int k = 0; k <= places; ++k)
    found[k] = (filled >> k & 1) != 0 ? 1.0 : 0.0;
  maxParts(state, found, places + 1);
  for (int k = 0; k <= places; ++k)
    filled |= found[k] > 0.0 ? std::uint64_t(1) << k : 0;
  return filled;
}

/// Whether two of these places are filled by particles of one body. Collective.
bool ofOneBody(const State<2>& state, const Vector<2>& x, const Vector<2>& step, int one, int other)
{
  for (int b = 0; b < static_cast<int>(state.bodyAxes.extent(0)); ++b)
    if (const std::uint64_t filled = filledPlaces(state, x, step, b);
        (filled >> one & 1) != 0 && (filled >> other & 1) != 0)
      return true;
  return false;
}

double distanceToSegment(const Vector<2>& x, const Vector<2>& a, const Vector<2>& b)
{
  const Vector<2> corner[2] = {a, b};
  return norm(x - placeOf<2>(corner, footOn(corner, x)));
}

/// The nearest part of another crack to x, or of the crack of the front itself further back than `back`.
/// \return its distance [m] and its crack
struct Neighbour
{
  double distance = 1e300;
  int crack = -1;
};

Neighbour nearestNeighbour(const std::vector<Chain>& chains, int own, bool first, const Vector<2>& x,
                           double back)
{
  Neighbour found;
  for (std::size_t c = 0; c < chains.size(); ++c)
  {
    const std::vector<Link>& links = chains[c].links;
    const int segments = static_cast<int>(links.size()) - 1;
    double behind = 0.0;
    for (int k = 0; k < segments; ++k)
    {
      const int s = first ? k : segments - 1 - k;
      if (static_cast<int>(c) == own && behind <= back)
      {
        behind += norm(links[s + 1].vertex - links[s].vertex);
        continue;
      }
      const double distance = distanceToSegment(x, links[s].vertex, links[s + 1].vertex);
      if (distance < found.distance)
        found = {distance, static_cast<int>(c)};
    }
  }
  return found;
}

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

/// What becomes of an advance.
struct Outcome
{
  double length;     ///< [m]
  bool ends = false; ///< at the surface
};

/// A front that has less than this left ahead of it runs on to the surface [cells].
constexpr double leastLigament = 0.5;

/// Bodies that are further apart than this, as filledPlaces sees them, do not touch [cells].
constexpr double apart = 0.125;

/// Opening of a crack one cell behind its front [m]. It grows as the root of the distance up to the first
/// vertex behind.
double openingBehind(const Chain& chain, bool first, double cell)
{
  const int count = static_cast<int>(chain.links.size());
  double behind = 0.0, before = 0.0;
  for (int k = 1; k < count; ++k)
  {
    const Link &from = chain.links[first ? k - 1 : count - k], &to = chain.links[first ? k : count - 1 - k];
    const double length = norm(to.vertex - from.vertex), opening = norm(to.face[1] - to.face[0]);
    if (behind + length >= cell)
      return k == 1 ? opening * std::sqrt(cell / length)
                    : before + (opening - before) * (cell - behind) / length;
    behind += length;
    before = opening;
  }
  return before;
}

Outcome findRoom(const State<2>& state, const Chain& chain, bool first, const CrackFront<2>& front,
                 const FrontAdvance<2>& advance)
{
  const double cell = spacingAt(state, front.position);
  // What lacks for no longer than this is the opening of the crack that the cells have, right at the front or
  // where it has drawn particles of a body apart. What lacks for longer, or between two bodies, is a surface.
  const double opening = std::max(leastLigament * cell, openingBehind(chain, first, cell));
  const double enough = advance.length + leastLigament * cell, step = (enough + opening) / places;
  const std::uint64_t filled = filledPlaces(state, front.position, step * advance.direction);
  int last = 0;
  for (int i = 1; i <= places && (i - last) * step <= opening; ++i)
    if ((filled >> i & 1) != 0)
    {
      if (last > 0 && (i - last) * step > apart * cell &&
          !ofOneBody(state, front.position, step * advance.direction, last, i))
        break;
      last = i;
    }
  return last * step < enough ? Outcome{last * step, true} : Outcome{advance.length, false};
}

void grow(State<2>& state, std::vector<Chain>& chains, const FrontAdvance<2>& advance)
{
  CrackFront<2>& front = state.cracks.fronts[advance.front];
  const double spacing = state.grid.spacing;
  const bool first = atFirstEnd(state.cracks, front);
  Chain& chain = chains[front.crack];
  const Outcome outcome = findRoom(state, chain, first, front, advance);
  const Vector<2> end = front.position + outcome.length * advance.direction;
  const Neighbour other = nearestNeighbour(chains, front.crack, first, end, (bandWidth + 3.0) * spacing);
  if (other.distance < bandWidth * spacing)
  {
    front.halted = true;
    front.speed = 0.0;
    state.warnings.push_back(
        "the front " + nameOf(state, front) + " halted at time " + formatReal(state.time) + " s at " +
        placeOf(front.position) + ": the crack " + state.cracks.cracks[other.crack].name +
        " is less than three cells ahead, and cells can't tell cracks apart that are closer; smaller cells "
        "(Domain > Cell Size) let it come nearer");
    return;
  }
  if (dot(advance.direction, front.direction) < 1.0 - 1e-12)
    forgetSidesAhead(state, front, (bandWidth + 4.0) * spacing + outcome.length);
  // A piece too short to have a direction is left out.
  if (outcome.length > 1e-3 * advance.length)
    chain.links.insert(first ? chain.links.begin() : chain.links.end(), closedLink(end));
  front.grown = true;
  const double energy = advance.toughness * outcome.length * state.thickness;
  front.taken += energy;
  front.unspent += energy;
  if (!outcome.ends)
    return;
  chain.front[first ? 0 : 1] = false;
  front.ended = true;
  front.speed = 0.0;
  front.driving = {};
  state.warnings.push_back("the front " + nameOf(state, front) + " reached the surface of its body at time " +
                           formatReal(state.time) + " s at " + placeOf(end));
}

} // namespace

void growCracks(State<2>& state)
{
  CrackSet<2>& set = state.cracks;
  if (set.advances.empty())
    return;
  std::vector<Chain> chains = readChains(set);
  std::vector<bool> first;
  for (const CrackFront<2>& front : set.fronts)
    first.push_back(atFirstEnd(set, front));
  for (const FrontAdvance<2>& advance : set.advances)
    grow(state, chains, advance);
  set.advances.clear();
  writeChains(set, chains, state.grid.spacing);
  for (std::size_t f = 0; f < set.fronts.size(); ++f)
    if (set.fronts[f].ended)
    {
      const Crack<2>& crack = set.cracks[set.fronts[f].crack];
      set.fronts[f].vertex = first[f] ? crack.firstVertex : crack.firstVertex + crack.numVertices - 1;
    }
  updateFronts(set);
}

namespace
{

template <int D>
void keepFronts(CrackSet<D>& set, Archive& archive)
{
  for (std::size_t f = 0; f < set.fronts.size(); ++f)
  {
    CrackFront<D>& front = set.fronts[f];
    const Archive::Group group(archive, "front " + std::to_string(f));
    archive("vertex", front.vertex);
    archive("direction", front.direction); // those of a front that has ended are found no more
    archive("normal", front.normal);
    archive("speed", front.speed);
    archive("release", front.driving.release);
    archive("K_I", front.driving.modeI);
    archive("K_II", front.driving.modeII);
    archive("K_III", front.driving.modeIII);
    archive("hoop_angle", front.driving.hoopAngle);
    archive("advances", front.advances);
    archive("grown", front.grown);
    archive("halted", front.halted);
    archive("ended", front.ended);
    archive("taken", front.taken);
    archive("unspent", front.unspent);
  }
}

/// Saves or loads how many vertices each crack has and which of its ends are fronts.
void keepChains(State<2>& state, Archive& archive)
{
  std::vector<int> sizes;
  if (!archive.loads())
    for (const Chain& chain : readChains(state.cracks))
      sizes.insert(sizes.end(),
                   {static_cast<int>(chain.links.size()), chain.front[0] ? 1 : 0, chain.front[1] ? 1 : 0});
  archive("chains", sizes, 3);
  keepFronts(state.cracks, archive);
  if (!archive.loads())
    return;
  // The places of the vertices are in the views that are loaded next.
  std::vector<int> vertices;
  for (const CrackFront<2>& front : state.cracks.fronts)
    vertices.push_back(front.vertex);
  std::vector<Chain> chains;
  for (std::size_t c = 0; c + 2 < sizes.size(); c += 3)
  {
    Chain chain;
    for (int v = 0; v < sizes[c]; ++v)
      chain.links.push_back(closedLink({{double(v), double(c)}}));
    chain.front[0] = sizes[c + 1] != 0;
    chain.front[1] = sizes[c + 2] != 0;
    chains.push_back(chain);
  }
  writeChains(state.cracks, chains, state.grid.spacing);
  for (std::size_t f = 0; f < vertices.size(); ++f)
    state.cracks.fronts[f].vertex = vertices[f];
}

} // namespace

template <int D>
void keepCracks(State<D>& state, Archive& archive)
{
  if constexpr (D == 2)
    keepChains(state, archive);
  else
    keepFronts(state.cracks, archive);
  archive("vertex", state.cracks.vertex);
  archive("face", state.cracks.face);
  archive("near_front", state.cracks.nearFront);
  if (!archive.loads())
    return;
  updateNormals(state.cracks);
  updateFronts(state.cracks);
}

template void keepCracks(State<2>&, Archive&);
template void keepCracks(State<3>&, Archive&);

} // namespace Rhegma::cracks
