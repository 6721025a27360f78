#pragma once
/// How the surfaces of cracks divide boxes.

#include "geometry/Cuts.hpp"
#include "surface/CrackMesh.hpp"

#include <vector>

namespace Rhegma::surface
{

/// The cuts of cracks. A crack divides a box that one of its simplices enters, unless one of its fronts is
/// inside: a particle round a front is whole. The distance from a crack is that from the nearest simplex;
/// beyond the facets and vertices at its border the crack is continued straight on. Where several simplices
/// are equally near, at an edge or a vertex that they share, the side is that of the simplex whose plane is
/// farthest away.
///
/// \param meshes are copied
template <int D>
Geometry::Cuts<D> cutsOfMeshes(const std::vector<CrackMesh<D>>& meshes);

} // namespace Rhegma::surface
