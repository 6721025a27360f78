#pragma once
/// Points all over the surface of a body.

#include "geometry/Shape.hpp"

#include <vector>

namespace Rhegma::Geometry
{

/// A point of a surface.
template <int D>
struct SurfacePoint
{
  Vector<D> x;      ///< [m]
  Vector<D> normal; ///< unit vector out of the body
  double size;      ///< of the piece in whose middle it is: a length (2D) or an area (3D) [m^(D-1)]
};

/// Points on the surface of one of a shape's parts where that is the surface of the whole shape: on one side
/// of it there is material, on the other there is not. \param part its number \param spacing between them,
/// about; no larger than half of an edge, a quarter of a circle [m]. Their pieces cover all of the part's
/// surface; of one that the edge of another part cuts, all counts or nothing.
template <int D>
std::vector<SurfacePoint<D>> surfacePoints(const Shape<D>& shape, std::size_t part, double spacing);

} // namespace Rhegma::Geometry
