#include "surface/PlanarPolygon.hpp"

#include "geometry/Cross.hpp"
#include "surface/NearestOnSimplex.hpp"

#include <cmath>

namespace Rhegma::surface
{

void Plane::orientAlong(const Vector<3>& direction)
{
  a = direction - dot(direction, normal) * normal;
  a = (1.0 / norm(a)) * a;
  b = cross(normal, a);
}

Plane planeOf(const std::vector<Vector<3>>& points, double& area)
{
  Vector<3> sum{0.0, 0.0, 0.0}, middle{0.0, 0.0, 0.0};
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    sum = sum + 0.5 * cross(points[k] - points[0], points[(k + 1) % points.size()] - points[0]);
    middle = middle + (1.0 / double(points.size())) * points[k];
  }
  area = norm(sum);
  Plane plane{middle, {}, {}, (1.0 / area) * sum};
  plane.orientAlong(points[1] - points[0]);
  return plane;
}

int nearestEdge(const std::vector<Vector<2>>& outline, const Vector<2>& x, double reach)
{
  int found = -1;
  for (std::size_t k = 0; k < outline.size(); ++k)
    if (const double distance = distanceToSegment(x, outline[k], outline[(k + 1) % outline.size()]);
        distance < reach)
    {
      reach = distance;
      found = static_cast<int>(k);
    }
  return found;
}

std::vector<Vector<2>> ellipseOutline(const Vector<2>& radii, int corners)
{
  const double step = 2.0 * std::acos(-1.0) / corners, stretch = std::sqrt(step / std::sin(step));
  std::vector<Vector<2>> outline;
  for (int k = 0; k < corners; ++k)
  {
    const double angle = 2.0 * std::acos(-1.0) * k / corners;
    outline.push_back({stretch * radii[0] * std::cos(angle), stretch * radii[1] * std::sin(angle)});
  }
  return outline;
}

} // namespace Rhegma::surface
