#pragma once
/// The views of a set of cracks from their vertices and simplices.

#include "state/CrackSet.hpp"
#include "surface/CrackMesh.hpp"

namespace Rhegma::cracks
{

/// Rebuilds all views of the set except those over nodes: closed faces, simplices and what lies beyond them,
/// stars, fronts and their facets, normals. The set already has its cracks and its fronts, in the order of
/// frontsOf; a front that has ended has no facet. 3D fronts that have front nodes keep them: each is on a
/// vertex of its crack, counted from the crack's first, and has a facet that is not negative where a piece of
/// front runs from it to the next.
template <int D>
void layOut(CrackSet<D>& set, const std::vector<surface::CrackMesh<D>>& meshes, double spacing);

} // namespace Rhegma::cracks
