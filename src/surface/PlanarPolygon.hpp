#pragma once
/// Planar polygons in 3D.

#include "base/Types.hpp"

#include <vector>

namespace Rhegma::surface
{

/// A plane with axes a and b; its normal is a x b.
struct Plane
{
  Vector<3> origin, a, b, normal;

  Vector<2> inPlane(const Vector<3>& x) const { return {dot(x - origin, a), dot(x - origin, b)}; }
  Vector<3> in3D(const Vector<2>& x) const { return origin + x[0] * a + x[1] * b; }

  /// Sets a to the unit vector along a direction projected on the plane, and b normal to it.
  void orientAlong(const Vector<3>& direction);
};

/// The mean plane of a polygon, with the normal about which its points are counter-clockwise (Newell's sum)
/// and a along its first edge. \param area of the polygon [m2]; where it is zero, the plane is undefined
Plane planeOf(const std::vector<Vector<3>>& points, double& area);

/// The edge of a closed outline that is nearest to a point and within `reach` of it [m]: the number of its
/// first point, or -1.
int nearestEdge(const std::vector<Vector<2>>& outline, const Vector<2>& x, double reach);

/// A regular polygon inside of an ellipse, stretched to its area. \param radii along both axes [m]
std::vector<Vector<2>> ellipseOutline(const Vector<2>& radii, int corners);

} // namespace Rhegma::surface
