#include "mass_matrix/ChooseRows.hpp"

#include "base/SmallLoops.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>

namespace Rhegma::mass_matrix
{

namespace
{

/// The nodes of the lattice around fronts that particles in their zones can touch, some of them repeatedly.
template <int D>
struct AroundFronts
{
  Grid<D> grid;
  View<double* [D]> front;
  View<double* [2]> zone;
  double beyond; ///< how far particles reach beyond their zone [m]
  int half, side, all, size;

  AroundFronts(const State<D>& state, const Unlumping& unlumping, const View<double* [D]>& positions,
               const View<double* [2]>& zones, int fronts)
      : grid(state.mesh.grid),
        front(positions),
        zone(zones),
        beyond(std::sqrt(double(D)) * 0.5 * (reachOf(state.method.shape) + 1) * grid.spacing),
        half(std::min(
            *std::max_element(wholeLattice(state).cells, wholeLattice(state).cells + D),
            static_cast<int>(std::ceil((unlumping.radius + unlumping.edge + beyond) * grid.inverse)))),
        side(2 * half + 1),
        all(D == 2 ? side * side : side * side * side),
        size(fronts * all)
  {
  }

  /// Number i of them, below size; or -1 where there is none.
  KOKKOS_INLINE_FUNCTION int operator()(const int i) const
  {
    const int f = i / all;
    int rest = i % all, at[D];
    bool in = true;
    for (int d = 0; d < D; ++d)
    {
      at[d] = static_cast<int>(std::floor(grid.inCells(front(f, d), d))) + rest % side - half;
      rest /= side;
      in = in && at[d] >= 0 && at[d] <= grid.cells[d];
    }
    const Vector<D> x = grid.positionOf(at);
    double square = 0.0;
    for (int d = 0; d < D; ++d)
      square += (x[d] - front(f, d)) * (x[d] - front(f, d));
    return in && square <= furthest(f) * furthest(f) ? grid.nodeIndex(at) : -1;
  }

  KOKKOS_INLINE_FUNCTION double furthest(int f) const { return zone(f, 0) + zone(f, 1) + beyond; }

  /// Whether a position is so near to a front.
  KOKKOS_INLINE_FUNCTION bool holds(const Vector<D>& x) const
  {
    bool any = false;
    for (int f = 0; f < size / all; ++f)
    {
      double square = 0.0;
      for (int d = 0; d < D; ++d)
        square += (x[d] - front(f, d)) * (x[d] - front(f, d));
      any = any || square <= furthest(f) * furthest(f);
    }
    return any;
  }
};

/// Marks the nodes of the lattice among them.
template <int D>
void chooseLattice(const State<D>& state, const Unlumping& unlumping, const MassSystem<D>& system)
{
  const AroundFronts<D> around(state, unlumping, system.front, system.zone, system.numFronts);
  const View<int*> rowOf = system.rowOf, second = state.cracks.enrichedField;
  const auto sums = state.mesh.nodes.sums;
  const bool seconds = state.mesh.nodes.numEnriched > 0;
  parallelForSmall(
      "rhegma::mass::chooseAroundFronts", 0, around.size, KOKKOS_LAMBDA(const int i) {
        const int node = around(i);
        if (node < 0)
          return;
        if (sums(node, Nodes<D>::massAt) > 0.0)
          rowOf(node) = chosen;
        const int other = seconds ? second(node) : -1;
        if (other >= 0 && sums(other, Nodes<D>::massAt) > 0.0)
          rowOf(other) = chosen;
      });
}

/// Marks the nodes that particles with a stored stencil touch, where cells are refined.
template <int D>
void chooseTouched(const State<D>& state, const ConsistentFraction<D>& fraction, const MassSystem<D>& system)
{
  const View<int*> rowOf = system.rowOf, particle = state.stored.particle;
  const StencilTable<D> table = state.stored.table;
  const auto sums = state.mesh.nodes.sums;
  const auto position = state.particles.template real<D>(fields::position);
  parallelForSmall(
      "rhegma::mass::chooseTouched", 0, state.stored.count, KOKKOS_LAMBDA(const int r) {
        if (fraction(&position(particle(r), 0)) == 0.0)
          return;
        for (int k = 0; k < table.count(r); ++k)
          if (sums(table.node(r, k), Nodes<D>::massAt) > 0.0)
            rowOf(table.node(r, k)) = chosen;
      });
}

/// Marks what any rank has marked: a row must be on all ranks that have its node, since the owner of the node
/// alone has the lumped mass in it. Collective.
template <int D>
void chooseTogether(const State<D>& state, const MassSystem<D>& system)
{
  if (!state.mesh.subdomain)
    return;
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int*> rowOf = system.rowOf;
  const View<double*> touched = system.touched;
  parallelForSmall(
      "rhegma::mass::reportChosen", 0, nodes.numActive(), KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        touched(n) = rowOf(n) == -1 ? 0.0 : 1.0;
      });
  sumOverRanks(state, touched.data(), 1, 0, 1);
  parallelForSmall(
      "rhegma::mass::hearChosen", 0, nodes.numActive(), KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        if (touched(n) > 0.0)
          rowOf(n) = chosen;
      });
}

} // namespace

template <int D>
void chooseAroundFronts(const State<D>& state, const Unlumping& unlumping, const MassSystem<D>& system)
{
  chooseLattice(state, unlumping, system);
  if (!system.hashed)
    return;
  chooseTouched(state, consistentFraction(unlumping, system), system);
  chooseTogether(state, system);
}

template <int D>
double largestRows(const State<D>& state, const Unlumping& unlumping)
{
  const double most =
      std::min<double>(state.mesh.grid.numNodes + state.mesh.tree.numFine, 1.5 * state.particles.size());
  if (unlumping.everywhere)
    return most;
  View<double* [D]> front;
  View<double* [2]> zone;
  int numFronts = 0;
  listFronts(state, unlumping, front, zone, numFronts);
  const AroundFronts<D> around(state, unlumping, front, zone, numFronts);
  const View<char*> near("rhegma::massNearFronts", state.mesh.grid.numNodes);
  parallelForSmall(
      "rhegma::mass::nearFronts", 0, around.size, KOKKOS_LAMBDA(const int i) {
        const int node = around(i);
        if (node >= 0)
          near(node) = 1;
      });
  int count = 0;
  parallelSumSmall(
      "rhegma::mass::countNearFronts", 0, state.mesh.grid.numNodes,
      KOKKOS_LAMBDA(const int node, int& sum) { sum += near(node); }, count);
  const NodePositions<D> positions = nodePositions(state);
  int fine = 0;
  parallelSumSmall(
      "rhegma::mass::countFineNearFronts", state.mesh.grid.numNodes,
      state.mesh.grid.numNodes + state.mesh.tree.numFine,
      KOKKOS_LAMBDA(const int node, int& sum) { sum += around.holds(positions(node)) ? 1 : 0; }, fine);
  count += fine;
  return std::min(most, 2.0 * count);
}

template void chooseAroundFronts(const State<2>&, const Unlumping&, const MassSystem<2>&);
template void chooseAroundFronts(const State<3>&, const Unlumping&, const MassSystem<3>&);
template double largestRows(const State<2>&, const Unlumping&);
template double largestRows(const State<3>&, const Unlumping&);

} // namespace Rhegma::mass_matrix
