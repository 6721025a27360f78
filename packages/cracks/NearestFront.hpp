#pragma once
/// Which front of a crack is nearest to a place.

#include "base/Types.hpp"

#include <cmath>

namespace Rhegma::cracks
{

/// The front of a crack that is nearest to a place, or -1 if that has not grown.
template <int D>
struct NearestFront
{
  View<double * [D + 1]> fronts; ///< place of each [m], and 1 + its crack, negative if it has not grown

  KOKKOS_INLINE_FUNCTION int operator()(const Vector<D>& x, int crack) const
  {
    int found = -1;
    double least = 1e300;
    for (int f = 0; f < static_cast<int>(fronts.extent(0)); ++f)
    {
      if (std::fabs(fronts(f, D)) != 1.0 + crack)
        continue;
      double square = 0.0;
      for (int d = 0; d < D; ++d)
        square += (x[d] - fronts(f, d)) * (x[d] - fronts(f, d));
      if (square < least)
      {
        least = square;
        found = f;
      }
    }
    return found >= 0 && fronts(found, D) > 0.0 ? found : -1;
  }
};

} // namespace Rhegma::cracks
