#include "geometry/Cuts.hpp"

#include <algorithm>
#include <limits>

namespace Rhegma::Geometry
{

template <int D>
Region<D> onSides(const Region<D>& region, bool whole, const std::vector<SignedDistance<D>>& surfaces,
                  int sides)
{
  const auto inside = [surfaces, sides](const Vector<D>& x)
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < surfaces.size(); ++i)
      least = std::min(least, (sides >> i & 1) != 0 ? surfaces[i](x) : -surfaces[i](x));
    return least;
  };
  if (whole)
    return {inside, [](const BoxPoints<D>&) { return Coverage::Unknown; }};
  return {[=](const Vector<D>& x) { return std::min(region.depth(x), inside(x)); },
          [=](const BoxPoints<D>& box)
          {
            const Coverage all = region.coverage(box);
            const double depth = inside(box.centre);
            return all == Coverage::None || depth <= -box.reach ? Coverage::None
                   : depth >= box.reach                         ? all
                                                                : Coverage::Unknown;
          }};
}

template Region<2> onSides(const Region<2>&, bool, const std::vector<SignedDistance<2>>&, int);
template Region<3> onSides(const Region<3>&, bool, const std::vector<SignedDistance<3>>&, int);

} // namespace Rhegma::Geometry
