#include "geometry/Overlap.hpp"

namespace Rhegma
{

namespace
{

template <int D>
bool liesInside(const Seeds<D>& seeds, std::size_t p, const Shape<D>& shape)
{
  const Vector<D>& centre = seeds.position[p];
  if (!shape.contains(centre))
    return false;
  for (int axis = 0; axis < D; ++axis)
    for (const double fraction : {-0.25, 0.25})
      if (!shape.contains(centre + fraction * seeds.box[p][axis] * seeds.axes[axis]))
        return false;
  return true;
}

template <int D>
bool holds(const Geometry::Bounds<D>& bounds, const Vector<D>& x)
{
  for (int d = 0; d < D; ++d)
    if (x[d] < bounds.lower[d] || x[d] > bounds.upper[d])
      return false;
  return true;
}

} // namespace

template <int D>
int findOverlap(const Seeds<D>& seeds, const Shape<D>& other)
{
  const Geometry::Bounds<D> bounds = other.bounds();
  for (std::size_t p = 0; p < seeds.position.size(); ++p)
    if (holds(bounds, seeds.position[p]) && liesInside(seeds, p, other))
      return static_cast<int>(p);
  return -1;
}

template int findOverlap(const Seeds<2>&, const Shape<2>&);
template int findOverlap(const Seeds<3>&, const Shape<3>&);

} // namespace Rhegma
