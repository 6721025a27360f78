#pragma once
/// Volume, centroid and second moments of the part of a box that lies in a region.

#include "geometry/Frame.hpp"

#include <array>
#include <functional>

namespace Rhegma::Geometry
{

/// How much of a box a region holds, as far as that is certain.
enum class Coverage
{
  None,
  Unknown,
  Whole
};

/// The points by which a box is judged.
template <int D>
struct BoxPoints
{
  Vector<D> centre;                          ///< [m]
  std::array<Vector<D>, (1 << D)> corners{}; ///< bit d of the index: the upper one along axis d [m]
  double reach = 0.0;                        ///< half the diagonal [m]
};

/// The part of a box that lies in a region.
template <int D>
struct BoxPart
{
  double fraction = 0.0; ///< of the box's volume
  Vector<D> centroid{};  ///< from the box's centre, in edges of the box
  Vector<D> variance{};  ///< mean square distance from the centroid along each axis, in squared edges
};

/// A region of space.
template <int D>
struct Region
{
  /// Positive inside, negative outside [m]; between two points it changes by no more than their distance.
  std::function<double(const Vector<D>&)> depth;
  /// Of a box.
  std::function<Coverage(const BoxPoints<D>&)> coverage;
  /// The part of a box along the region's own axes, in them: middle, edges. Empty where partOfBox must find
  /// it.
  std::function<BoxPart<D>(const Vector<D>&, const Vector<D>&)> exact{};
};

/// A box along given axes.
template <int D>
struct OrientedBox
{
  Vector<D> centre; ///< [m]
  Vector<D> edge;   ///< edge lengths along the axes [m]
  Axes<D> axes;     ///< unit vectors
};

/// Part of a box in a region.
///
/// The box is halved along all axes until the depth is linear in each piece to 2e-3 of the shortest edge.
/// There the pieces are cut, as simplices, by the plane of zero depth, exactly. So plane surfaces are exact;
/// a surface of radius R is replaced by chords whose sag is at most 2e-3 edges, which changes the area of a
/// disk or the volume of a ball of 8 edges across by 5e-4 at most. Edges and corners of the surface inside
/// the box are rounded over at most 1/128 edge in 2D and 1/16 in 3D.
template <int D>
BoxPart<D> partOfBox(const OrientedBox<D>& box, const Region<D>& region);

} // namespace Rhegma::Geometry
