#pragma once
/// Where a crack comes back to itself.

#include "geometry/NearBoxes.hpp"
#include "surface/CrackMesh.hpp"

namespace Rhegma::surface
{

/// The parts of a mesh that lie near points on it without being connected to them there.
template <int D>
class Returns
{
public:
  /// \param mesh must outlive this
  explicit Returns(const CrackMesh<D>& mesh);

  /// Smallest distance from the points of a simplex that cannot be reached along the mesh from simplices at
  /// the points without going further away than that distance and a slack. In 3D each simplex is looked at
  /// from the point that is nearest to its centroid.
  /// \param start simplices at the points; none: all of the mesh counts as apart \param points not empty [m]
  /// \param radius the largest distance that is of interest, which is returned where nothing is nearer [m]
  /// \param slack in 3D distances of a triangle and of its edges differ by up to their lengths [m]
  double find(const std::vector<int>& start, const std::vector<Vector<D>>& points, double radius,
              double slack) const;

private:
  const CrackMesh<D>& mesh_;
  double longest_ = 0.0; ///< edge of all simplices [m]
  Geometry::NearBoxes<D> boxes_;
};

} // namespace Rhegma::surface
