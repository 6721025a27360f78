#pragma once
/// A choice of a body's surface, by where it comes from, where it is and which way it faces.

#include "geometry/SurfacePoints.hpp"

#include <optional>
#include <vector>

namespace Rhegma::Geometry
{

/// What the normals of a surface must be like.
template <int D>
struct NormalRange
{
  Vector<D> direction;      ///< of any length but zero
  bool around = false;      ///< normals must be near perpendicular to it, else near it
  double largestAngle = 0.; ///< from the direction, or from the plane perpendicular to it [degrees]

  bool holds(const Vector<D>& normal) const;
};

/// All of a surface, less what each member that is given leaves out.
template <int D>
struct SurfaceChoice
{
  std::optional<std::size_t> part; ///< number of the shape's part that it comes from
  std::optional<Bounds<D>> box;    ///< in which it lies
  std::optional<NormalRange<D>> facing;
};

/// Points of the chosen surface (surfacePoints), each piece once where the surfaces of parts coincide.
/// \param spacing between them, about [m]
template <int D>
std::vector<SurfacePoint<D>> chosenPoints(const Shape<D>& shape, const SurfaceChoice<D>& choice,
                                          double spacing);

} // namespace Rhegma::Geometry
