#include "geometry/Frame.hpp"

#include "geometry/Cross.hpp"

#include <algorithm>
#include <limits>

namespace Rhegma::Geometry
{
namespace
{

struct Turn
{
  double cosine;
  double sine;
};

/// Exact at right angles, so that a body turned by 90 degrees stays on grid lines.
Turn turn(double degrees)
{
  const double angle = std::remainder(degrees, 360.0) * (std::acos(-1.0) / 180.0);
  const auto snap = [](double value) { return std::abs(value) < 1.0e-15 ? 0.0 : value; };
  return {snap(std::cos(angle)), snap(std::sin(angle))};
}

} // namespace

template <int D>
Axes<D> spaceAxes()
{
  Axes<D> axes{};
  for (int d = 0; d < D; ++d)
    axes[d][d] = 1.0;
  return axes;
}

Axes<2> turnedAxes(double degrees)
{
  const Turn t = turn(degrees);
  return {{{{t.cosine, t.sine}}, {{-t.sine, t.cosine}}}};
}

Axes<3> turnedAxes(double degrees, const Vector<3>& about)
{
  const Turn t = turn(degrees);
  const Vector<3> n = (1.0 / norm(about)) * about;
  Axes<3> axes = spaceAxes<3>();
  for (Vector<3>& e : axes)
  {
    const Vector<3> across = cross(n, e);
    e = t.cosine * e + t.sine * across + ((1.0 - t.cosine) * dot(n, e)) * n;
  }
  return axes;
}

template <int D>
Bounds<D> emptyBounds()
{
  Bounds<D> bounds;
  for (int d = 0; d < D; ++d)
  {
    bounds.lower[d] = std::numeric_limits<double>::max();
    bounds.upper[d] = std::numeric_limits<double>::lowest();
  }
  return bounds;
}

template <int D>
void Bounds<D>::include(const Vector<D>& x)
{
  for (int d = 0; d < D; ++d)
  {
    lower[d] = std::min(lower[d], x[d]);
    upper[d] = std::max(upper[d], x[d]);
  }
}

template <int D>
void Bounds<D>::include(const Bounds& other)
{
  include(other.lower);
  include(other.upper);
}

template <int D>
std::array<Vector<D>, (1 << D)> Bounds<D>::corners() const
{
  std::array<Vector<D>, (1 << D)> result;
  for (int corner = 0; corner < (1 << D); ++corner)
    for (int d = 0; d < D; ++d)
      result[corner][d] = (corner >> d) & 1 ? upper[d] : lower[d];
  return result;
}

template <int D>
Vector<D> Frame<D>::toOwn(const Vector<D>& x) const
{
  const Vector<D> arm = x - centre;
  Vector<D> own = centre;
  for (int d = 0; d < D; ++d)
    own[d] += dot(axes[d], arm);
  return own;
}

template <int D>
Vector<D> Frame<D>::toSpace(const Vector<D>& own) const
{
  const Vector<D> arm = own - centre;
  Vector<D> x = centre;
  for (int d = 0; d < D; ++d)
    x = x + arm[d] * axes[d];
  return x;
}

template Axes<2> spaceAxes<2>();
template Axes<3> spaceAxes<3>();
template Bounds<2> emptyBounds<2>();
template Bounds<3> emptyBounds<3>();
template struct Bounds<2>;
template struct Bounds<3>;
template struct Frame<2>;
template struct Frame<3>;

} // namespace Rhegma::Geometry
