#include "cracks/HeldFaces.hpp"

#include "cracks/HoldingForce.hpp"
#include "state/Subdomain.hpp"

#include <vector>

namespace Rhegma::cracks
{

namespace
{

/// Component of the crack's normal along a held axis from which it runs along the support: 45 degrees.
constexpr double alongSupport = 0.7072;

} // namespace

template <int D>
void warnOfHeldFaces(State<D>& state, const Surroundings& surroundings)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const NodePositions<D> positions = nodePositions(state);
  const CrackSight<D> sight(state.cracks, state.mesh.grid.spacing);
  const View<std::uint64_t*> nearest = surroundings.nearest;
  std::vector<double> held(state.cracks.cracks.size(), 0.0); // whether each is
  for (const NodeConstraint<D>& constraint : state.motion.constraints)
  {
    int found = -1;
    Kokkos::parallel_reduce(
        "rhegma::cracks::heldFaces", Kokkos::RangePolicy<ExecSpace>(0, nodes.numOfCracks),
        KOKKOS_LAMBDA(const int i, int& last) {
          const int n = nodes.parent(i);
          const Vector<D> x = positions(n);
          if (!bothHaveMass(nodes.sums(n, Nodes<D>::massAt),
                            nodes.sums(nodes.numLattice + i, Nodes<D>::massAt)) ||
              !constraint.appliesAt(x))
            return;
          const int s = simplexOf(nearest(n));
          const double distance = sight.locate(s, x).distance;
          Vector<D> across = x;
          bool along = false;
          for (int d = 0; d < D; ++d)
          {
            across[d] -= distance * sight.normal(s, d);
            along = along || (constraint.holds[d] && std::fabs(sight.normal(s, d)) > alongSupport);
          }
          const int crack = sight.crackOf(s);
          if (along && !constraint.appliesAt(across) && crack > last)
            last = crack;
        },
        Kokkos::Max<int>(found));
    if (found >= 0)
      held[found] = 1.0;
  }
  maxParts(state, held.data(), static_cast<int>(held.size()));
  for (std::size_t c = 0; c < held.size(); ++c)
    if (held[c] != 0.0)
      state.warnings.push_back(
          "Cracks > " + state.cracks.cracks[c].name +
          ": it runs along a support less than a cell away, which restrains both of its faces and reduces "
          "its opening; keep a cell between them, or use smaller cells (Domain > Cell Size)");
}

template void warnOfHeldFaces(State<2>&, const Surroundings&);
template void warnOfHeldFaces(State<3>&, const Surroundings&);

} // namespace Rhegma::cracks
