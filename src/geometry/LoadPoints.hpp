#pragma once
/// Points of loads, which move with particles.

#include "geometry/Seeds.hpp"
#include "geometry/SurfacePoints.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

/// A point at which a fraction of a load acts.
template <int D>
struct LoadPoint
{
  int particle;     ///< index into the body's seeds
  Vector<D> offset; ///< from the particle's centre to the point, undeformed, along the axes of space [m]
  double fraction;  ///< fraction of the total load [-]; those of a load, added in order, give 1
  /// Sides of the piece of line (2D) or parallelogram (3D) in whose middle the point is, undeformed; zero for
  /// a load at one point [m].
  Vector<D> side[D - 1] = {};
  Vector<D> normal{}; ///< outward, of length 1, where its force may follow it; else zero
};

/// How a line load varies along its line.
enum class Profile
{
  Uniform,
  Parabolic ///< 6 s (1 - s), zero at both ends, as shear over the section of a beam
};

/// One point. Like the points below it must lie within a particle's diagonal of a particle's centre, which
/// every point of the body's surface does; it moves with the nearest particle.
///
/// \param section  the load's section, for messages (`Boundaries > Tip Load`)
///
/// All of these throw std::invalid_argument where a point is too far from the body.
template <int D>
std::vector<LoadPoint<D>> pointLoad(const Seeds<D>& body, const Vector<D>& at, const std::string& section);

/// Points along a segment, about half a particle edge apart, in the middles of equal pieces (midpoint rule).
/// \param around whether pieces are rings around the axis x = 0, so that their fractions are as their radius
template <int D>
std::vector<LoadPoint<D>> lineLoad(const Seeds<D>& body, const Vector<D>& from, const Vector<D>& to,
                                   Profile profile, const std::string& section, bool around = false);

/// Points spread evenly over the parallelogram with a corner and the two sides that start there (3D).
std::vector<LoadPoint<3>> faceLoad(const Seeds<3>& body, const Vector<3>& corner, const Vector<3>& sideA,
                                   const Vector<3>& sideB, const std::string& section);

/// Points of a body's surface, each with the fraction that its piece is of all, and with its normal.
/// \param around as for lineLoad
template <int D>
std::vector<LoadPoint<D>> surfaceLoad(const Seeds<D>& body,
                                      const std::vector<Geometry::SurfacePoint<D>>& surface,
                                      const std::string& section, bool around = false);

} // namespace Rhegma
