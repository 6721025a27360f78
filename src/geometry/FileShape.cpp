#include "geometry/Primitives.hpp"
#include "geometry/SolidInBox.hpp"

#include <algorithm>
#include <limits>

namespace Rhegma::Geometry
{

template <int D>
bool FileShape<D>::contains(const Vector<D>& own) const
{
  double tolerance = 0.0; // as of the other primitives
  for (int d = 0; d < D; ++d)
    tolerance = std::max(tolerance, 1e-12 * scale * (solid->bounds().upper[d] - solid->bounds().lower[d]));
  return depth(own, 2.0 * tolerance) >= -tolerance;
}

template <int D>
double FileShape<D>::depth(const Vector<D>& own) const
{
  return depth(own, std::numeric_limits<double>::infinity());
}

template <int D>
double FileShape<D>::depth(const Vector<D>& own, double within) const
{
  return scale * solid->depth((1.0 / scale) * (own - origin), within / scale);
}

template <int D>
Bounds<D> FileShape<D>::bounds(const Frame<D>& frame) const
{
  const auto place = [&](const Vector<D>& x) { return frame.toSpace(origin + scale * x); };
  Bounds<D> result = emptyBounds<D>();
  bool isTurned = false;
  for (int d = 0; d < D; ++d)
    isTurned = isTurned || frame.axes[d][d] != 1.0;
  if (!isTurned)
  {
    result.include(place(solid->bounds().lower));
    result.include(place(solid->bounds().upper));
    return result;
  }
  for (const auto& item : solid->surface().items)
    result.include(place(solid->surface().points[item[0]]));
  return result;
}

template <int D>
BoxPart<D> FileShape<D>::part(const Vector<D>& own, const Vector<D>& edge) const
{
  const double reach = 0.5 * norm(edge), middle = depth(own, reach);
  if (middle <= -reach)
    return {};
  if (middle >= reach)
  {
    BoxPart<D> whole;
    whole.fraction = 1.0;
    for (int d = 0; d < D; ++d)
      whole.variance[d] = 1.0 / 12.0;
    return whole;
  }
  return partInSolid(*solid, (1.0 / scale) * (own - 0.5 * edge - origin),
                     (1.0 / scale) * (own + 0.5 * edge - origin));
}

template struct FileShape<2>;
template struct FileShape<3>;

} // namespace Rhegma::Geometry
