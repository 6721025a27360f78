#include "cracks/Junctions.hpp"

#include "archive/Archive.hpp"
#include "base/Numbers.hpp"
#include "base/SmallLoops.hpp"
#include "state/Subdomain.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/NearNodes.hpp"

#include <string>

namespace Rhegma::cracks
{

namespace
{

/// Lengths in cells: round a junction within which nodes are given to cracks, beyond that within which
/// particles see such nodes, and from the crack that ended within which particles learn its side.
constexpr double zone = 2.0, sight = 2.5, adjacent = bandWidth + 2.0;

/// Shape functions that are seen sum to at least this; a point that sees less keeps its stencil.
constexpr double leastSeen = 0.05;

/// Distinguishes the pieces of material at a junction, in kernels.
struct Pieces
{
  CrackSight<2> cracks;
  Vector<2> position;
  int throughSimplex, through, ended, side;
  double radius, tolerance;

  /// Whether a position lies on the side on which the other crack ends.
  KOKKOS_INLINE_FUNCTION bool near(const Vector<2>& x) const
  {
    const int sideOfX = cracks.locate(throughSimplex, x).distance > -tolerance ? 1 : -1;
    return sideOfX == side;
  }
  KOKKOS_INLINE_FUNCTION bool within(const Vector<2>& x, double reach) const
  {
    return dot(x - position, x - position) < reach * reach;
  }
  /// Whether a point of this side belongs to the piece across: 1, to the pieces next to the crack that ended:
  /// 0, or to none that is known: -1.
  KOKKOS_INLINE_FUNCTION int across(int sideOfPoint) const
  {
    if (sideOfPoint == side * (through + 1) || sideOfPoint == ended + 1 || sideOfPoint == -ended - 1)
      return 0;
    return sideOfPoint == -side * (through + 1) ? 1 : -1;
  }
};

template <class Junction>
Pieces piecesAt(const State<2>& state, const Junction& j)
{
  return {CrackSight<2>(state.cracks, state.mesh.grid.spacing),
          j.position,
          j.throughSimplex,
          j.through,
          j.ended,
          j.side,
          j.radius,
          sideTolerance * j.radius / zone};
}

/// Gives particles of one side near a position their side of another crack next to them. \return how many
/// already had a side of a third crack, which they keep
int learnSides(const State<2>& state, const Vector<2>& at, int known, int crack)
{
  const CrackSight<2> crackSight(state.cracks, state.mesh.grid.spacing);
  const auto position = state.particles.real<2>(fields::position);
  const auto side = state.particles.integer(fields::side);
  const auto other = state.particles.integer(otherSide);
  const double reach = adjacent * state.mesh.grid.spacing, around = 2.0 * reach;
  const int name = crack + 1, begin = state.cracks.cracks[crack].firstSimplex,
            end = begin + state.cracks.cracks[crack].numSimplices;
  double full[1];
  BlocksInReach<2> blocks;
  blocks.find(state, {boxAround(at, around)});
  blocks.sumOverParticles(
      "rhegma::cracks::learnSides",
      KOKKOS_LAMBDA(const int p, double(&sum)[1]) {
        const Vector<2> x{position(p, 0), position(p, 1)};
        if (side(p) != known || dot(x - at, x - at) > around * around)
          return;
        int nearest = begin;
        double square = 1e300;
        for (int s = begin; s < end; ++s)
        {
          const double own = crackSight.square(s, x);
          if (own < square)
          {
            square = own;
            nearest = s;
          }
        }
        if (!(square < reach * reach))
          return;
        if (other(p) != 0 && other(p) != name && other(p) != -name)
          sum[0] += 1.0;
        else
          other(p) = crackSight.locate(nearest, x).distance >= 0.0 ? name : -name;
      },
      full);
  sumParts(state, full, 1);
  return static_cast<int>(full[0]);
}

/// Warns that particles would need sides of more than two cracks.
void warnOfThirdCrack(State<2>& state, int particles, int one, int two)
{
  if (particles > 0)
    state.warnings.push_back("where the cracks " + state.cracks.cracks[one].name + " and " +
                             state.cracks.cracks[two].name + " meet at time " + formatReal(state.clock.time) +
                             " s, " + std::to_string(particles) +
                             " particles are next to a third crack too, and stay connected across one of the "
                             "cracks; use smaller cells (Domain > Cell Size) to separate junctions");
}

} // namespace

void Junctions::locate(const State<2>& state, Junction& j)
{
  const CrackSet<2>& set = state.cracks;
  const auto vertex = onHost(set.vertex);
  const Crack<2>&ended = set.cracks[j.ended], &through = set.cracks[j.through];
  const int end = j.first ? ended.firstVertex : ended.firstVertex + ended.numVertices - 1;
  j.endSimplex = j.first ? ended.firstSimplex : ended.firstSimplex + ended.numSimplices - 1;
  j.position = {vertex(end, 0), vertex(end, 1)};
  double shortest = 1e300;
  for (int s = 0; s < through.numSimplices; ++s)
  {
    const int v = through.firstVertex + s;
    const Vector<2> corner[2] = {{vertex(v, 0), vertex(v, 1)}, {vertex(v + 1, 0), vertex(v + 1, 1)}};
    const double distance = surface::distanceToSimplex(corner, j.position);
    if (distance < shortest)
    {
      shortest = distance;
      j.throughSimplex = through.firstSimplex + s;
    }
  }
  j.radius = zone * spacingAt(state, j.position);
}

void Junctions::add(State<2>& state, int ended, bool first, int through)
{
  Junction j{ended, through, first, 1};
  locate(state, j);
  {
    const auto vertex = onHost(state.cracks.vertex);
    const auto normal = onHost(state.cracks.normal);
    const Crack<2>& crack = state.cracks.cracks[ended];
    const int behind = first ? crack.firstVertex + 1 : crack.firstVertex + crack.numVertices - 2;
    const Vector<2> from{vertex(behind, 0) - j.position[0], vertex(behind, 1) - j.position[1]};
    j.side = from[0] * normal(j.throughSimplex, 0) + from[1] * normal(j.throughSimplex, 1) > 0.0 ? 1 : -1;
  }
  all_.push_back(j);
  warnOfThirdCrack(state, learnSides(state, j.position, j.side * (through + 1), ended), ended, through);
}

void Junctions::join(State<2>& state, int one, bool first, int two)
{
  Junction j{one, two, first, 1};
  locate(state, j);
  int crowd = 0;
  for (const int sign : {1, -1})
    crowd += learnSides(state, j.position, sign * (one + 1), two) +
             learnSides(state, j.position, sign * (two + 1), one);
  warnOfThirdCrack(state, crowd, one, two);
}

void Junctions::claimNodes(const State<2>& state, const Surroundings& surroundings)
{
  const View<std::uint64_t*> nearest = surroundings.nearest;
  for (Junction& j : all_)
  {
    locate(state, j);
    const Pieces pieces = piecesAt(state, j);
    const auto end = static_cast<std::uint64_t>(j.endSimplex),
               through = static_cast<std::uint64_t>(j.throughSimplex);
    const BoxNodes<2> nodes(state, boxAround(j.position, j.radius));
    parallelForSmall(
        "rhegma::cracks::claimNodes", nodes.count(), KOKKOS_LAMBDA(const int k) {
          const Vector<2> x = nodes.position(k);
          if (pieces.within(x, pieces.radius))
            nearest(nodes.node(k)) = pieces.near(x) ? end : through;
        });
  }
}

void Junctions::markParticles(const State<2>& state, const View<int*>& row)
{
  const auto position = state.particles.real<2>(fields::position);
  for (Junction& j : all_)
  {
    const Vector<2> at = j.position;
    const double reach = j.radius / zone * (zone + sight);
    j.blocks.find(state, {boxAround(at, reach)});
    j.blocks.forEachParticle(
        "rhegma::cracks::markAtJunctions", KOKKOS_LAMBDA(const int p) {
          const Vector<2> from{position(p, 0) - at[0], position(p, 1) - at[1]};
          if (dot(from, from) < reach * reach)
            row(p) = 0;
        });
  }
}

void Junctions::hideNodes(const State<2>& state, const ObservedPoints<2>& points,
                          const StencilTable<2>& table) const
{
  const NodePositions<2> positions = nodePositions(state);
  const int numLattice = state.mesh.nodes.numLattice;
  for (const Junction& j : all_)
  {
    const Pieces pieces = piecesAt(state, j);
    const double reach = j.radius / zone * (zone + sight);
    parallelForSmall(
        "rhegma::cracks::hideNodes", points.count, KOKKOS_LAMBDA(const int r) {
          const Vector<2> x{points.position(r, 0), points.position(r, 1)};
          const int across = pieces.within(x, reach) ? pieces.across(points.side(r)) : -1;
          if (across < 0)
            return;
          double seen = 0.0, all = 0.0, slope[2] = {0.0, 0.0}, gradient[4] = {0.0, 0.0, 0.0, 0.0};
          const int gradients = table.hasGradients() ? 4 : 0;
          double around = 0.0, seenAround = 0.0;
          int left = 0;
          const auto hidden = [&](int k)
          {
            const int n = table.node(r, k);
            if (n >= numLattice)
              return false;
            const Vector<2> node = positions(n);
            return pieces.within(node, pieces.radius) && pieces.near(node) == (across == 1);
          };
          for (int k = 0; k < table.count(r); ++k)
          {
            all += table.weight(r, k);
            around += table.hasHoop() ? table.hoop(r, k) : 0.0;
            if (hidden(k))
              continue;
            ++left;
            seenAround += table.hasHoop() ? table.hoop(r, k) : 0.0;
            seen += table.weight(r, k);
            for (int d = 0; d < 2; ++d)
              slope[d] += table.slope(r, k, d);
            for (int c = 0; c < gradients; ++c)
              gradient[c] += table.gradient(r, k, c);
          }
          if (left == table.count(r) || !(seen > leastSeen * all))
            return;
          int kept = 0;
          for (int k = 0; k < table.count(r); ++k)
          {
            if (hidden(k))
              continue;
            const double weight = table.weight(r, k) / seen;
            for (int d = 0; d < 2; ++d)
              table.slope(r, kept, d) = (table.slope(r, k, d) - weight * slope[d]) / seen * all;
            for (int c = 0; c < gradients; ++c)
              table.gradient(r, kept, c) = (table.gradient(r, k, c) - weight * gradient[c]) / seen * all;
            if (table.hasHoop())
              table.hoop(r, kept) = table.hoop(r, k) * (around / seenAround);
            table.node(r, kept) = table.node(r, k);
            table.weight(r, kept) = weight * all;
            ++kept;
          }
          table.count(r) = kept;
        });
  }
}

void Junctions::serialize(Archive& archive)
{
  std::vector<int> numbers;
  for (const Junction& j : all_)
    numbers.insert(numbers.end(), {j.ended, j.through, j.first ? 1 : 0, j.side});
  archive("junctions", numbers, 4);
  if (!archive.loads())
    return;
  all_.clear();
  for (std::size_t k = 0; k + 3 < numbers.size(); k += 4)
    all_.push_back({numbers[k], numbers[k + 1], numbers[k + 2] != 0, numbers[k + 3]});
}

} // namespace Rhegma::cracks
