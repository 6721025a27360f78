#include "rigid_tools/Separation.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::rigid_tools
{

template <int D>
Vector<D> ToolSurface<D>::outward(const Vector<D>& x) const
{
  const Vector<D> own = placement.toOwn(x);
  Vector<D> slope;
  for (int d = 0; d < D; ++d)
  {
    Vector<D> before = own, after = own;
    before[d] -= step;
    after[d] += step;
    slope[d] = shape.depth(before) - shape.depth(after);
  }
  const double length = norm(slope);
  return length > 0.0 ? placement.turn((1.0 / length) * slope) : Vector<D>{};
}

namespace
{

/// The matrix whose columns are the edges, inverted; zero where they have no volume.
template <int D>
void invert(const Vector<D> (&edge)[D], double (&inverse)[D][D])
{
  if constexpr (D == 2)
  {
    const double volume = edge[0][0] * edge[1][1] - edge[1][0] * edge[0][1];
    const double factor = volume != 0.0 ? 1.0 / volume : 0.0;
    inverse[0][0] = factor * edge[1][1];
    inverse[0][1] = -factor * edge[1][0];
    inverse[1][0] = -factor * edge[0][1];
    inverse[1][1] = factor * edge[0][0];
  }
  else
    for (int e = 0; e < 3; ++e)
    {
      const Vector<3>&a = edge[(e + 1) % 3], &b = edge[(e + 2) % 3];
      Vector<3> across;
      for (int d = 0; d < 3; ++d)
        across[d] = a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3];
      const double volume = dot(across, edge[e]);
      for (int d = 0; d < 3; ++d)
        inverse[e][d] = volume != 0.0 ? across[d] / volume : 0.0;
    }
}

/// The point of a domain at the coordinates of x along its edges, cut to the domain: the nearest one, if the
/// domain is a box.
template <int D>
Vector<D> cutToDomain(const Vector<D>& x, const Vector<D>& centre, const Vector<D> (&edge)[D],
                      const double (&inverse)[D][D])
{
  Vector<D> point = centre;
  for (int e = 0; e < D; ++e)
  {
    double along = 0.0;
    for (int d = 0; d < D; ++d)
      along += inverse[e][d] * (x[d] - centre[d]);
    point = point + std::max(-0.5, std::min(0.5, along)) * edge[e];
  }
  return point;
}

} // namespace

template <int D>
Separation<D> separate(const ToolSurface<D>& surface, const Vector<D>& centre, const Vector<D> (&edge)[D])
{
  constexpr int turns = 4; // they converge at once for flat surfaces
  Separation<D> found;
  const double middle = surface.depth(centre);
  found.normal = surface.outward(centre);
  found.foot = centre + middle * found.normal;
  Vector<D> corner = centre;
  for (int e = 0; e < D; ++e)
    corner = corner - (dot(edge[e], found.normal) > 0.0 ? 0.5 : -0.5) * edge[e];
  double deepest = std::max(middle, surface.depth(corner)), before = deepest;
  double inverse[D][D];
  invert(edge, inverse);
  Vector<D> at = found.foot;
  for (int k = 0; k < turns; ++k)
  {
    const Vector<D> point = cutToDomain(at, centre, edge, inverse);
    const double depth = surface.depth(point);
    deepest = std::max(deepest, depth);
    if (k > 0 && std::fabs(depth - before) < surface.step * 1e-3)
      break;
    before = depth;
    at = point + depth * surface.outward(point);
  }
  found.gap = -deepest;
  return found;
}

template struct ToolSurface<2>;
template struct ToolSurface<3>;
template Separation<2> separate(const ToolSurface<2>&, const Vector<2>&, const Vector<2> (&)[2]);
template Separation<3> separate(const ToolSurface<3>&, const Vector<3>&, const Vector<3> (&)[3]);

} // namespace Rhegma::rigid_tools
