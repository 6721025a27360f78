#include "geometry/Primitives.hpp"

#include <algorithm>
#include <limits>

namespace Rhegma::Geometry
{
namespace
{

/// Rounding of coordinates may move a point off a surface by a few ulps of the body's size; mirror images of
/// a point must then still be both inside or both outside.
constexpr double surfaceTolerance = 1.0e-12;

double cross(const Vector<2>& a, const Vector<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

double largestSide(const Vector<2>& a, const Vector<2>& b)
{
  return std::max(std::abs(b[0] - a[0]), std::abs(b[1] - a[1]));
}

bool onEdge(const Vector<2>& x, const Vector<2>& a, const Vector<2>& b, double tolerance)
{
  const Vector<2> edge = b - a;
  const double lengthSquared = dot(edge, edge);
  const double s = lengthSquared > 0.0 ? std::clamp(dot(x - a, edge) / lengthSquared, 0.0, 1.0) : 0.0;
  return norm(x - a - s * edge) <= tolerance;
}

/// Distance to the nearest edge, negative outside by the even-odd rule.
double depthInPolygon(const std::vector<Vector<2>>& points, const Vector<2>& x)
{
  double square = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++)
  {
    const Vector<2>& a = points[j];
    const Vector<2>& b = points[i];
    const Vector<2> edge = b - a;
    const double lengthSquared = dot(edge, edge);
    const double s = lengthSquared > 0.0 ? std::clamp(dot(x - a, edge) / lengthSquared, 0.0, 1.0) : 0.0;
    const Vector<2> away = x - a - s * edge;
    square = std::min(square, dot(away, away));
    if ((a[1] > x[1]) != (b[1] > x[1]) && x[0] < a[0] + (x[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
      inside = !inside;
  }
  return inside ? std::sqrt(square) : -std::sqrt(square);
}

/// Points within the tolerance of an edge are inside.
bool insidePolygon(const std::vector<Vector<2>>& points, const Vector<2>& x)
{
  Bounds<2> box = emptyBounds<2>();
  for (const auto& p : points)
    box.include(p);
  const double tolerance = surfaceTolerance * largestSide(box.lower, box.upper);
  for (int d = 0; d < 2; ++d)
    if (x[d] < box.lower[d] - tolerance || x[d] > box.upper[d] + tolerance)
      return false;
  return depthInPolygon(points, x) >= -tolerance;
}

} // namespace

template <int D>
bool Box<D>::contains(const Vector<D>& own) const
{
  for (int d = 0; d < D; ++d)
  {
    const double tolerance = surfaceTolerance * (corners.upper[d] - corners.lower[d]);
    if (own[d] < corners.lower[d] - tolerance || own[d] > corners.upper[d] + tolerance)
      return false;
  }
  return true;
}

template <int D>
double Box<D>::depth(const Vector<D>& own) const
{
  double least = std::numeric_limits<double>::infinity();
  for (int d = 0; d < D; ++d)
    least = std::min({least, own[d] - corners.lower[d], corners.upper[d] - own[d]});
  return least;
}

template <int D>
Bounds<D> Box<D>::bounds(const Frame<D>& frame) const
{
  Bounds<D> result = emptyBounds<D>();
  for (const auto& corner : corners.corners())
    result.include(frame.toSpace(corner));
  return result;
}

template <int D>
bool Ball<D>::contains(const Vector<D>& own) const
{
  return norm(own - centre) <= radius * (1.0 + surfaceTolerance);
}

template <int D>
double Ball<D>::depth(const Vector<D>& own) const
{
  return radius - norm(own - centre);
}

template <int D>
Bounds<D> Ball<D>::bounds(const Frame<D>& frame) const
{
  const Vector<D> middle = frame.toSpace(centre);
  Bounds<D> result{middle, middle};
  for (int d = 0; d < D; ++d)
  {
    result.lower[d] -= radius;
    result.upper[d] += radius;
  }
  return result;
}

template <int D>
bool Cylinder<D>::contains(const Vector<D>& own) const
{
  const Vector<D> axis = to - from;
  const double s = dot(own - from, axis) / dot(axis, axis);
  if (s < -surfaceTolerance || s > 1.0 + surfaceTolerance)
    return false;
  return norm(own - from - s * axis) <= radius * (1.0 + surfaceTolerance);
}

template <int D>
double Cylinder<D>::depth(const Vector<D>& own) const
{
  const double length = norm(to - from);
  const Vector<D> along = (1.0 / length) * (to - from);
  const double s = dot(own - from, along);
  return std::min({s, length - s, radius - norm(own - from - s * along)});
}

template <int D>
Bounds<D> Cylinder<D>::bounds(const Frame<D>& frame) const
{
  const Vector<D> start = frame.toSpace(from);
  const Vector<D> end = frame.toSpace(to);
  const Vector<D> along = (1.0 / norm(end - start)) * (end - start);
  Vector<D> reach; // of the end disks
  for (int d = 0; d < D; ++d)
    reach[d] = radius * std::sqrt(std::max(0.0, 1.0 - along[d] * along[d]));
  Bounds<D> result = emptyBounds<D>();
  for (const auto& end_ : {start, end})
  {
    result.include(end_ - reach);
    result.include(end_ + reach);
  }
  return result;
}

template <int D>
bool Polygon<D>::contains(const Vector<D>& own) const
{
  if (D == 3)
  {
    const double tolerance = surfaceTolerance * (top - bottom);
    if (own[D - 1] < bottom - tolerance || own[D - 1] > top + tolerance)
      return false;
  }
  return insidePolygon(points, {{own[0], own[1]}});
}

template <int D>
double Polygon<D>::depth(const Vector<D>& own) const
{
  const double inPlane = depthInPolygon(points, {{own[0], own[1]}});
  return D == 2 ? inPlane : std::min({inPlane, own[D - 1] - bottom, top - own[D - 1]});
}

template <int D>
Bounds<D> Polygon<D>::bounds(const Frame<D>& frame) const
{
  Bounds<D> result = emptyBounds<D>();
  for (const auto& p : points)
    for (const double height : {bottom, top})
    {
      Vector<D> corner;
      corner[D - 1] = height; // overwritten by y in 2D
      corner[0] = p[0];
      corner[1] = p[1];
      result.include(frame.toSpace(corner));
    }
  return result;
}

double signedArea(const std::vector<Vector<2>>& points)
{
  double twice = 0.0;
  for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++)
    twice += cross(points[j] - points[0], points[i] - points[0]);
  return 0.5 * twice;
}

std::array<int, 2> crossingEdges(const std::vector<Vector<2>>& points)
{
  const int n = static_cast<int>(points.size());
  for (int i = 0; i < n; ++i)
    for (int j = i + 2; j < n; ++j)
    {
      const bool neighbours = i == 0 && j == n - 1;
      if (!neighbours && segmentsMeet(points[i], points[i + 1], points[j], points[(j + 1) % n]))
        return {i, j};
    }
  return {-1, -1};
}

bool segmentsMeet(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c, const Vector<2>& d)
{
  // Of edges on one line they are rounding, of any sign.
  const double zero = 1e-12 * (dot(b - a, b - a) + dot(c - a, c - a) + dot(d - a, d - a) + dot(d - c, d - c));
  const auto side = [zero](double product) { return std::fabs(product) > zero ? product : 0.0; };
  const double abc = side(cross(b - a, c - a)), abd = side(cross(b - a, d - a));
  const double cda = side(cross(d - c, a - c)), cdb = side(cross(d - c, b - c));
  if (((abc > 0.0) != (abd > 0.0)) && ((cda > 0.0) != (cdb > 0.0)) && abc * abd < 0.0 && cda * cdb < 0.0)
    return true;
  return onEdge(c, a, b, 0.0) || onEdge(d, a, b, 0.0) || onEdge(a, c, d, 0.0) || onEdge(b, c, d, 0.0);
}

template struct Box<2>;
template struct Box<3>;
template struct Ball<2>;
template struct Ball<3>;
template struct Cylinder<2>;
template struct Cylinder<3>;
template struct Polygon<2>;
template struct Polygon<3>;

} // namespace Rhegma::Geometry
