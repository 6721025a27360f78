#pragma once
/// Nodal values during a step.

#include "base/Types.hpp"

#include <utility>

namespace Rhegma
{

/// Nodal values, a row a node. Quantities that a transfer needs together are in one row, so that the
/// contribution of a particle is a few vector operations a node: mass and momentum fill one register of four
/// numbers, forces another. Rows 0 .. numLattice - 1 are the lattice's nodes and then those of refined cells
/// (Tree.hpp); rows past them are enriched fields: first those of nodes next to a crack, then the
/// fields of groups of bodies that meet at a node. Effects claim them anew in each step (StencilEditor).
template <int D>
struct Nodes
{
  static constexpr int sumWidth = 8;
  static constexpr int motionWidth = D == 2 ? 4 : 8;
  static constexpr int projectionWidth = D == 2 ? 2 : 4;
  static constexpr int massAt = 0;
  static constexpr int momentumAt = 1;
  static constexpr int forceAt = 4;
  static constexpr int accelerationAt = D == 2 ? 2 : 4;

  View<double* [sumWidth]> sums;      ///< mass [kg], momentum [kg m/s], force [N]
  View<double* [motionWidth]> motion; ///< velocity after the solve [m/s], acceleration [m/s2]
  View<double* [projectionWidth]>
      projection; ///< momentum, then velocity, that strains the particles (MUSL) [m/s]

  View<int*> active;   ///< nodes that particles can reach until the next sort
  View<char*> foreign; ///< not 0 for nodes of the lattice that another rank owns; empty where there is one
  View<int*> parent;   ///< node at whose position each enriched field is
  int numLattice = 0;  ///< nodes of the lattice and of refined cells
  int numEnriched = 0; ///< enriched fields in use
  int numOfCracks = 0; ///< the first of them: those of nodes next to a crack, at most one a node

  int numActive() const { return static_cast<int>(active.extent(0)) + numEnriched; }

  /// Allocates rows for enriched fields.
  void reserve(int lattice, int enriched)
  {
    const int rows = lattice + enriched;
    numLattice = lattice;
    if (static_cast<int>(sums.extent(0)) >= rows)
      return;
    sums = View<double* [sumWidth]>("rhegma::nodeSums", rows);
    motion = View<double* [motionWidth]>("rhegma::nodeMotion", rows);
    projection = View<double* [projectionWidth]>("rhegma::nodeProjection", rows);
  }

  /// Gives up all enriched fields.
  void releaseEnriched() { numEnriched = numOfCracks = 0; }

  /// Makes enriched fields after those in use. Their parents are the caller's to fill in, those of the fields
  /// in use stay. Nodal values are lost where there are not enough rows. \return the row of the first
  int claimEnriched(int count)
  {
    const int first = numLattice + numEnriched, all = numEnriched + count;
    if (static_cast<int>(parent.extent(0)) < all)
    {
      const View<int*> more("rhegma::enrichedFieldParent", 2 * all);
      const auto used = std::make_pair(0, numEnriched);
      if (numEnriched > 0)
        Kokkos::deep_copy(Kokkos::subview(more, used), Kokkos::subview(parent, used));
      parent = more;
    }
    if (static_cast<int>(sums.extent(0)) < numLattice + all)
      reserve(numLattice, 2 * all);
    numEnriched = all;
    return first;
  }

  /// The same for those of nodes next to a crack, which come before all others.
  void claimFieldsOfCracks(int count)
  {
    claimEnriched(count);
    numOfCracks = numEnriched;
  }
};

/// The i-th node in use, an enriched field included.
template <int D>
KOKKOS_INLINE_FUNCTION int activeNode(const Nodes<D>& nodes, int i)
{
  const int lattice = static_cast<int>(nodes.active.extent(0));
  return i < lattice ? nodes.active(i) : nodes.numLattice + i - lattice;
}

/// The node, no enriched field, at whose position a node is.
template <int D>
KOKKOS_INLINE_FUNCTION int latticeNode(const Nodes<D>& nodes, int node)
{
  return node < nodes.numLattice ? node : nodes.parent(node - nodes.numLattice);
}

/// Whether sums over nodes count a node on this rank; of a node on several ranks, one counts it.
template <int D>
KOKKOS_INLINE_FUNCTION bool isOwnedByThisRank(const Nodes<D>& nodes, int node)
{
  return nodes.foreign.extent(0) == 0 || nodes.foreign(latticeNode(nodes, node)) == 0;
}

} // namespace Rhegma
