#pragma once
/// Nodes that a support has counted already, for sums over supports that hold a node together.

#include "state/State.hpp"

namespace Rhegma
{

/// Row by node, column by axis: 0 where nothing holds it. Grows with the nodes.
template <int D>
void clearMarks(const State<D>& state, View<char**>& held)
{
  const int rows = static_cast<int>(state.mesh.nodes.sums.extent(0));
  if (static_cast<int>(held.extent(0)) < rows)
    held = View<char**>("rhegma::heldNodes", rows, D);
  Kokkos::deep_copy(held, char(0));
}

} // namespace Rhegma
