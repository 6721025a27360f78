#include "transfer/PressedNodes.hpp"

#include "base/SmallLoops.hpp"

namespace Rhegma
{

NodalField pressedNodesField(const std::string& on)
{
  return {{"last step of pressing on " + on, 1, "", "number of the step, from 1 on"}, OnRemesh::Keep};
}

template <int D>
PressedNodes pressedNodes(const State<D>& state, const std::string& on)
{
  return {state.mesh.nodalFields.scalar(pressedNodesField(on).field.name),
          static_cast<double>(state.clock.step)};
}

template <int D>
void keepPressedNodes(const State<D>& state, const std::string& on, int count, const View<int*>& node,
                      const View<double* [D]>& impulse)
{
  if (count == 0)
    return;
  const BorrowedView<double*> lastStep = pressedNodes(state, on).lastStep;
  const auto now = static_cast<double>(state.clock.step + 1);
  parallelForSmall(
      "rhegma::keepPressedNodes", count, KOKKOS_LAMBDA(const int k) {
        bool presses = false;
        for (int d = 0; d < D; ++d)
          presses = presses || impulse(k, d) != 0.0;
        if (presses)
          lastStep(node(k)) = now;
      });
}

template PressedNodes pressedNodes(const State<2>&, const std::string&);
template PressedNodes pressedNodes(const State<3>&, const std::string&);
template void keepPressedNodes(const State<2>&, const std::string&, int, const View<int*>&,
                               const View<double* [2]>&);
template void keepPressedNodes(const State<3>&, const std::string&, int, const View<int*>&,
                               const View<double* [3]>&);

} // namespace Rhegma
