#include "geometry/Solid.hpp"

#include "geometry/HalfEdges.hpp"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <limits>

namespace Rhegma::Geometry
{

namespace
{

/// Angle of a triangle at a corner; 1 at the end of a segment.
double angleAt(const Vector<3> (&corner)[3], int i)
{
  const Vector<3> a = corner[(i + 1) % 3] - corner[i], b = corner[(i + 2) % 3] - corner[i];
  const double product = norm(a) * norm(b);
  return product > 0.0 ? std::acos(std::clamp(dot(a, b) / product, -1.0, 1.0)) : 0.0;
}
double angleAt(const Vector<2> (&)[2], int) { return 1.0; }

/// Height of a triangle over its longest edge, length of a segment.
template <int D>
double heightOf(const Vector<D> (&corner)[D], double size)
{
  double longest = 0.0;
  for (int i = 0; i < D; ++i)
    longest = std::max(longest, norm(corner[(i + 1) % D] - corner[i]));
  return D == 2 ? longest : longest > 0.0 ? size / longest : 0.0;
}

/// Depths that were computed last: the cells into which a box is halved have corners in common.
template <int D>
class RecentDepths
{
public:
  /// \return null if it is not known \param solid its number
  const double* find(std::uint64_t solid, const Vector<D>& x) const
  {
    const Entry& entry = entries_[placeOf(x)];
    for (int d = 0; d < D; ++d)
      if (entry.x[d] != x[d])
        return nullptr;
    return entry.solid == solid ? &entry.depth : nullptr;
  }

  void keep(std::uint64_t solid, const Vector<D>& x, double depth)
  {
    entries_[placeOf(x)] = {solid, x, depth};
  }

private:
  struct Entry
  {
    std::uint64_t solid = 0; ///< 0: none
    Vector<D> x{};
    double depth = 0.0;
  };
  static constexpr std::size_t size = 1 << 13;

  static std::size_t placeOf(const Vector<D>& x)
  {
    std::uint64_t hash = 0;
    for (int d = 0; d < D; ++d)
    {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &x[d], sizeof bits);
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15ull; // multiplicative hashing by the golden ratio
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash) & (size - 1);
  }

  std::vector<Entry> entries_{size};
};

/// Balls about points of known depth, which the surface does not enter: all points in them are on the side of
/// the middle.
template <int D>
class ClearBalls
{
public:
  /// The depth of the middle of a ball that holds all points within a distance of x; 0 if there is none.
  double sideOf(std::uint64_t solid, const Vector<D>& x, double within) const
  {
    constexpr double rounding = 1e-12;
    for (const Ball& ball : balls_)
      if (const double room = (1.0 - rounding) * std::abs(ball.depth) - within;
          room > 0.0 && ball.solid == solid && dot(x - ball.centre, x - ball.centre) < room * room)
        return ball.depth;
    return 0.0;
  }

  void keep(std::uint64_t solid, const Vector<D>& centre, double depth)
  {
    balls_[next_++ % number] = {solid, centre, depth};
  }

private:
  struct Ball
  {
    std::uint64_t solid = 0; ///< 0: none
    Vector<D> centre{};
    double depth = 0.0; ///< of the centre
  };
  static constexpr std::size_t number = 16; ///< the corners of a box, and those of one before it
  Ball balls_[number];
  std::size_t next_ = 0;
};

std::uint64_t nextNumber()
{
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

} // namespace

template <int D>
Solid<D>::Solid(Simplices<D> surface, double resolution)
    : number_(nextNumber()), surface_(std::move(surface)), tree_(surface_), bounds_(emptyBounds<D>())
{
  for (const auto& item : surface_.items)
    for (const int point : item)
      bounds_.include(surface_.points[point]);
  addNormals(resolution);
  if constexpr (D == 3)
    neighbours_ = HalfEdges(surface_.items).neighbours();
}

template <int D>
void Solid<D>::addNormals(double resolution)
{
  normals_.resize(surface_.items.size());
  pointNormals_.assign(surface_.points.size(), Vector<D>{});
  std::vector<char> uncertain(surface_.points.size(), 0);
  for (std::size_t k = 0; k < surface_.items.size(); ++k)
  {
    Vector<D> corner[D];
    surface_.corners(static_cast<int>(k), corner);
    const Vector<D> normal = surface_.normalOf(static_cast<int>(k));
    const double size = norm(normal);
    const bool flat = !(heightOf<D>(corner, size) > resolution);
    if (!flat)
      normals_[k] = (1.0 / size) * normal;
    for (int i = 0; i < D; ++i)
    {
      const int point = surface_.items[k][i];
      if (flat)
        uncertain[point] = 1;
      else
        pointNormals_[point] = pointNormals_[point] + angleAt(corner, i) * normals_[k];
    }
  }
  for (std::size_t p = 0; p < uncertain.size(); ++p)
    if (uncertain[p] != 0)
      pointNormals_[p] = Vector<D>{};
}

template <int D>
Vector<D> Solid<D>::normalAt(const NearestItem<D>& nearest) const
{
  const auto isZero = [](const Vector<D>& v) { return dot(v, v) == 0.0; };
  const Vector<D>& own = normals_[nearest.item];
  if (nearest.foot.vertex >= 0)
    return pointNormals_[surface_.items[nearest.item][nearest.foot.vertex]];
  if (nearest.foot.facet < 0 || isZero(own))
    return own;
  const Vector<D>& other = normals_[neighbours_[nearest.item][nearest.foot.facet]];
  return isZero(other) ? other : own + other;
}

template <int D>
bool Solid<D>::isInside(const Vector<D>& x) const
{
  for (int d = 0; d < D; ++d)
    if (x[d] < bounds_.lower[d] || x[d] > bounds_.upper[d])
      return false;
  int sum = 0;
  tree_.meetRay(x, [&](int, int sign) { sum += sign; });
  return sum > 0;
}

template <int D>
double Solid<D>::depthFrom(const Vector<D>& x, const NearestItem<D>& nearest) const
{
  const double distance = std::sqrt(nearest.squaredDistance);
  Vector<D> corner[D];
  surface_.corners(nearest.item, corner);
  const Vector<D> away = x - pointAt<D>(corner, nearest.foot), normal = normalAt(nearest);
  const double along = dot(away, normal);
  constexpr double certain = 1e-6; // cosine
  const bool sees = std::abs(along) > certain * distance * norm(normal);
  return (sees ? along < 0.0 : isInside(x)) ? distance : -distance;
}

template <int D>
double Solid<D>::depth(const Vector<D>& x, double within) const
{
  static thread_local RecentDepths<D> recent;
  if (const double* const known = recent.find(number_, x))
    return std::clamp(*known, -within, within);
  // Most cells of a lattice are far from the surface, and so are their neighbours.
  static thread_local ClearBalls<D> clear;
  if (const double side = clear.sideOf(number_, x, within); side != 0.0)
    return std::copysign(within, side);
  // The item that was found last, of whatever solid: near where points are near each other.
  static thread_local int last = 0;
  const int guess = last < static_cast<int>(surface_.items.size()) ? last : -1;
  // Up to a few cells away, for the sake of the neighbours; beyond, many items may be equally near.
  constexpr double farther = 4.0;
  NearestItem<D> nearest = tree_.nearest(x, within, guess);
  if (nearest.item < 0)
    nearest = tree_.nearest(x, farther * within, guess);
  double depth = 0.0;
  if (nearest.item >= 0)
  {
    last = nearest.item;
    depth = depthFrom(x, nearest);
    recent.keep(number_, x, depth);
  }
  else
    depth = isInside(x) ? farther * within : -farther * within;
  clear.keep(number_, x, depth);
  return std::clamp(depth, -within, within);
}

template <int D>
double Solid<D>::volume() const
{
  double sum = 0.0;
  const Vector<D> middle = bounds_.centre();
  for (int k = 0; k < static_cast<int>(surface_.items.size()); ++k)
    sum += dot(surface_.points[surface_.items[k][0]] - middle, surface_.normalOf(k));
  return sum / (D == 2 ? 2.0 : 6.0);
}

template class Solid<2>;
template class Solid<3>;

} // namespace Rhegma::Geometry
