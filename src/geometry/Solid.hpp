#pragma once
/// A solid that is bounded by segments (2D) or triangles (3D).

#include "geometry/SimplexTree.hpp"

#include <cstdint>

namespace Rhegma::Geometry
{

/// The inside of a closed surface that does not meet itself.
template <int D>
class Solid
{
public:
  /// \param surface every facet of an item (point of a segment, edge of a triangle) belongs to two items; all
  /// normals point out of the solid
  /// \param resolution rounding of positions, below which the height of a triangle does not count
  Solid(Simplices<D> surface, double resolution);
  Solid(const Solid&) = delete;
  Solid& operator=(const Solid&) = delete;

  /// Distance from the surface, positive inside and negative outside, in the unit of the surface. The side
  /// follows from the normal at the nearest point, of edges and points the mean by the angles between items
  /// (J. A. Baerentzen, H. Aanaes: IEEE Trans. Vis. Comput. Graph. 11 (2005) 243-253), and where that is
  /// uncertain from a ray. \param within a larger distance is given as this one
  double depth(const Vector<D>& x, double within) const;

  const Bounds<D>& bounds() const { return bounds_; }
  const Simplices<D>& surface() const { return surface_; }
  const SimplexTree<D>& tree() const { return tree_; }
  /// Area in 2D.
  double volume() const;

private:
  bool isInside(const Vector<D>& x) const;
  /// The depth of a point whose nearest item is known.
  double depthFrom(const Vector<D>& x, const NearestItem<D>& nearest) const;
  /// Out of the solid at the nearest point; zero where it is not certain.
  Vector<D> normalAt(const NearestItem<D>& nearest) const;
  void addNormals(double resolution);

  std::uint64_t number_; ///< of all solids that there have been
  Simplices<D> surface_;
  SimplexTree<D> tree_;
  Bounds<D> bounds_;
  std::vector<Vector<D>> normals_;             ///< unit vectors of items; zero of those without height
  std::vector<Vector<D>> pointNormals_;        ///< weighted by angles; zero where an item has no height
  std::vector<std::array<int, D>> neighbours_; ///< over the edge opposite to each corner (3D)
};

} // namespace Rhegma::Geometry
