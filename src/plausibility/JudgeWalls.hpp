#pragma once
/// Walls and gaps of a body that its parts leave together.

#include "boundary/DomainEdges.hpp"
#include "geometry/Shape.hpp"
#include "plausibility/Judges.hpp"

namespace Rhegma
{

/// Warns where a body is thinner than two cells, or open by less than two cells, over a length of four: along
/// the normals from points all over its surface, to the surface opposite. A tip or notch of 27 degrees or
/// more is so only over less.
///
/// \param judged of each part whether it is known to be thin itself: its surface is left out
/// \param name of the body
template <int D>
void judgeWalls(const State<D>& state, const MirroredSides& mirrored, const Shape<D>& shape,
                const std::vector<char>& judged, const std::string& name, Messages& messages);

} // namespace Rhegma
