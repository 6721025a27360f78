#pragma once
/// Symmetry planes of a scene.

#include <Teuchos_ParameterList.hpp>

#include <cmath>
#include <vector>

namespace Rhegma
{

/// A crack that ends at such a plane continues beyond it, and its front is normal to it.
struct MirrorPlane
{
  int axis = 0;
  double position = 0.0; ///< [m]
};

/// The planes of symmetry of a scene, by its boundaries (BoundaryType::region).
std::vector<MirrorPlane> mirrorPlanes(const Teuchos::ParameterList& scene);

/// Whether a point of a crack lies on a plane, to a twentieth of a cell. \param along the plane's axis [m]
/// \param cell size of the cells there [m]
inline bool isOn(const MirrorPlane& plane, double along, double cell)
{
  return std::fabs(along - plane.position) < 0.05 * cell;
}

} // namespace Rhegma
