#pragma once
/// Calls of constitutive laws from kernels, whatever the law.

#include "material/Laws.hpp"

#include <algorithm>

namespace Rhegma
{

namespace detail
{

template <int D, Plane P, class Call, class First, class... Rest>
KOKKOS_FORCEINLINE_FUNCTION auto dispatch(int law, const Call& call, LawList<First, Rest...> /*list*/)
{
  if constexpr (sizeof...(Rest) > 0)
    if (law > 0)
      return dispatch<D, P>(law - 1, call, LawList<Rest...>{});
  return call.template run<First, D, P>();
}

template <int D, class... Law>
constexpr int largestHistory(LawList<Law...> /*list*/)
{
  int largest = 0;
  ((largest = Law::template historySize<D> > largest ? Law::template historySize<D> : largest), ...);
  return largest;
}

} // namespace detail

/// Gives `call` the law and the plane of a material: call.template run<Law, D, P>(). On the host it selects
/// among kernels that are compiled for one law; in a kernel it costs a branch per law.
template <int D, class List = Laws, class Call>
KOKKOS_INLINE_FUNCTION auto withLaw(int law, Plane plane, const Call& call)
{
  if constexpr (D == 2)
    if (plane == Plane::Stress)
      return detail::dispatch<D, Plane::Stress>(law, call, List{});
  return detail::dispatch < D, D == 2 ? Plane::Strain : Plane::Solid > (law, call, List{});
}

/// Capacity for the history of any law, for kernels that hold a copy; at least one.
constexpr int historyCapacity = std::max(1, detail::largestHistory<3>(Laws{}));
static_assert(detail::largestHistory<2>(Laws{}) <= historyCapacity);

/// Whether a law stores numbers per particle.
template <class Law>
constexpr bool hasHistory = Law::template historySize<2> > 0;

/// The law's stress; the step reaches only the laws that use it. \param ready of this step
template <class Law, int D, Plane P>
KOKKOS_FORCEINLINE_FUNCTION bool stressOfLaw([[maybe_unused]] const typename Law::Ready& ready,
                                             [[maybe_unused]] const LawStep& step, const Properties& m,
                                             double* F, double* tau, double* history)
{
  if constexpr (Law::prepares)
    return Law::template stress<D, P>(ready, step, m, F, tau, history);
  else if constexpr (Law::usesStep)
    return Law::template stress<D, P>(step, m, F, tau, history);
  else
    return Law::template stress<D, P>(m, F, tau, history);
}

template <class Law, int D, Plane P>
KOKKOS_FORCEINLINE_FUNCTION bool stressOfLaw(const LawStep& step, const Properties& m, double* F, double* tau,
                                             double* history)
{
  return stressOfLaw<Law, D, P>(typename Law::Ready(m, step.dt, step.temperature), step, m, F, tau, history);
}

/// Energy dissipated so far per undeformed volume [J/m3].
template <class Law, int D>
KOKKOS_FORCEINLINE_FUNCTION double dissipatedByLaw([[maybe_unused]] const double* history)
{
  if constexpr (Law::template dissipationIndex<D> >= 0)
    return history[Law::template dissipationIndex<D>];
  else
    return 0.0;
}

struct StressCall
{
  const LawStep& step;
  const Properties& properties;
  double* F;
  double* tau;
  double* history;
  template <class Law, int D, Plane P>
  KOKKOS_INLINE_FUNCTION bool run() const
  {
    return stressOfLaw<Law, D, P>(step, properties, F, tau, history);
  }
};

struct EnergyCall
{
  const Properties& properties;
  const double* F;
  const double* history;
  template <class Law, int D, Plane P>
  KOKKOS_INLINE_FUNCTION double run() const
  {
    return Law::template energy<D, P>(properties, F, history);
  }
};

struct WaveSpeedCall
{
  const Properties& properties;
  const double* F;
  const double* history;
  template <class Law, int D, Plane P>
  KOKKOS_INLINE_FUNCTION double run() const
  {
    return Law::template waveSpeed<D, P>(properties, F, history);
  }
};

struct DissipationCall
{
  const double* history;
  template <class Law, int D, Plane>
  KOKKOS_INLINE_FUNCTION double run() const
  {
    return dissipatedByLaw<Law, D>(history);
  }
};

struct DamageCall
{
  const Properties& properties;
  const double* history;
  template <class Law, int D, Plane>
  KOKKOS_INLINE_FUNCTION double run() const
  {
    if constexpr (Law::damages)
      return Law::template damage<D>(properties, history);
    else
      return 0.0;
  }
};

struct DamagesCall
{
  template <class Law, int D, Plane>
  KOKKOS_INLINE_FUNCTION bool run() const
  {
    return Law::damages;
  }
};

struct MeanCall
{
  int variable;
  template <class Law, int D, Plane>
  KOKKOS_INLINE_FUNCTION Mean run() const
  {
    return Law::template meanOf<D>(variable);
  }
};

struct HistorySizeCall
{
  const Properties& properties;
  template <class Law, int D, Plane>
  int run() const
  {
    if constexpr (ComputesBlocks<Law>::value)
      return Law::numbers(properties);
    else
      return Law::template historySize<D>;
  }
};

struct InBlocksCall
{
  template <class Law, int D, Plane>
  KOKKOS_INLINE_FUNCTION bool run() const
  {
    return ComputesBlocks<Law>::value;
  }
};

struct DissipatesCall
{
  template <class Law, int D, Plane>
  KOKKOS_INLINE_FUNCTION bool run() const
  {
    return Law::template dissipationIndex<D> >= 0;
  }
};

/// Kirchhoff stress of F after a step [Pa]; completes F[4] in plane stress, updates the history (null for
/// laws without one). \return false where F is inverted or not a number: stop the run
template <int D, class List = Laws>
KOKKOS_INLINE_FUNCTION bool updateStress(const LawStep& step, const Properties& properties, double* F,
                                         double* tau, double* history)
{
  return withLaw<D, List>(properties.law, properties.plane, StressCall{step, properties, F, tau, history});
}

/// The same where nothing moves.
template <int D>
KOKKOS_INLINE_FUNCTION bool updateStress(const Properties& properties, double* F, double* tau,
                                         double* history)
{
  return updateStress<D>(LawStep{F, 0.0, properties.temperature}, properties, F, tau, history);
}

/// Elastic energy stored per undeformed volume [J/m3].
template <int D>
KOKKOS_INLINE_FUNCTION double storedEnergy(const Properties& properties, const double* F,
                                           const double* history)
{
  return withLaw<D>(properties.law, properties.plane, EnergyCall{properties, F, history});
}

/// Upper bound of the wave speed in 3D, relative to the material [m/s].
template <int D>
KOKKOS_INLINE_FUNCTION double waveSpeed(const Properties& properties, const double* F, const double* history)
{
  return withLaw<D>(properties.law, properties.plane, WaveSpeedCall{properties, F, history});
}

/// Energy dissipated so far per undeformed volume [J/m3].
template <int D>
KOKKOS_INLINE_FUNCTION double dissipatedEnergy(const Properties& properties, const double* history)
{
  return withLaw<D>(properties.law, properties.plane, DissipationCall{history});
}

/// Damage, from 0 of a whole to 1 of a broken material; 0 for laws without one.
template <int D>
KOKKOS_INLINE_FUNCTION double damageOf(const Properties& properties, const double* history)
{
  return withLaw<D>(properties.law, properties.plane, DamageCall{properties, history});
}

/// Whether a law has a damage.
inline bool damages(const Properties& properties)
{
  return withLaw<3>(properties.law, Plane::Solid, DamagesCall{});
}

/// Numbers that a law stores per particle.
template <int D>
int historySize(const Properties& properties)
{
  return withLaw<D>(properties.law, properties.plane, HistorySizeCall{properties});
}

/// Whether a law computes many particles in one call.
inline bool isInBlocks(const Properties& properties)
{
  return withLaw<3>(properties.law, Plane::Solid, InBlocksCall{});
}

/// Whether a law may dissipate energy.
inline bool dissipates(const Properties& properties)
{
  return withLaw<3>(properties.law, Plane::Solid, DissipatesCall{});
}

/// How a history variable averages when particles merge.
template <int D>
KOKKOS_INLINE_FUNCTION Mean meanOfHistory(const Properties& properties, int variable)
{
  return withLaw<D>(properties.law, properties.plane, MeanCall{variable});
}

/// A history variable of a merged particle. \param value of each part \param volume, mass its fraction of
/// those of all parts
template <int Parts>
KOKKOS_INLINE_FUNCTION double merged(Mean mean, const double (&value)[Parts], const double (&volume)[Parts],
                                     const double (&mass)[Parts])
{
  if (mean == Mean::Largest)
  {
    double largest = value[0];
    for (int k = 1; k < Parts; ++k)
      largest = larger(largest, value[k]);
    return largest;
  }
  double sum = 0.0;
  for (int k = 0; k < Parts; ++k)
    sum += (mean == Mean::Mass ? mass[k] : volume[k]) * value[k];
  return sum;
}

} // namespace Rhegma
