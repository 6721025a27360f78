#pragma once
/// Nodes around a front, and which of them a crack splits.

#include "energy_release/WholeNodes.hpp"
#include "state/State.hpp"

#include <set>
#include <vector>

namespace Rhegma::energy_release
{

/// Whether a node of the whole lattice lies behind a front, so that each side of the crack has its own value
/// there.
class SplitNodes
{
public:
  /// Collective. \param radius around the front of the nodes that will be asked for [m]
  SplitNodes(const State<2>& state, const CrackFront<2>& front, double radius);
  bool operator()(int node) const;

private:
  View<int*>::HostMirror side_;
  std::set<int> split_; ///< where there are several ranks
  bool many_;
  WholeNodes positions_;
  CrackFront<2> front_;
};

/// This rank's own nodes within `radius` of a position along each axis, where there are several ranks.
std::vector<int> ownNodesAround(const State<2>& state, const Vector<2>& centre, double radius);

} // namespace Rhegma::energy_release
