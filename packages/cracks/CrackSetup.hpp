#pragma once
/// From the scene's points to cracks in the state.

#include "cracks/CrackedBodies.hpp"
#include "plan/Effect.hpp"

namespace Rhegma::cracks
{

/// The meshes of the cracks of a scene, in their order.
///
/// \param state with its lattice; as long as it has no particles, bodies end at their shapes' surfaces
/// \param bodies, edge, cellAtFronts as below \param bodyGroups becomes Crack::bodyGroup of each
///
/// Throws std::invalid_argument, with the section's path, for a crack that is wrong in itself.
template <int D>
std::vector<surface::CrackMesh<D>>
readMeshes(const Teuchos::ParameterList& section, const CrackedBodies<D>& bodies, const State<D>& state,
           double edge, double cellAtFronts, std::vector<std::string>& warnings,
           std::vector<int>& bodyGroups);

/// Reads the cracks of a scene into state.cracks: polylines in 2D, polygons, disks and surfaces from
/// files in 3D (CrackMesh.hpp).
///
/// \param bodies of the scene \param edge of the triangles of surfaces [m]
/// \param cellAtFronts size of the cells at fronts once they are refined [m]
///
/// \return the meshes of the cracks, in their order
///
/// Throws std::invalid_argument, with the section's path, for a crack that is wrong in itself.
template <int D>
std::vector<surface::CrackMesh<D>> readCracks(const Teuchos::ParameterList& section,
                                              const CrackedBodies<D>& bodies, State<D>& state, double edge,
                                              double cellAtFronts);

} // namespace Rhegma::cracks
