#pragma once
/// Marks of nodes that supports hold.

#include "base/SmallLoops.hpp"
#include "state/State.hpp"

namespace Rhegma
{

/// Clears the marks of nodes that a support has counted already, for sums over supports that hold a node
/// together. Row by node, column by axis: 0 where nothing holds it. Grows with the nodes.
template <int D>
void clearMarks(const State<D>& state, View<char**>& held)
{
  const int rows = static_cast<int>(state.mesh.nodes.sums.extent(0));
  if (static_cast<int>(held.extent(0)) < rows)
    held = View<char**>("rhegma::heldNodes", rows, D);
  Kokkos::deep_copy(held, char(0));
}

/// Marks the axes along which supports hold listed nodes, of all their fields alike. \param node lattice
/// nodes \param held a row for each of the first `count` of them, not 0 along an axis that is held
template <int D>
void markHeldAxes(const State<D>& state, const View<int*>& node, int count, const View<char* [D]>& held)
{
  const NodePositions<D> positions = nodePositions(state);
  for (const NodeConstraint<D>& constraint : state.motion.constraints)
    parallelForSmall(
        "rhegma::markHeldAxes", count, KOKKOS_LAMBDA(const int k) {
          if (constraint.appliesAt(positions(node(k))))
            for (int d = 0; d < D; ++d)
              held(k, d) = constraint.holds[d] ? char(1) : held(k, d);
        });
}

} // namespace Rhegma
