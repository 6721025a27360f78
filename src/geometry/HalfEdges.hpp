#pragma once
/// Which triangles meet at edges.

#include <array>
#include <cstdint>
#include <vector>

namespace Rhegma::Geometry
{

/// An edge as a side of a triangle.
struct HalfEdge
{
  std::uint64_t edge; ///< the same for all sides that have the same two points
  int side;           ///< 3 times the triangle, plus the number of the corner that is opposite
  bool inOrder;       ///< from the point with the smaller index to the other

  int triangle() const { return side / 3; }
  int lower() const { return static_cast<int>(edge >> 32); }         ///< the point with the smaller index
  int upper() const { return static_cast<int>(edge & 0xffffffffu); } ///< the other
};

/// The sides of all triangles, those of an edge next to each other.
class HalfEdges
{
public:
  explicit HalfEdges(const std::vector<std::array<int, 3>>& triangles);

  /// Calls visit(first, count) for each edge, with a pointer to its first side.
  template <class Visit>
  void forEachEdge(const Visit& visit) const
  {
    for (std::size_t k = 0; k < sides_.size();)
    {
      std::size_t end = k + 1;
      while (end < sides_.size() && sides_[end].edge == sides_[k].edge)
        ++end;
      visit(&sides_[k], static_cast<int>(end - k));
      k = end;
    }
  }

  /// The triangle over the edge opposite to each corner; -1 where it isn't one.
  std::vector<std::array<int, 3>> neighbours() const;

private:
  std::vector<HalfEdge> sides_;
};

} // namespace Rhegma::Geometry
