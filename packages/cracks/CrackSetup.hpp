#pragma once
/// From the scene's points to cracks in the state.

#include "plan/Effect.hpp"

namespace Rhegma::cracks
{

/// Reads the cracks of a scene into state.cracks: polylines in 2D, polygons, disks and surfaces from
/// files in 3D (CrackMesh.hpp).
///
/// \param edge of the triangles of surfaces [m]
///
/// Throws std::invalid_argument, with the section's path, for a crack that is wrong in itself.
template <int D>
void readCracks(const Teuchos::ParameterList& section, State<D>& state, double edge);

} // namespace Rhegma::cracks
