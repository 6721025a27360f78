#pragma once
/// A search tree of the segments (2D) or triangles (3D) of a surface.

#include "geometry/NearBoxes.hpp"
#include "geometry/NearestOnSimplex.hpp"

#include <array>
#include <vector>

namespace Rhegma::Geometry
{

/// Points, and the segments or triangles between them.
template <int D>
struct Simplices
{
  std::vector<Vector<D>> points;         ///< in any unit of length
  std::vector<std::array<int, D>> items; ///< indices of points

  /// The corners of an item.
  void corners(int item, Vector<D> (&corner)[D]) const
  {
    for (int i = 0; i < D; ++i)
      corner[i] = points[items[item][i]];
  }
  /// Smallest bounds of an item.
  Bounds<D> boundsOf(int item) const;
  /// Vector of an item's area (length in 2D) along its normal: to the right of a segment, so out of a polygon
  /// whose points are counter-clockwise; by the right-hand rule of a triangle, of twice its area.
  Vector<D> normalOf(int item) const;
};

/// The item that is nearest to a point.
template <int D>
struct NearestItem
{
  int item = -1; ///< -1: none within the distance
  double squaredDistance = 0.0;
  Foot<D> foot{};
};

/// A search tree of items, which it keeps a reference to. The order of corners may change later, positions
/// not.
template <int D>
class SimplexTree
{
public:
  explicit SimplexTree(const Simplices<D>& simplices);

  /// The nearest item to x; of equally near ones the first. \param within no farther items are looked for
  /// \param guess an item that may be near, by which the search is faster; its result is the same
  NearestItem<D> nearest(const Vector<D>& x, double within, int guess = -1) const;

  /// Calls visit(item, sign) for the items that a ray from x meets; the sign is 1 where the ray leaves
  /// through the item, that is along its normal, else -1. Signs of a closed surface add up to 1 inside and 0
  /// outside, to rounding of positions: a ray along the common edge of items meets one of them.
  template <class Visit>
  void meetRay(const Vector<D>& x, const Visit& visit) const
  {
    boxes_.forEach([&](const Bounds<D>& bounds) { return mayMeet(x, bounds); },
                   [&](int item)
                   {
                     if (const int sign = meetingOf(x, item))
                       visit(item, sign);
                   });
  }

  const NearBoxes<D>& boxes() const { return boxes_; }

private:
  bool mayMeet(const Vector<D>& x, const Bounds<D>& bounds) const;
  int meetingOf(const Vector<D>& x, int item) const;

  const Simplices<D>& simplices_;
  NearBoxes<D> boxes_;
  double slack_; ///< rounding of positions
};

} // namespace Rhegma::Geometry
