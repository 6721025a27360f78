#include "geometry/HalfEdges.hpp"

#include <algorithm>

namespace Rhegma::Geometry
{

HalfEdges::HalfEdges(const std::vector<std::array<int, 3>>& triangles)
{
  sides_.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int i = 0; i < 3; ++i)
    {
      const int a = triangles[t][(i + 1) % 3], b = triangles[t][(i + 2) % 3];
      const auto low = static_cast<std::uint64_t>(std::min(a, b)),
                 high = static_cast<std::uint64_t>(std::max(a, b));
      sides_.push_back({low << 32 | high, static_cast<int>(3 * t) + i, a < b});
    }
  std::sort(sides_.begin(), sides_.end(),
            [](const HalfEdge& a, const HalfEdge& b)
            { return a.edge != b.edge ? a.edge < b.edge : a.side < b.side; });
}

std::vector<std::array<int, 3>> HalfEdges::neighbours() const
{
  std::vector<std::array<int, 3>> found(sides_.size() / 3, {-1, -1, -1});
  forEachEdge(
      [&](const HalfEdge* side, int count)
      {
        if (count != 2)
          return;
        found[side[0].triangle()][side[0].side % 3] = side[1].triangle();
        found[side[1].triangle()][side[1].side % 3] = side[0].triangle();
      });
  return found;
}

} // namespace Rhegma::Geometry
