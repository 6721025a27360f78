#pragma once
/// Nodes that pressed on something in the last step, such as a tool.

#include "state/State.hpp"

#include <string>

namespace Rhegma
{

/// Largest gap of particles at which they still touch at nodes where they pressed in the last step, as long
/// as the impulse there is a pressure [cells]. Where the face of a body is not on a row of nodes, strain
/// moves the domains of its particles relative to what they press on.
constexpr double stillClosed = 0.1;

/// The nodal field in which they are stored, so that cells may be refined and runs continued. \param on what
/// they press
NodalField pressedNodesField(const std::string& on);

/// The nodes that pressed in the step before.
struct PressedNodes
{
  BorrowedView<double*> lastStep; ///< of each node: the last step in which it pressed, from 1 on; 0: none
  double before = 0.0;            ///< number of the step before, in the same way

  /// Whether a node did.
  KOKKOS_INLINE_FUNCTION bool operator()(int node) const { return before > 0.0 && lastStep(node) == before; }
};

/// Those that pressed on something. \param on as for pressedNodesField
template <int D>
PressedNodes pressedNodes(const State<D>& state, const std::string& on);

/// Stores the nodes that press in this step for the next one. \param node lattice nodes \param impulse at
/// each of the first `count` of them; zero where it does not press [N s]
template <int D>
void keepPressedNodes(const State<D>& state, const std::string& on, int count, const View<int*>& node,
                      const View<double* [D]>& impulse);

} // namespace Rhegma
