#include "geometry/Primitives.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::Geometry
{

template <int D>
bool VoxelShape<D>::contains(const Vector<D>& own) const
{
  std::int64_t most = 0;
  for (int d = 0; d < D; ++d)
    most = std::max(most, phase->count()[d]);
  return phase->contains((1.0 / size) * (own - corner),
                         1e-12 * static_cast<double>(most)); // as of the others
}

template <int D>
double VoxelShape<D>::depth(const Vector<D>& own) const
{
  return size * phase->depth((1.0 / size) * (own - corner));
}

template <int D>
BoxPart<D> VoxelShape<D>::part(const Vector<D>& own, const Vector<D>& edge) const
{
  // A box that ends on a face of voxels holds nothing beyond it, whatever the rounding.
  constexpr double slack = 1e-9;
  Vector<D> lower, upper;
  for (int d = 0; d < D; ++d)
  {
    lower[d] = (own[d] - 0.5 * edge[d] - corner[d]) / size;
    upper[d] = (own[d] + 0.5 * edge[d] - corner[d]) / size;
    for (double* const end : {&lower[d], &upper[d]})
      if (std::abs(*end - std::round(*end)) < slack)
        *end = std::round(*end);
  }
  return phase->part(lower, upper);
}

template <int D>
Bounds<D> VoxelShape<D>::bounds(const Frame<D>& frame) const
{
  Bounds<D> result = emptyBounds<D>();
  for (const Vector<D>& x : phase->bounds().corners())
    result.include(frame.toSpace(corner + size * x));
  return result;
}

template <int D>
Vector<D> VoxelShape<D>::middle() const
{
  Vector<D> result = corner;
  for (int d = 0; d < D; ++d)
    result[d] += 0.5 * size * static_cast<double>(phase->count()[d]);
  return result;
}

template struct VoxelShape<2>;
template struct VoxelShape<3>;

} // namespace Rhegma::Geometry
