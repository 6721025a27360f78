#pragma once
/// Nodes with two fields, on which contact in equilibrium acts.

#include "state/State.hpp"

#include <vector>

namespace Rhegma::contact
{

/// The two fields of a node.
template <int D>
struct FaceNode
{
  int plus = 0, minus = 0; ///< node of the field of side +1 and of side -1
  /// Of the faces that it stands for, from side -1 to side +1, as the particles have it [m2]: a uniform
  /// stress s exerts the forces s a and -s a on the fields. Particles that a crack cuts belong to one of its
  /// sides, so that it is not the area of the crack itself, which would leave forces of both signs on the
  /// nodes.
  Vector<D> area{};
  bool isDouble = false; ///< whether particles see both fields: there may be some on one side only
  /// Whether `area` is that of the crack alone: next to a surface of the body there is another part.
  bool isInside = false;
};

/// The nodes with two fields, in the order of the enriched fields. On several ranks those of the rank's
/// window, with the areas that the particles of all ranks give. Collective.
template <int D>
std::vector<FaceNode<D>> findFaceNodes(const State<D>& state);

} // namespace Rhegma::contact
