#include "geometry/SolidInBox.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::Geometry
{

namespace
{

/// A convex polygon in space (3D) or a segment (2D), clipped by planes.
template <int D>
struct Clipped
{
  static constexpr int most = D + 10; ///< points: each of six planes adds one, and rounding few more
  Vector<D> point[most];
  int count = 0;

  /// Keeps what is where sign * (x_axis - at) >= 0.
  void clip(int axis, double sign, double at)
  {
    Vector<D> kept[most];
    int number = 0;
    const int edges = D == 2 ? count - 1 : count;
    const auto beyond = [&](const Vector<D>& x) { return sign * (x[axis] - at); };
    for (int k = 0; k < count && number + 2 <= most; ++k)
    {
      const double here = beyond(point[k]);
      if (here >= 0.0)
        kept[number++] = point[k];
      if (k >= edges)
        continue;
      const Vector<D>& next = point[(k + 1) % count];
      const double there = beyond(next);
      if ((here < 0.0) == (there < 0.0))
        continue;
      // The same point, whichever end comes first: neighbours share their edges.
      const bool inOrder = here < there;
      const double t = inOrder ? here / (here - there) : there / (there - here);
      Vector<D> x = inOrder ? point[k] + t * (next - point[k]) : next + t * (point[k] - next);
      x[axis] = at;
      kept[number++] = x;
    }
    std::copy(kept, kept + number, point);
    count = number;
  }
};

/// Integrals over a part of the box from its lower side along an axis up to the heights of the surface.
template <int D>
struct Moments
{
  double volume = 0.0;
  Vector<D> first{}, second{};

  /// Adds those below one point. \param weight measure of its surroundings, seen along the axis
  void add(const Vector<D>& x, int axis, double weight)
  {
    constexpr double low = -0.5;
    const double height = x[axis] - low;
    volume += weight * height;
    for (int d = 0; d < D; ++d)
    {
      const double mean = d == axis ? 0.5 * (x[d] + low) : x[d];
      const double square = d == axis ? (x[d] * x[d] + x[d] * low + low * low) / 3.0 : x[d] * x[d];
      first[d] += weight * height * mean;
      second[d] += weight * height * square;
    }
  }
};

/// Adds what lies below a segment, seen along an axis. Polynomials of degree three, by the Gauss rule of two
/// points.
void addBelow(const Clipped<2>& clipped, int axis, double sense, Moments<2>& sums)
{
  if (clipped.count < 2)
    return;
  const Vector<2>&a = clipped.point[0], &b = clipped.point[1];
  const int across = 1 - axis;
  // To the right of a segment is outside: one that leaves along the axis runs back along the other one.
  const double length = sense * (axis == 1 ? a[across] - b[across] : b[across] - a[across]);
  static const double off = 0.5 / std::sqrt(3.0);
  for (const double t : {0.5 - off, 0.5 + off})
    sums.add(a + t * (b - a), axis, 0.5 * length);
}

/// The same for a polygon, as a fan of triangles. Degree four, by the rule of six points (D. A. Dunavant:
/// Int. J. Numer. Meth. Eng. 21 (1985) 1129-1148).
void addBelow(const Clipped<3>& clipped, int axis, double sense, Moments<3>& sums)
{
  static const struct
  {
    double weight, at;
  } rule[] = {{0.223381589678011466, 0.445948490915964886}, {0.109951743655321868, 0.091576213509770743}};
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  for (int k = 1; k + 1 < clipped.count; ++k)
  {
    const Vector<3>& a = clipped.point[0];
    const Vector<3> b = clipped.point[k] - a, c = clipped.point[k + 1] - a;
    const double area = 0.5 * sense * (b[i] * c[j] - b[j] * c[i]);
    if (area == 0.0)
      continue;
    for (const auto& ring : rule)
    {
      const double other = 1.0 - 2.0 * ring.at;
      sums.add(a + ring.at * b + ring.at * c, axis, ring.weight * area);
      sums.add(a + other * b + ring.at * c, axis, ring.weight * area);
      sums.add(a + ring.at * b + other * c, axis, ring.weight * area);
    }
  }
}

/// Of an item in the column above the box, in edges of the box from its middle, the axis upwards.
template <int D>
void addItem(const Vector<D> (&corner)[D], int axis, double sense, Moments<D>& sums)
{
  constexpr double half = 0.5;
  const auto ends = [&](int d)
  {
    double low = corner[0][d], high = corner[0][d];
    for (int k = 1; k < D; ++k)
    {
      low = std::min(low, corner[k][d]);
      high = std::max(high, corner[k][d]);
    }
    return std::array<double, 2>{low, high};
  };
  const auto height = ends(axis);
  if (height[1] <= -half)
    return;
  Clipped<D> part;
  part.count = D;
  std::copy(corner, corner + D, part.point);
  for (int d = 0; d < D; ++d)
  {
    if (d == axis)
      continue;
    const auto reach = ends(d);
    if (reach[1] <= -half || reach[0] >= half)
      return;
    if (reach[0] < -half)
      part.clip(d, 1.0, -half);
    if (reach[1] > half)
      part.clip(d, -1.0, half);
  }
  if (height[0] < -half)
    part.clip(axis, 1.0, -half);
  // Above the box the whole height of the box lies below the surface.
  Clipped<D> above = part;
  if (height[1] > half)
  {
    above.clip(axis, 1.0, half);
    for (int k = 0; k < above.count; ++k)
      above.point[k][axis] = half;
    addBelow(above, axis, sense, sums);
    part.clip(axis, -1.0, half);
  }
  addBelow(part, axis, sense, sums);
}

/// Whether bounds overlap a box, along all axes or, along one of them, whatever is on one side of it.
template <int D>
struct Overlaps
{
  Vector<D> lower, upper;
  int axis = -1;
  bool upwards = true;

  bool operator()(const Bounds<D>& bounds) const
  {
    for (int d = 0; d < D; ++d)
    {
      const bool open = d == axis;
      if ((bounds.upper[d] < lower[d] && !(open && !upwards)) ||
          (bounds.lower[d] > upper[d] && !(open && upwards)))
        return false;
    }
    return true;
  }
};

} // namespace

template <int D>
BoxPart<D> partInSolid(const Solid<D>& solid, const Vector<D>& lower, const Vector<D>& upper)
{
  const Simplices<D>& surface = solid.surface();
  Vector<D> facing{};
  Overlaps<D> overlaps{lower, upper};
  solid.tree().boxes().forEach(overlaps, [&](int item) { facing = facing + surface.normalOf(item); });
  int axis = 0;
  for (int d = 1; d < D; ++d)
    axis = std::abs(facing[d]) > std::abs(facing[axis]) ? d : axis;
  overlaps.axis = axis;
  overlaps.upwards = facing[axis] >= 0.0;
  const double up = overlaps.upwards ? 1.0 : -1.0; // the column is turned upwards
  const Vector<D> middle = 0.5 * (lower + upper), edge = upper - lower;
  Moments<D> sums;
  solid.tree().boxes().forEach(overlaps,
                               [&](int item)
                               {
                                 Vector<D> corner[D];
                                 surface.corners(item, corner);
                                 for (Vector<D>& x : corner)
                                 {
                                   for (int d = 0; d < D; ++d)
                                     x[d] = (x[d] - middle[d]) / edge[d];
                                   x[axis] *= up;
                                 }
                                 addItem(corner, axis, up, sums);
                               });
  BoxPart<D> part;
  part.fraction = std::clamp(sums.volume, 0.0, 1.0);
  constexpr double none = 1e-14; // rounding of the sums
  if (!(sums.volume > none))
    return part;
  for (int d = 0; d < D; ++d)
  {
    part.centroid[d] = sums.first[d] / sums.volume;
    // Not below that of a slab, whatever rounding makes of small differences.
    const double slab = part.fraction * part.fraction / 12.0;
    part.variance[d] = std::max(slab, sums.second[d] / sums.volume - part.centroid[d] * part.centroid[d]);
  }
  part.centroid[axis] *= up;
  return part;
}

template BoxPart<2> partInSolid(const Solid<2>&, const Vector<2>&, const Vector<2>&);
template BoxPart<3> partInSolid(const Solid<3>&, const Vector<3>&, const Vector<3>&);

} // namespace Rhegma::Geometry
