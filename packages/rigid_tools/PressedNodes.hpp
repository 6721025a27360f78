#pragma once
/// Nodes that pressed on a tool in the last step.

#include "rigid_tools/ToolContacts.hpp"

#include <string>

namespace Rhegma::rigid_tools
{

/// The nodal field in which they are stored, so that cells may be refined and runs continued. \param tool its
/// name
NodalField pressedNodesField(const std::string& tool);

/// The nodes that pressed on a tool in the step before.
struct PressedNodes
{
  BorrowedView<double*> lastStep; ///< of each node: the last step in which it pressed, from 1 on; 0: none
  double before = 0.0;            ///< number of the step before, in the same way

  /// Whether a node did.
  KOKKOS_INLINE_FUNCTION bool operator()(int node) const { return before > 0.0 && lastStep(node) == before; }
};

/// Those of a tool. \param tool its name
template <int D>
PressedNodes pressedNodes(const State<D>& state, const std::string& tool);

/// Stores the nodes that press on a tool in this step for the next one. \param tool its name
template <int D>
void keepPressedNodes(const State<D>& state, const std::string& tool, const ToolContacts<D>& contacts);

} // namespace Rhegma::rigid_tools
