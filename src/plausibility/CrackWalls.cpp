#include "plausibility/CrackWalls.hpp"

#include "geometry/Cross.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma
{

namespace
{

/// Slack of the weights of a point in a simplex, so that none passes between two simplices.
constexpr double rounding = 1e-9;

/// Normal of a simplex, of the length of its size.
Vector<2> normalOf(const std::array<Vector<2>, 2>& a)
{
  const Vector<2> along = a[1] - a[0];
  return {-along[1], along[0]};
}
Vector<3> normalOf(const std::array<Vector<3>, 3>& a) { return cross(a[1] - a[0], a[2] - a[0]); }

/// Whether a point of the plane of a simplex lies in it.
bool contains(const std::array<Vector<2>, 2>& a, const Vector<2>& x)
{
  const Vector<2> along = a[1] - a[0];
  const double at = dot(x - a[0], along) / dot(along, along);
  return at >= -rounding && at <= 1.0 + rounding;
}
bool contains(const std::array<Vector<3>, 3>& a, const Vector<3>& x)
{
  const Vector<3> normal = normalOf(a);
  const double square = dot(normal, normal);
  for (int i = 0; i < 3; ++i)
  {
    const Vector<3>&one = a[(i + 1) % 3], &other = a[(i + 2) % 3];
    if (dot(cross(other - one, x - one), normal) < -rounding * square)
      return false;
  }
  return true;
}

} // namespace

template <int D>
CrackWalls<D>::CrackWalls(const State<D>& state)
{
  const auto vertex = onHost(state.cracks.vertex);
  const auto simplex = onHost(state.cracks.simplex);
  const auto crackOf = onHost(state.cracks.crackOf);
  std::vector<Geometry::Bounds<D>> bounds;
  for (int s = 0; s < static_cast<int>(simplex.extent(0)); ++s)
  {
    std::array<Vector<D>, D> vertices;
    bounds.push_back(Geometry::emptyBounds<D>());
    for (int i = 0; i < D; ++i)
    {
      for (int d = 0; d < D; ++d)
        vertices[i][d] = vertex(simplex(s, i), d);
      bounds.back().include(vertices[i]);
    }
    simplices_.push_back(vertices);
    crackOf_.push_back(crackOf(s));
  }
  boxes_ = Geometry::NearBoxes<D>(std::move(bounds));
}

template <int D>
bool CrackWalls<D>::crosses(int simplex, const Vector<D>& x, const Vector<D>& y) const
{
  const std::array<Vector<D>, D>& a = simplices_[simplex];
  const Vector<D> normal = normalOf(a);
  const double from = dot(x - a[0], normal), to = dot(y - a[0], normal);
  return (from >= 0.0) != (to >= 0.0) && contains(a, x + (from / (from - to)) * (y - x));
}

template <int D>
int CrackWalls<D>::between(const Vector<D>& x, const Vector<D>& y) const
{
  Geometry::Bounds<D> bounds{x, x};
  bounds.include(y);
  for (const int s : boxes_.near(bounds, 0.0))
    if (crosses(s, x, y))
      return crackOf_[s];
  return -1;
}

template class CrackWalls<2>;
template class CrackWalls<3>;

} // namespace Rhegma
