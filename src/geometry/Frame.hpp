#pragma once
/// The axes of a body: a rotation about a point.

#include "base/Types.hpp"

#include <array>

namespace Rhegma::Geometry
{

/// Unit vectors of the axes of a body in global coordinates; orthogonal and right-handed.
template <int D>
using Axes = std::array<Vector<D>, D>;

/// Global axes.
template <int D>
Axes<D> spaceAxes();

/// Global axes rotated counter-clockwise by an angle.
///
/// \param degrees  angle [degrees]
/// \param about    axis of the rotation in 3D, of any length but zero (Rodrigues' formula); in 2D the
/// rotation is in the plane
Axes<2> turnedAxes(double degrees);
Axes<3> turnedAxes(double degrees, const Vector<3>& about);

/// A box with sides along the axes.
template <int D>
struct Bounds
{
  Vector<D> lower; ///< [m]
  Vector<D> upper; ///< [m]

  Vector<D> centre() const { return 0.5 * (lower + upper); }
  void include(const Vector<D>& x);
  void include(const Bounds& other);
  /// All 2^D corners; bit d of the index says whether the corner is the upper one along axis d.
  std::array<Vector<D>, (1 << D)> corners() const;
};

/// Empty bounds.
template <int D>
Bounds<D> emptyBounds();

/// Coordinates of a body: a rotation about `centre`, which has the same coordinates in both frames.
template <int D>
struct Frame
{
  Axes<D> axes;
  Vector<D> centre; ///< [m]

  Vector<D> toOwn(const Vector<D>& x) const;
  Vector<D> toSpace(const Vector<D>& own) const;
};

} // namespace Rhegma::Geometry
