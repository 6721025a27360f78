#pragma once
/// Planes at which a scene is its own mirror image.

#include "state/Types.hpp"

#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Rhegma
{

/// A crack that ends at such a plane goes on beyond it, and its front is square to it.
struct MirrorPlane
{
  int axis = 0;
  double position = 0.0; ///< [m]
};

/// Those of a scene: its boundaries of type Symmetry.
std::vector<MirrorPlane> mirrorPlanes(const Teuchos::ParameterList& scene);

/// Share of a cell within which a vertex of a crack lies on a plane.
constexpr double onMirrorPlane = 0.05;

/// Whether one of the planes goes through a place. \param cell size of the smallest cells [m]
template <int D>
bool isMirrored(const std::vector<MirrorPlane>& planes, const Vector<D>& x, double cell)
{
  return std::any_of(planes.begin(), planes.end(),
                     [&](const MirrorPlane& plane)
                     { return std::fabs(x[plane.axis] - plane.position) < onMirrorPlane * cell; });
}

} // namespace Rhegma
