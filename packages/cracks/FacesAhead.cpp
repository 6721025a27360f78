#include "cracks/CrackGeometry.hpp"
#include "cracks/Encounter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace Rhegma::cracks
{

namespace
{

/// The nearest of the triangles that are of a crack, or of all but that: distance [m], and crack.
std::pair<double, int> nearest(const CrackSet<3>& set, int crack, bool others, const Vector<3>& x)
{
  const CrackSight<3> sight(set, 1.0);
  using Nearest = Kokkos::MinLoc<double, int>;
  Nearest::value_type found{};
  Kokkos::parallel_reduce(
      "rhegma::cracks::nearestFace", Kokkos::RangePolicy<ExecSpace>(0, sight.simplex.extent(0)),
      KOKKOS_LAMBDA(const int s, Nearest::value_type& best) {
        const double square = (sight.crackOf(s) != crack) == others ? sight.square(s, x) : 1e300;
        if (square < best.val)
        {
          best.val = square;
          best.loc = sight.crackOf(s);
        }
      },
      Nearest(found));
  return {std::sqrt(found.val), found.loc};
}

/// Distance ahead of a front from which its own faces are searched [cells], and the fraction of that distance
/// within which faces are not those behind the front. A front that closes around a centre thus stops before
/// its nodes pass each other.
constexpr double ahead = 2.0, nearer = 0.5;

/// Whether faces near a point ahead of a front node are those behind its neighbours, which are so far ahead
/// of it: a node that lags goes on between them. Neighbours are up to this many nodes away, and run in about
/// the same direction; those of a front that closes round a middle come from the other side.
constexpr std::size_t neighbours = 4;

bool isBetweenNeighbours(const CrackFront<3>& front, std::size_t k, const Vector<3>& point, double least,
                         double reach)
{
  const FrontNode<3>& own = front.nodes[k];
  const std::size_t count = front.nodes.size();
  for (const bool forward : {true, false})
  {
    std::size_t at = k;
    for (std::size_t n = 0; n < std::min(neighbours, count / 4); ++n)
    {
      const std::size_t other = forward ? (at + 1) % count : (at + count - 1) % count;
      if (front.nodes[forward ? at : other].facet < 0)
        break;
      at = other;
      const FrontNode<3>& node = front.nodes[at];
      if (dot(node.position - own.position, own.direction) > least &&
          dot(node.direction, own.direction) > 0.0 && norm(node.position - point) < reach)
        return true;
    }
  }
  return false;
}

} // namespace

template <>
Encounter<3> findEncounter(const State<3>& state, const std::vector<GrowingCrack<3>>&,
                           const AdvancingNode<3>& node)
{
  using Kind = Encounter<3>::Kind;
  const CrackSet<3>& set = state.cracks;
  const int own = set.fronts[node.front].crack;
  if (set.cracks.size() > 1)
    if (const auto [distance, other] = nearest(set, own, true, node.to);
        distance < bandWidth * state.mesh.grid.spacing)
      return {Kind::Stops, other, -1, 0.0, {}};
  const double from = ahead * node.path.cell;
  const Vector<3> point = node.to + from * node.path.direction;
  if (!node.ligament.ends && nearest(set, own, false, point).first < nearer * from &&
      !isBetweenNeighbours(set.fronts[node.front], node.node, point, nearer * from, 1.5 * from))
    return {Kind::Stops, own, -1, 0.0, {}};
  return {};
}

} // namespace Rhegma::cracks
