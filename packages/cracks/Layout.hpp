#pragma once
/// The views of a set of cracks from their vertices and simplices.

#include "cracks/CrackMesh.hpp"

namespace Rhegma::cracks
{

/// Makes all views of the set anew, but those over nodes: closed faces, simplices and what lies beyond them,
/// stars, fronts and their facets, normals. The set already has its cracks and its fronts, in the order of
/// frontsOf; a front that has ended has no facet.
template <int D>
void layOut(CrackSet<D>& set, const std::vector<CrackMesh<D>>& meshes, double spacing);

} // namespace Rhegma::cracks
