#pragma once
/// The thickness stretch of plane stress.

#include "base/Types.hpp"

namespace Rhegma
{

/// Thickness stretch s in [low, high] at which the out-of-plane stress vanishes: Newton, with bisection of ln
/// s where a Newton step would leave the bracket, so that it always ends (Press et al., Numerical Recipes,
/// `rtsafe`).
///
/// \param stress  stress(s, slope) gives the stress at s, and its slope by ln s; not positive at `low`, not
/// negative at
///                `high`
/// \param s       where to begin: last step's value makes two evaluations enough
template <class Stress>
KOKKOS_INLINE_FUNCTION double thicknessRoot(const Stress& stress, double low, double high, double s)
{
  constexpr double newtonStep = 1.0e-10; // relative; the error left by a Newton step is the square of it
  constexpr double roundOff = 1.0e-16;
  if (!(s >= low && s <= high))
    s = std::sqrt(low * high);
  for (int i = 0; i < 200 && high - low > roundOff * low; ++i)
  {
    double slope = 0.0;
    const double value = stress(s, slope);
    if (value > 0.0)
      high = s;
    else
      low = s;
    const double step = value / slope;
    const double newton = s - s * step;
    if (slope > 0.0 && newton >= low && newton <= high)
    {
      s = newton;
      if (std::fabs(step) <= newtonStep)
        break;
    }
    else
    {
      const double middle = std::sqrt(low * high);
      if (middle == s)
        break;
      s = middle;
    }
  }
  return s;
}

} // namespace Rhegma
