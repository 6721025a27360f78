#include "cracks/CrackGeometry.hpp"
#include "cracks/Encounter.hpp"

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
  if (!node.ligament.ends &&
      nearest(set, own, false, node.to + from * node.path.direction).first < nearer * from)
    return {Kind::Stops, own, -1, 0.0, {}};
  return {};
}

} // namespace Rhegma::cracks
