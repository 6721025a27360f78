#pragma once
/// exp(x) - 1 - x, with which energies of small strain keep their digits.

#include "base/Types.hpp"

#include <cmath>

namespace Rhegma
{

/// By its series where that has more digits; the first term left out is 1e-17 of the result.
KOKKOS_INLINE_FUNCTION double exponentialRest(double x)
{
  constexpr double small = 0.02;
  if (std::fabs(x) > small)
    return std::expm1(x) - x;
  return 0.5 * x * x *
         (1.0 +
          x / 3.0 * (1.0 + x / 4.0 * (1.0 + x / 5.0 * (1.0 + x / 6.0 * (1.0 + x / 7.0 * (1.0 + x / 8.0))))));
}

} // namespace Rhegma
