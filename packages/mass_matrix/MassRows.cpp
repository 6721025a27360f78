#include "mass_matrix/MassRows.hpp"

#include "base/SmallLoops.hpp"
#include "mass_matrix/ChooseRows.hpp"
#include "mass_matrix/HashedLists.hpp"
#include "mass_matrix/RowLists.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::mass_matrix
{

namespace
{

/// How far apart the nodes of a row and of its slots are in the numbering, which changes with a new division
/// of the domain.
template <int D>
void findSteps(const Grid<D>& grid, MassSystem<D>& system)
{
  const int span = 2 * system.reach + 1;
  const auto host = Kokkos::create_mirror_view(system.step);
  for (int s = 0; s < system.slots; ++s)
  {
    int rest = s, step = 0;
    for (int d = D - 1; d >= 0; --d)
    {
      step += (rest % span - system.reach) * grid.stride[d];
      rest /= span;
    }
    host(s) = step;
  }
  Kokkos::deep_copy(system.step, host);
  std::copy_n(grid.stride, D, system.strideOfNodes);
}

template <int D>
void reserveNodes(const State<D>& state, MassSystem<D>& system)
{
  const int nodes = static_cast<int>(state.mesh.nodes.sums.extent(0));
  if (static_cast<int>(system.rowOf.extent(0)) < nodes)
  {
    system.rowOf = View<int*>("rhegma::massRowOf", nodes);
    Kokkos::deep_copy(system.rowOf, -1);
    system.last = system.first;
  }
  if (state.mesh.subdomain && state.mesh.tree.refined() && static_cast<int>(system.touched.extent(0)) < nodes)
    system.touched = View<double*>("rhegma::massTouched", nodes);
  if (system.slots == 0)
  {
    system.reach = reachOf(state.method.shape);
    const int span = 2 * system.reach + 1;
    system.lines = D == 2 ? span : span * span;
    system.slots = system.lines * span;
    // Four numbers are added where a line has three.
    system.stride = system.slots + (system.reach == 1 ? 0 : 1);
    system.first = system.last = system.reach;
    system.step = View<int*>("rhegma::massStep", system.slots);
  }
  if (!std::equal(system.strideOfNodes, system.strideOfNodes + D, state.mesh.grid.stride))
    findSteps(state.mesh.grid, system);
}

/// Forgets the rows of the last step.
template <int D>
void clearRows(const MassSystem<D>& system)
{
  const View<int*> rowOf = system.rowOf, nodeOf = system.nodeOf;
  parallelForSmall(
      "rhegma::mass::clearRows", system.first, system.last,
      KOKKOS_LAMBDA(const int row) { rowOf(nodeOf(row)) = -1; });
}

/// Gives the nodes their rows, in the order of the active nodes.
template <int D>
void numberRows(const State<D>& state, bool everywhere, MassSystem<D>& system)
{
  const int active = state.mesh.nodes.numActive();
  if (static_cast<int>(system.nodeOf.extent(0)) < active + 2 * system.reach)
    system.nodeOf = View<int*>("rhegma::massNodeOf", active + active / 8 + 2 * system.reach);
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int*> rowOf = system.rowOf, nodeOf = system.nodeOf;
  const int first = system.first;
  int count = 0;
  parallelScanSmall(
      "rhegma::mass::numberRows", 0, active,
      KOKKOS_LAMBDA(const int i, int& at, const bool final) {
        const int n = activeNode(nodes, i);
        if (!(everywhere ? nodes.sums(n, Nodes<D>::massAt) > 0.0 : rowOf(n) != -1))
          return;
        if (final)
        {
          rowOf(n) = first + at;
          nodeOf(first + at) = n;
        }
        ++at;
      },
      count);
  system.last = first + count;
}

/// Allocates the rows, with a reserve, so that solvers can be reused.
template <int D>
void reserveRows(MassSystem<D>& system)
{
  const int rows = system.last + system.reach;
  // Sums over vectors of another length may differ by round-off, so a restored length is kept.
  const bool lasts = system.rowCapacity >= rows && system.rowCapacity <= 2 * rows + 64;
  if (lasts && static_cast<int>(system.lumped.extent(0)) == system.rowCapacity)
    return;
  const int capacity = lasts ? system.rowCapacity : rows + rows / 16 + 8;
  system.rowCapacity = capacity;
  system.lumped = View<double*>("rhegma::massLumped", capacity);
  system.band = View<double*>("rhegma::massBand", static_cast<std::size_t>(capacity) * system.stride);
  system.lineStart = View<int*>("rhegma::massLineStart", static_cast<std::size_t>(capacity) * system.lines);
  system.extraOf = View<int*>("rhegma::massExtraOf", capacity);
  system.adjacent = View<double*>("rhegma::massAdjacent", capacity);
  system.coupled = View<char*>("rhegma::massCoupled", capacity);
}

/// Which nodes only particles with a stored stencil touch: those of refined cells, and those of the lattice
/// all of whose cells are refined or next to such.
template <int D>
struct OnlyStored
{
  Grid<D> grid;
  View<char*> near; ///< empty where no cell is refined

  explicit OnlyStored(const State<D>& state) : grid(state.mesh.grid)
  {
    if (state.mesh.tree.refined())
      near = state.mesh.tree.nearRefined;
  }

  KOKKOS_INLINE_FUNCTION bool operator()(int position) const
  {
    if (near.extent(0) == 0 || position >= grid.numNodes)
      return near.extent(0) > 0;
    bool inside = true;
    for (int k = 0; k < (1 << D); ++k)
    {
      int cell = position;
      for (int d = 0; d < D; ++d)
        cell -= ((k >> d) & 1) * grid.stride[d];
      inside = inside && cell >= 0 && near(cell) != 0;
    }
    return inside;
  }
};

/// Lumped mass and lines of each row; clears its band.
template <int D>
void startRows(const State<D>& state, MassSystem<D>& system)
{
  const auto sums = state.mesh.nodes.sums;
  const Nodes<D> nodes = state.mesh.nodes;
  const MassSystem<D> s = system;
  const Grid<D> grid = state.mesh.grid;
  const OnlyStored<D> onlyStored(state);
  parallelForSmall(
      "rhegma::mass::startRows", s.first, s.last, KOKKOS_LAMBDA(const int row) {
        const int node = s.nodeOf(row), lattice = latticeNode(nodes, node), span = 2 * s.reach + 1;
        s.lumped(row) = sums(node, Nodes<D>::massAt);
        s.extraOf(row) = -1;
        if (onlyStored(lattice))
        {
          s.lineStart(row * s.lines) = -1;
          return;
        }
        double* const values = s.band.data() + static_cast<std::size_t>(row) * s.stride;
        for (int k = 0; k < s.stride; ++k)
          values[k] = 0.0;
        for (int line = 0; line < s.lines; ++line)
        {
          int to = lattice;
          if (D == 2)
            to += (line - s.reach) * grid.stride[grid.axisOrder[0]];
          else
            to += (line / span - s.reach) * grid.stride[grid.axisOrder[0]] +
                  (line % span - s.reach) * grid.stride[grid.axisOrder[1]];
          // The band of an enriched field holds its diagonal alone, as particles on it have stored stencils.
          // At the boundary of the lattice of a rank a line may lie outside, where no particle reaches it.
          const bool exists = to >= 0 && to < grid.numNodes;
          const int middle = to == lattice ? row : (exists ? s.rowOf(to) : -1);
          // A line whose middle has no mass holds nothing: no particle touches both.
          s.lineStart(row * s.lines + line) = middle < 0 ? 0 : middle - s.reach;
        }
      });
}

/// Adds up what the rows of all ranks have next to their diagonals, and finds how many ranks have each.
template <int D>
void fractionRows(const State<D>& state, MassSystem<D>& system)
{
  if (!state.mesh.subdomain)
    return;
  if (static_cast<int>(system.rowWeight.extent(0)) != system.rowCapacity)
    system.rowWeight = View<double*>("rhegma::massRowWeight", system.rowCapacity);
  Kokkos::deep_copy(system.rowWeight, 1.0);
  sumOverRanks(state, system.adjacent.data(), 1, 0, 1, system.rowOf);
  sumOverRanks(state, system.rowWeight.data(), 1, 0, 1, system.rowOf);
  const View<double*> rowWeight = system.rowWeight;
  parallelForSmall(
      "rhegma::mass::weighRows", system.first, system.last,
      KOKKOS_LAMBDA(const int row) { rowWeight(row) = 1.0 / rowWeight(row); });
}

/// Moves the entries of a row's list, which lie in the slots of two fields, to its front. \param lattice node
/// of the row in the lattice \param second enriched field of each node \return their number
template <int D>
KOKKOS_INLINE_FUNCTION int packSlots(const MassSystem<D>& s, int row, int lattice, const View<int*>& second)
{
  const int list = s.extraOf(row);
  int kept = 0;
  for (int k = 0; k < 2 * s.slots; ++k)
  {
    const double value = s.extra(list, k);
    if (value == 0.0)
      continue;
    const int to = lattice + s.step(k % s.slots), other = k < s.slots ? to : second(to);
    if (other == s.nodeOf(row))
      continue;
    s.extra(list, kept) = value;
    s.extraColumn(list, kept++) = s.rowOf(other);
  }
  return kept;
}

/// Finds which rows have entries next to their diagonals; nodes of others lose their rows.
template <int D>
void findCoupled(const State<D>& state, MassSystem<D>& system)
{
  const MassSystem<D> shared = system;
  double found[2] = {0.0, 0.0}; // lumped mass and number of coupled rows
  parallelSumSmall(
      "rhegma::mass::coupledRows", system.first, system.last,
      KOKKOS_LAMBDA(const int row, double& sum, double& count) {
        shared.coupled(row) = shared.adjacent(row) > 0.0;
        if (shared.coupled(row))
        {
          sum += shared.weightOf(row) * shared.lumped(row);
          count += shared.weightOf(row);
        }
        else
          shared.rowOf(shared.nodeOf(row)) = -1;
      },
      found[0], found[1]);
  sumParts(state, found, 2);
  system.coupledMass = found[0];
  system.numCoupled = static_cast<int>(std::lround(found[1]));
}

} // namespace

template <int D>
void beginRows(const State<D>& state, const Unlumping& unlumping, MassSystem<D>& system)
{
  reserveNodes(state, system);
  clearRows(system);
  chooseLists(state.mesh.tree.refined(), system);
  if (!unlumping.everywhere)
  {
    listFronts(state, unlumping, system.front, system.zone, system.numFronts);
    chooseAroundFronts(state, unlumping, system);
  }
  numberRows(state, unlumping.everywhere, system);
  reserveRows(system);
  startRows(state, system);
  startLists(state, consistentFraction(unlumping, system), system);
}

template <int D>
void finishRows(const State<D>& state, MassSystem<D>& system)
{
  const MassSystem<D> s = system;
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int*> second = state.cracks.enrichedField;
  parallelForSmall(
      "rhegma::mass::finishRows", s.first, s.last, KOKKOS_LAMBDA(const int row) {
        double* const values = s.band.data() + static_cast<std::size_t>(row) * s.stride;
        const int centre = s.slots / 2, list = s.extraOf(row);
        // Extrapolated weights are negative, and entries of both signs may add up to nothing.
        double others = 0.0, sizes = 0.0;
        const bool hasBand = s.lineStart(row * s.lines) >= 0;
        for (int k = 0; hasBand && k < s.slots; ++k)
        {
          const double value = k == centre ? 0.0 : values[k];
          others += value;
          sizes += std::abs(value);
        }
        if (list >= 0)
          s.extraCount(list) = s.hashed
                                   ? packHashed(&s.extra(list, 0), &s.extraColumn(list, 0), s.listCapacity)
                                   : packSlots(s, row, latticeNode(nodes, s.nodeOf(row)), second);
        for (int k = 0; list >= 0 && k < s.extraCount(list); ++k)
        {
          others += s.extra(list, k);
          sizes += std::abs(s.extra(list, k));
        }
        values[centre] = (isOwnedByThisRank(nodes, s.nodeOf(row)) ? s.lumped(row) : 0.0) - others;
        s.adjacent(row) = sizes;
      });
  fractionRows(state, system);
  findCoupled(state, system);
  if (system.hashed && fullestListOf(system) > fullestList * system.listCapacity)
    system.listCapacity *= 2; // from the next step on
}

template void beginRows(const State<2>&, const Unlumping&, MassSystem<2>&);
template void beginRows(const State<3>&, const Unlumping&, MassSystem<3>&);
template void finishRows(const State<2>&, MassSystem<2>&);
template void finishRows(const State<3>&, MassSystem<3>&);

} // namespace Rhegma::mass_matrix
