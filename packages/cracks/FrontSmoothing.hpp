#pragma once
/// Smoothing of a front in 3D by a curvature flux along it.

#include "state/CrackSet.hpp"
#include "surface/GrowingSurface.hpp"

#include <vector>

namespace Rhegma::cracks
{

/// Moves a part of the advance of points with a larger curvature to their neighbours, with the energy of the
/// new faces. The area that the front passes stays the same, and so does a circle.
///
/// A neighbour may receive an advance although its own driving force is below its resistance: the driving
/// force is a mean over cells on both sides, so that a single point behind its neighbours would never
/// advance. A point whose driving force is below half of its resistance at rest does not receive any.
///
/// \param lines the front before it advances \param nodes its front nodes, in the same order \param cells
/// size of the cells at each point [m] \param mirrored whether each point lies on a plane of symmetry, where
/// a front is square to it; other ends have no curvature to compare with and stay as they are \param advances
/// the advance of each point, and the resistance of points at rest; lengths and toughness change. The sum of
/// advance times tributary length times toughness is conserved
void smoothAlongFront(const surface::GrowingSurface& surface, const surface::FrontLines<3>& lines,
                      const std::vector<FrontNode<3>>& nodes, const std::vector<double>& cells,
                      const std::vector<bool>& mirrored, std::vector<FrontNodeAdvance<3>>& advances);

} // namespace Rhegma::cracks
