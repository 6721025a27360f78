#pragma once
/// Normals of cracks and frames of their fronts.

#include "state/CrackSet.hpp"

namespace Rhegma::cracks
{

/// Normals of simplices and vertices from the vertices as they are now.
template <int D>
void updateNormals(const CrackSet<D>& cracks);

/// Positions, directions, normals and lengths of the fronts from the vertices as they are now.
template <int D>
void updateFronts(CrackSet<D>& cracks);

} // namespace Rhegma::cracks
