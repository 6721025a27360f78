#pragma once
/// Where the two faces of a crack act on the same nodes.

#include "state/State.hpp"

#include <vector>

namespace Rhegma::energy_release
{

/// Which nodes of a crack: those that both faces have, on which opposite forces on the faces cancel, or those
/// with a field for each.
enum class NodesOfFaces
{
  Common,
  Split
};

/// Share of the weights at places on a crack, or ahead of it, that belongs to such nodes. \param places the
/// same on all ranks [m] \return as many, 0 to 1, of all ranks together. Collective.
template <int D>
std::vector<double> shareOfNodes(const State<D>& state, int crack, const std::vector<Vector<D>>& places,
                                 NodesOfFaces which);

} // namespace Rhegma::energy_release
