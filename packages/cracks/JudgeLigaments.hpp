#pragma once
/// Whether cells resolve the material between a crack and what is next to it
/// (docs/reference/warnings-of-cracks-and-runs.md).

#include "boundary/DomainEdges.hpp"
#include "cracks/CrackedBodies.hpp"

namespace Rhegma::cracks
{

/// Warns of each crack that runs less than two cells from a surface of a body, or comes back to less than
/// three cells from itself: nodes of the material between have no room to strain on their own. Where a crack
/// meets the surface at 14 degrees or more, or turns by a sharp angle, it is near by its shape, and right.
///
/// \param mirrored sides of bodies, which are no surfaces
/// \param meshes of the cracks, in their order, cut to the bodies
template <int D>
void judgeLigaments(const CrackedBodies<D>& bodies, const MirroredSides& mirrored,
                    const std::vector<surface::CrackMesh<D>>& meshes, State<D>& state);

} // namespace Rhegma::cracks
