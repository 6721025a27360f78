#pragma once
/// Ripples of a front in 3D.

#include "state/CrackSet.hpp"
#include "surface/GrowingSurface.hpp"

#include <vector>

namespace Rhegma::cracks
{

/// Lets points that bulge more than their neighbours give of what they are to advance to these, the energy of
/// the faces with it. The area that the front passes stays the same, and so does a circle.
///
/// A neighbour takes though it is not to advance by itself: what drives it is known as a mean over cells on
/// both sides, which a point does not raise that is left behind alone, so that it would stay. One that is
/// driven by less than half of what it resists with at rest is held by more than that: its mean has half of
/// its weight where its neighbours' have.
///
/// \param lines the front before it advances \param nodes its front nodes, in the same order
/// \param cells size of the cells at each point [m]
/// \param mirrored whether each point lies on a plane of symmetry, where a front is square to it; other ends
/// have no curvature to compare with and stay as they are
/// \param advances what each point is asked to do, and what one that stays resists with; lengths and
/// toughness change. The sum of length times share times toughness stays the same
void smoothAlongFront(const surface::GrowingSurface& surface, const surface::FrontLines<3>& lines,
                      const std::vector<FrontNode<3>>& nodes, const std::vector<double>& cells,
                      const std::vector<bool>& mirrored, std::vector<FrontNodeAdvance<3>>& advances);

} // namespace Rhegma::cracks
