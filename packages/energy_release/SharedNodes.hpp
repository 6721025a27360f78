#pragma once
/// Where the two faces of a crack act on the same nodes.

#include "state/State.hpp"

#include <vector>

namespace Rhegma::energy_release
{

/// Fraction of the weights at positions on a crack that belongs to nodes that both faces have, on which
/// opposite forces on the faces cancel. \param positions the same on all ranks [m] \return as many, 0 to 1,
/// of all ranks together. Collective.
template <int D>
std::vector<double> fractionOfNodes(const State<D>& state, int crack,
                                    const std::vector<Vector<D>>& positions);

} // namespace Rhegma::energy_release
