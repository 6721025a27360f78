/// Nodes that pressed on a tool in the last step.

#include "archive/Archive.hpp"
#include "base/SmallLoops.hpp"
#include "rigid_tools/ToolContacts.hpp"

namespace Rhegma::rigid_tools
{

namespace
{

/// Sets the marks of the listed nodes.
template <int D>
void markPressed(const ToolContacts<D>& contacts, char mark)
{
  const View<char*> pressed = contacts.pressed;
  const View<int*> node = contacts.pressedNode;
  parallelForSmall(
      "rhegma::markNodesThatPressOnTool", contacts.numPressed,
      KOKKOS_LAMBDA(const int k) { pressed(node(k)) = mark; });
}

} // namespace

template <int D>
void reservePressed(const State<D>& state, ToolContacts<D>& contacts)
{
  const int nodes = state.mesh.nodes.numLattice;
  if (static_cast<int>(contacts.pressed.extent(0)) >= nodes)
    return;
  contacts.pressed = View<char*>("rhegma::nodesThatPressOnTool", nodes);
  contacts.numPressed = 0;
}

template <int D>
void keepPressedNodes(const State<D>& state, ToolContacts<D>& contacts)
{
  if (contacts.count == 0 && contacts.numPressed == 0)
    return;
  reservePressed(state, contacts);
  markPressed(contacts, 0);
  if (static_cast<int>(contacts.pressedNode.extent(0)) < contacts.count)
    contacts.pressedNode = View<int*>("rhegma::listOfNodesThatPress", 2 * contacts.count);
  contacts.numPressed = 0;
  if (contacts.count == 0)
    return;
  const ToolContacts<D> at = contacts;
  parallelScanSmall(
      "rhegma::listNodesThatPressOnTool", 0, contacts.count,
      KOKKOS_LAMBDA(const int c, int& place, const bool final) {
        bool presses = false;
        for (int d = 0; d < D; ++d)
          presses = presses || at.impulse(c, d) != 0.0;
        if (final && presses)
          at.pressedNode(place) = at.node(c);
        place += presses ? 1 : 0;
      },
      contacts.numPressed);
  markPressed(contacts, 1);
}

template <int D>
void serializePressedNodes(const State<D>& state, ToolContacts<D>& contacts, Archive& archive)
{
  View<int*> nodes("rhegma::listOfNodesThatPress", contacts.numPressed);
  if (!archive.loads() && contacts.numPressed > 0)
    Kokkos::deep_copy(nodes, Kokkos::subview(contacts.pressedNode, std::make_pair(0, contacts.numPressed)));
  archive("pressed_nodes", nodes);
  if (!archive.loads())
    return;
  reservePressed(state, contacts);
  markPressed(contacts, 0);
  contacts.pressedNode = nodes;
  contacts.numPressed = static_cast<int>(nodes.extent(0));
  markPressed(contacts, 1);
}

template void reservePressed(const State<2>&, ToolContacts<2>&);
template void reservePressed(const State<3>&, ToolContacts<3>&);
template void keepPressedNodes(const State<2>&, ToolContacts<2>&);
template void keepPressedNodes(const State<3>&, ToolContacts<3>&);
template void serializePressedNodes(const State<2>&, ToolContacts<2>&, Archive&);
template void serializePressedNodes(const State<3>&, ToolContacts<3>&, Archive&);

} // namespace Rhegma::rigid_tools
