#pragma once
/// The nodes in a box.

#include "transfer/BlocksInReach.hpp"

#include <cmath>

namespace Rhegma
{

/// The nodes of the lattice in a box, or within a cell of it, and all nodes of refined cells, numbered from
/// 0.
template <int D>
class BoxNodes
{
public:
  BoxNodes(const State<D>& state, const AxisBox<D>& box)
      : grid_(state.mesh.grid), fine_(state.mesh.tree.finePosition), numFine_(state.mesh.tree.numFine)
  {
    for (int d = 0; d < D; ++d)
    {
      // A box around a front that an unstable step flung away may be anywhere.
      const double most = grid_.cells[d];
      const double low = std::floor(std::fmax(0.0, std::fmin(grid_.inCells(box.lower[d], d), most)));
      const double high = std::ceil(std::fmax(0.0, std::fmin(grid_.inCells(box.upper[d], d), most)));
      first_[d] = static_cast<int>(low);
      count_[d] = static_cast<int>(high) - first_[d] + 1;
      numLattice_ *= count_[d];
    }
  }

  KOKKOS_INLINE_FUNCTION int count() const { return numLattice_ + numFine_; }

  /// Lines of nodes of the lattice along the fastest axis of the numbering, of lineLength() nodes each.
  KOKKOS_INLINE_FUNCTION int numLines() const { return numLattice_ / lineLength(); }
  KOKKOS_INLINE_FUNCTION int lineLength() const { return count_[grid_.axisOrder[D - 1]]; }

  /// Calls body(node, x) with the nodes of a line.
  template <class Body>
  KOKKOS_INLINE_FUNCTION void forEachOfLine(int line, const Body& body) const
  {
    int at[D];
    coordinates(line * lineLength(), at);
    const int axis = grid_.axisOrder[D - 1], stride = grid_.stride[axis], length = lineLength();
    int node = grid_.nodeIndex(at);
    for (int i = 0; i < length; ++i, ++at[axis], node += stride)
      body(node, grid_.positionOf(at));
  }

  /// Calls body(node, x) with a node of refined cells in a box.
  template <class Body>
  KOKKOS_INLINE_FUNCTION void visitFine(int i, const AxisBox<D>& box, const Body& body) const
  {
    const Vector<D> x = position(numLattice_ + i);
    if (box.holds(x))
      body(grid_.numNodes + i, x);
  }
  KOKKOS_INLINE_FUNCTION int numFine() const { return numFine_; }

  /// Coordinates in the lattice of node k, which is one of the lattice.
  KOKKOS_INLINE_FUNCTION void coordinates(int k, int (&at)[D]) const
  {
    // The fastest axis of the numbering is the fastest here.
    for (int a = D - 1; a >= 0; --a)
    {
      const int axis = grid_.axisOrder[a];
      at[axis] = first_[axis] + k % count_[axis];
      k /= count_[axis];
    }
  }

  KOKKOS_INLINE_FUNCTION bool isOfLattice(int k) const { return k < numLattice_; }

  /// The row of node k in arrays over nodes.
  KOKKOS_INLINE_FUNCTION int node(int k) const
  {
    if (!isOfLattice(k))
      return grid_.numNodes + k - numLattice_;
    int at[D];
    coordinates(k, at);
    return grid_.nodeIndex(at);
  }

  KOKKOS_INLINE_FUNCTION Vector<D> position(int k) const
  {
    if (isOfLattice(k))
    {
      int at[D];
      coordinates(k, at);
      return grid_.positionOf(at);
    }
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = fine_(k - numLattice_, d);
    return x;
  }

  /// The number of a row of arrays over nodes, of no enriched field; -1 where it is not among these nodes.
  KOKKOS_INLINE_FUNCTION int find(int node) const
  {
    if (node >= grid_.numNodes)
      return numLattice_ + node - grid_.numNodes;
    int at[D], k = 0;
    grid_.nodeCoordinates(node, at);
    for (int a = 0; a < D; ++a)
    {
      const int axis = grid_.axisOrder[a], from = at[axis] - first_[axis];
      if (from < 0 || from >= count_[axis])
        return -1;
      k = k * count_[axis] + from;
    }
    return k;
  }

private:
  Grid<D> grid_;
  View<double* [D]> fine_;
  int first_[D] = {}, count_[D] = {};
  int numLattice_ = 1, numFine_;
};

/// The enriched field of a node next to a crack, in kernels.
template <int D>
struct EnrichedFields
{
  Nodes<D> nodes;
  View<int*> field; ///< CrackSet::enrichedField

  explicit EnrichedFields(const State<D>& state) : nodes(state.mesh.nodes), field(state.cracks.enrichedField)
  {
    if (nodes.numOfCracks == 0)
      field = {};
  }

  /// The row of the enriched field of a node, or -1. The table may hold rows of earlier steps for nodes that
  /// no particle reaches any more.
  KOKKOS_INLINE_FUNCTION int of(int node) const
  {
    if (node >= static_cast<int>(field.extent(0)))
      return -1;
    const int row = field(node), i = row - nodes.numLattice;
    return i >= 0 && i < nodes.numOfCracks && nodes.parent(i) == node ? row : -1;
  }
};

/// Calls body(node, x) for the nodes at positions x in a box, those of refined cells and enriched fields
/// included, and for some nodes of the lattice within a cell of it. The cost is that of the box and of
/// refined nodes.
template <int D, class Body>
void forEachNodeIn(const char* label, const State<D>& state, const AxisBox<D>& box, const Body& body)
{
  const BoxNodes<D> all(state, box);
  const EnrichedFields<D> enriched(state);
  const auto withEnriched = KOKKOS_LAMBDA(const int n, const Vector<D>& x)
  {
    body(n, x);
    if (const int row = enriched.of(n); row >= 0 && box.holds(x))
      body(row, x);
  };
  Kokkos::parallel_for(
      label, Kokkos::RangePolicy<ExecSpace>(0, all.numLines()),
      KOKKOS_LAMBDA(const int line) { all.forEachOfLine(line, withEnriched); });
  if (all.numFine() > 0)
    Kokkos::parallel_for(
        label, Kokkos::RangePolicy<ExecSpace>(0, all.numFine()),
        KOKKOS_LAMBDA(const int i) { all.visitFine(i, box, withEnriched); });
  const Nodes<D> nodes = state.mesh.nodes;
  if (nodes.numEnriched > nodes.numOfCracks) // fields of groups of bodies
    Kokkos::parallel_for(
        label, Kokkos::RangePolicy<ExecSpace>(nodes.numOfCracks, nodes.numEnriched),
        KOKKOS_LAMBDA(const int i) {
          const int k = all.find(nodes.parent(i));
          if (k < 0)
            return;
          const Vector<D> x = all.position(k);
          if (box.holds(x))
            body(nodes.numLattice + i, x);
        });
}

} // namespace Rhegma
