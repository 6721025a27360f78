#pragma once
/// How far a front is from cracks.

#include "state/CrackSet.hpp"

namespace Rhegma::energy_release
{

/// Largest radius round a front that stays a cell away from other cracks, and from what of its own crack is
/// not connected to the front inside the radius: a crack that turns back is as another one where it comes
/// near again. Up to two cells the radius may reach them.
///
/// In 3D distances are those from the nodes of the front, each to the simplices that are nearest to it.
/// \param radius the largest that is of interest, which is returned where nothing is nearer [m]
/// \param cell size of the cells at the front: by less than 1.5 of it a crack may come back [m]
template <int D>
double clearOfCracks(const CrackSet<D>& cracks, const CrackFront<D>& front, double radius, double cell);

} // namespace Rhegma::energy_release
