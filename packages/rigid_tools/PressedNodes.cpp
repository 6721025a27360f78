#include "rigid_tools/PressedNodes.hpp"

#include "base/SmallLoops.hpp"

namespace Rhegma::rigid_tools
{

NodalField pressedNodesField(const std::string& tool)
{
  return {{"last step of pressing on " + tool, 1, "", "number of the step, from 1 on"}, OnRemesh::Keep};
}

template <int D>
PressedNodes pressedNodes(const State<D>& state, const std::string& tool)
{
  return {state.mesh.nodalFields.scalar(pressedNodesField(tool).field.name),
          static_cast<double>(state.clock.step)};
}

template <int D>
void keepPressedNodes(const State<D>& state, const std::string& tool, const ToolContacts<D>& contacts)
{
  if (contacts.count == 0)
    return;
  const BorrowedView<double*> lastStep = pressedNodes(state, tool).lastStep;
  const auto now = static_cast<double>(state.clock.step + 1);
  const ToolContacts<D> at = contacts;
  parallelForSmall(
      "rhegma::keepNodesThatPressOnTool", contacts.count, KOKKOS_LAMBDA(const int c) {
        bool presses = false;
        for (int d = 0; d < D; ++d)
          presses = presses || at.impulse(c, d) != 0.0;
        if (presses)
          lastStep(at.node(c)) = now;
      });
}

template PressedNodes pressedNodes(const State<2>&, const std::string&);
template PressedNodes pressedNodes(const State<3>&, const std::string&);
template void keepPressedNodes(const State<2>&, const std::string&, const ToolContacts<2>&);
template void keepPressedNodes(const State<3>&, const std::string&, const ToolContacts<3>&);

} // namespace Rhegma::rigid_tools
