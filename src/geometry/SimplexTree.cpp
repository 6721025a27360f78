#include "geometry/SimplexTree.hpp"

#include "geometry/Cross.hpp"

#include <algorithm>
#include <limits>

namespace Rhegma::Geometry
{

namespace
{

template <int D>
std::vector<Bounds<D>> boundsOfItems(const Simplices<D>& simplices)
{
  std::vector<Bounds<D>> bounds;
  bounds.reserve(simplices.items.size());
  for (int k = 0; k < static_cast<int>(simplices.items.size()); ++k)
    bounds.push_back(simplices.boundsOf(k));
  return bounds;
}

template <int D>
double squaredDistance(const Vector<D>& x, const Bounds<D>& bounds)
{
  double sum = 0.0;
  for (int d = 0; d < D; ++d)
  {
    const double away = std::max({bounds.lower[d] - x[d], x[d] - bounds.upper[d], 0.0});
    sum += away * away;
  }
  return sum;
}

/// Of rays: along no line or plane that parts usually have.
template <int D>
Vector<D> direction()
{
  if constexpr (D == 2)
    return {0.8137348731, 0.5812381937};
  else
    return {0.6138273471, 0.4729171231, 0.6321079341};
}

/// Twice the area between the ray and an edge, seen along the ray; it has the other sign exactly where the
/// edge is given the other way round. Zero counts as positive for an edge from the first point to a later
/// one.
double sideOfRay(const Vector<3>& x, const std::vector<Vector<3>>& points, int a, int b)
{
  const bool inOrder = a < b;
  const Vector<3> from = points[inOrder ? a : b] - x, to = points[inOrder ? b : a] - x;
  const double side = dot(direction<3>(), cross(from, to));
  return (inOrder ? 1.0 : -1.0) * (side == 0.0 ? std::numeric_limits<double>::min() : side);
}

double sideOfRay(const Vector<2>& x, const Vector<2>& point)
{
  const Vector<2> u = direction<2>(), from = point - x;
  const double side = u[0] * from[1] - u[1] * from[0];
  return side == 0.0 ? std::numeric_limits<double>::min() : side;
}

} // namespace

template <int D>
Bounds<D> Simplices<D>::boundsOf(int item) const
{
  Bounds<D> bounds = emptyBounds<D>();
  for (const int point : items[item])
    bounds.include(points[point]);
  return bounds;
}

template <int D>
Vector<D> Simplices<D>::normalOf(int item) const
{
  Vector<D> corner[D];
  corners(item, corner);
  if constexpr (D == 2)
    return {corner[1][1] - corner[0][1], corner[0][0] - corner[1][0]};
  else
    return cross(corner[1] - corner[0], corner[2] - corner[0]);
}

template <int D>
SimplexTree<D>::SimplexTree(const Simplices<D>& simplices)
    : simplices_(simplices), boxes_(boundsOfItems(simplices))
{
  double largest = 0.0;
  for (const Vector<D>& x : simplices.points)
    for (int d = 0; d < D; ++d)
      largest = std::max(largest, std::abs(x[d]));
  slack_ = 1e-14 * largest;
}

template <int D>
NearestItem<D> SimplexTree<D>::nearest(const Vector<D>& x, double within, int guess) const
{
  NearestItem<D> found;
  double least = within * within;
  double limit = least; // of bounds, whose distance is rounded
  const auto look = [&](int item)
  {
    Vector<D> corner[D];
    simplices_.corners(item, corner);
    const Foot<D> foot = footOn(corner, x);
    const Vector<D> away = x - pointAt<D>(corner, foot);
    const double square = dot(away, away);
    if (square > least || (square == least && found.item >= 0 && item >= found.item))
      return;
    found = {item, square, foot};
    least = square;
    limit = std::pow(std::sqrt(least) + slack_, 2);
  };
  if (guess >= 0)
    look(guess);
  boxes_.forNearest([&](const Bounds<D>& bounds) { return squaredDistance(x, bounds); }, limit, look);
  return found;
}

template <int D>
bool SimplexTree<D>::mayMeet(const Vector<D>& x, const Bounds<D>& bounds) const
{
  const Vector<D> u = direction<D>();
  double first = 0.0, last = std::numeric_limits<double>::infinity();
  for (int d = 0; d < D; ++d) // all components of the direction are positive
  {
    first = std::max(first, (bounds.lower[d] - slack_ - x[d]) / u[d]);
    last = std::min(last, (bounds.upper[d] + slack_ - x[d]) / u[d]);
  }
  return first <= last + slack_;
}

template <int D>
int SimplexTree<D>::meetingOf(const Vector<D>& x, int item) const
{
  const auto& v = simplices_.items[item];
  double weight[D], sum = 0.0;
  if constexpr (D == 2)
  {
    weight[0] = sideOfRay(x, simplices_.points[v[1]]);
    weight[1] = -sideOfRay(x, simplices_.points[v[0]]);
  }
  else
    for (int i = 0; i < 3; ++i)
      weight[i] = sideOfRay(x, simplices_.points, v[(i + 1) % 3], v[(i + 2) % 3]);
  for (int i = 0; i < D; ++i)
  {
    if ((weight[i] > 0.0) != (weight[0] > 0.0))
      return 0;
    sum += weight[i];
  }
  double ahead = 0.0;
  for (int i = 0; i < D; ++i)
    ahead += weight[i] / sum * dot(simplices_.points[v[i]] - x, direction<D>());
  return ahead <= 0.0 ? 0 : sum > 0.0 ? 1 : -1;
}

template struct Simplices<2>;
template struct Simplices<3>;
template class SimplexTree<2>;
template class SimplexTree<3>;

} // namespace Rhegma::Geometry
