#pragma once
/// Stress of some particles that a step has strained.

#include "base/Types.hpp"
#include "grid/Blocks.hpp"
#include "material/Materials.hpp"

#include <limits>

namespace Rhegma
{

namespace detail
{

/// Data of the lanes of a bundle, component by component, so that a loop over lanes accesses contiguous
/// memory.
template <int D>
struct StrainLanes
{
  double gradient[gradientSize<D>][lanes]; ///< of the straining velocity, as a deformation gradient [1/s]
  double shift[D][lanes];                  ///< velocity of the particles' positions [m/s]
  double F[gradientSize<D>][lanes];        ///< old, then new
  double tau[symmetricSize<D>][lanes];
  double speed[lanes]; ///< of the particle, then with the wave speed on top [m/s]
};

/// (I + dt L) F of one lane; in plane stress the law sets the thickness stretch.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION void strained(const StrainLanes<D>& at, int l, double dt, double* F)
{
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
    {
      double change = 0.0;
      for (int k = 0; k < D; ++k)
        change += at.gradient[i * D + k][l] * at.F[k * D + j][l];
      F[i * D + j] = at.F[i * D + j][l] + dt * change;
    }
  if constexpr (D == 2)
    F[4] = at.F[4][l] + dt * at.gradient[4][l] * at.F[4][l];
}

/// Stores deformation gradient and stress of one lane.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION void storeLane(StrainLanes<D>& at, int l, const double* F, const double* tau)
{
  for (int k = 0; k < gradientSize<D>; ++k)
    at.F[k][l] = F[k];
  for (int k = 0; k < symmetricSize<D>; ++k)
    at.tau[k][l] = tau[k];
}

/// F <- (I + dt L) F, stress and wave speed of the lanes from .. to - 1, all of one material.
template <int D>
struct StressOfLanes
{
  const Properties& properties;
  StrainLanes<D>& at;
  double* history; ///< of the first lane; null for laws without one
  int historyWidth;
  double dt;
  int from, to;

  template <class Law, int, Plane P>
  KOKKOS_INLINE_FUNCTION void run() const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if constexpr (ComputesBlocks<Law>::value)
      return strainOnly();
    const typename Law::Ready ready(properties, dt, properties.temperature);
    for (int l = from; l < to; ++l)
    {
      double F[gradientSize<D>], tau[symmetricSize<D>], before[Law::usesStep ? gradientSize<D> : 1];
      if constexpr (Law::usesStep)
        for (int k = 0; k < gradientSize<D>; ++k)
          before[k] = at.F[k][l];
      strained<D>(at, l, dt, F);
      // Finite only if every component is.
      const bool finite = determinant<D>(F) < infinity;
      double* const own = history == nullptr ? nullptr : history + l * historyWidth;
      const bool good =
          stressOfLaw<Law, D, P>(ready, {before, dt, properties.temperature}, properties, F, tau, own);
      const double wave = Law::template waveSpeed<D, P>(properties, F, own);
      at.speed[l] = good && finite ? at.speed[l] + wave : infinity;
      storeLane(at, l, F, tau);
    }
  }

  /// For laws that find the stress later.
  KOKKOS_INLINE_FUNCTION void strainOnly() const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (int l = from; l < to; ++l)
    {
      double F[gradientSize<D>], tau[symmetricSize<D>];
      strained<D>(at, l, dt, F);
      const double J = determinant<D>(F);
      if (!(J > 0.0 && J < infinity))
        at.speed[l] = infinity;
      noStress<D>(tau);
      storeLane(at, l, F, tau);
    }
  }
};

} // namespace detail

} // namespace Rhegma
