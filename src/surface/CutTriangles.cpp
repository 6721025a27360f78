#include "surface/CutTriangles.hpp"

#include "geometry/Cross.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace Rhegma::surface
{

namespace
{

/// Twice the area with its direction; in a plane the other two components are zero.
template <int D>
Vector<3> areaOf(const std::vector<Vector<D>>& points, const std::array<int, 3>& t)
{
  Vector<3> a{0.0, 0.0, 0.0}, b{0.0, 0.0, 0.0};
  for (int d = 0; d < D; ++d)
  {
    a[d] = points[t[1]][d] - points[t[0]][d];
    b[d] = points[t[2]][d] - points[t[0]][d];
  }
  return cross(a, b);
}

/// Position of a corner relative to the region.
enum class Position
{
  Outside,
  OnBorder,
  Inside
};

using Edge = std::pair<int, int>;

/// Cuts triangles in three steps: find crossings of edges, move corners onto them, keep the remaining
/// polygons.
template <int D>
class Cutter
{
public:
  Cutter(const std::vector<Vector<D>>& points, const std::vector<std::array<int, 3>>& triangles,
         const Region<D>& region)
      : points_(points), triangles_(triangles), region_(region), cutPoints_(points)
  {
    position_.reserve(points.size());
    for (const Vector<D>& x : points)
      position_.push_back(region(x) ? Position::Inside : Position::Outside);
    for (const std::array<int, 3>& t : triangles)
      for (int i = 0; i < 3; ++i)
        ++uses_[std::minmax(t[i], t[(i + 1) % 3])];
  }

  /// Moves corners near the region's border onto it.
  void moveCorners()
  {
    // A corner on the border of the surface stays on it, otherwise the border would not be a front there.
    std::vector<char> atBorder(points_.size(), 0);
    for (const auto& [edge, triangleCount] : uses_)
      if (triangleCount == 1)
        atBorder[edge.first] = atBorder[edge.second] = 1;
    const std::vector<Position> before = position_;
    std::vector<double> moved(points_.size(), 1e300);
    const auto moveEnds = [&](int in, int out)
    {
      if (before[in] != Position::Inside || before[out] != Position::Outside ||
          crossings_.count({in, out}) != 0)
        return;
      const Vector<D> x = crossing(in, out);
      crossings_[{in, out}] = x;
      const double length = norm(points_[out] - points_[in]);
      for (const int end : {in, out})
      {
        const double distance = norm(x - points_[end]);
        if ((atBorder[end] != 0 && uses_.at(std::minmax(in, out)) != 1) || distance >= near * length ||
            distance >= moved[end])
          continue;
        moved[end] = distance;
        cutPoints_[end] = x;
        position_[end] = Position::OnBorder;
      }
    };
    for (const std::array<int, 3>& t : triangles_)
      for (int i = 0; i < 3; ++i)
      {
        moveEnds(t[i], t[(i + 1) % 3]);
        moveEnds(t[(i + 1) % 3], t[i]);
      }
  }

  /// The remaining triangles, indices of cutPoints.
  std::vector<std::array<int, 3>> cut()
  {
    std::vector<std::array<int, 3>> kept;
    for (const std::array<int, 3>& t : triangles_)
    {
      const std::vector<int> left = leftOf(t);
      for (std::size_t k = 2; k < left.size(); ++k)
        // Moved corners may have inverted a triangle.
        if (dot(areaOf(points_, t), areaOf(cutPoints_, {left[0], left[k - 1], left[k]})) > 0.0)
          kept.push_back({left[0], left[k - 1], left[k]});
    }
    return kept;
  }

  const std::vector<Vector<D>>& cutPoints() const { return cutPoints_; }

private:
  static constexpr double near = 0.3; ///< part of an edge within which its end moves onto the border

  Vector<D> crossing(int in, int out) const
  {
    Vector<D> a = points_[in], b = points_[out];
    for (int halving = 0; halving < 10; ++halving)
    {
      const Vector<D> middle = 0.5 * (a + b);
      (region_(middle) ? a : b) = middle;
    }
    return a;
  }

  int pointBetween(int in, int out)
  {
    const auto [entry, isNew] = added_.insert({{in, out}, static_cast<int>(cutPoints_.size())});
    if (isNew)
      cutPoints_.push_back(crossings_.at({in, out}));
    return entry->second;
  }

  /// The remaining polygon of a triangle, corner by corner; may be empty.
  std::vector<int> leftOf(const std::array<int, 3>& t)
  {
    std::vector<int> left;
    bool inside = false;
    for (int i = 0; i < 3; ++i)
    {
      const int a = t[i], b = t[(i + 1) % 3];
      inside = inside || position_[a] == Position::Inside;
      if (position_[a] != Position::Outside)
        left.push_back(a);
      if (position_[a] == Position::Inside && position_[b] == Position::Outside)
        left.push_back(pointBetween(a, b));
      if (position_[a] == Position::Outside && position_[b] == Position::Inside)
        left.push_back(pointBetween(b, a));
    }
    if (!inside && left.size() == 3)
      inside = region_((1.0 / 3.0) * (points_[t[0]] + points_[t[1]] + points_[t[2]]));
    return inside ? left : std::vector<int>{};
  }

  const std::vector<Vector<D>>& points_;
  const std::vector<std::array<int, 3>>& triangles_;
  const Region<D>& region_;
  std::vector<Vector<D>> cutPoints_;
  std::vector<Position> position_;
  std::map<Edge, int> uses_;            ///< number of triangles at each edge
  std::map<Edge, Vector<D>> crossings_; ///< of edges (inner end, outer end)
  std::map<Edge, int> added_;           ///< points at these crossings
};

} // namespace

template <int D>
void cutTriangles(std::vector<Vector<D>>& points, std::vector<std::array<int, 3>>& triangles,
                  const Region<D>& region)
{
  Cutter<D> cutter(points, triangles, region);
  cutter.moveCorners();
  std::vector<std::array<int, 3>> kept = cutter.cut();
  // Unused points are removed.
  std::vector<int> number(cutter.cutPoints().size(), -1);
  std::vector<Vector<D>> used;
  for (std::array<int, 3>& t : kept)
    for (int& v : t)
    {
      if (number[v] < 0)
      {
        number[v] = static_cast<int>(used.size());
        used.push_back(cutter.cutPoints()[v]);
      }
      v = number[v];
    }
  points = used;
  triangles = kept;
}

template void cutTriangles(std::vector<Vector<2>>&, std::vector<std::array<int, 3>>&, const Region<2>&);
template void cutTriangles(std::vector<Vector<3>>&, std::vector<std::array<int, 3>>&, const Region<3>&);

} // namespace Rhegma::surface
