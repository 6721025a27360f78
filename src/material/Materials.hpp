#pragma once
/// The constitutive laws of all kinds behind one call: what kernels include.

#include "material/J2Plastic.hpp"
#include "material/LinearElastic.hpp"
#include "material/MooneyRivlin.hpp"
#include "material/NeoHookean.hpp"

namespace Rhegma
{

/// Gives `call` the law and the plane of a material: call.template run<Law, D, P>(). On the host it chooses
/// among kernels that know their law when they are compiled; in a kernel it costs two branches.
template <int D, class Call>
KOKKOS_INLINE_FUNCTION auto withLaw(LawKind kind, Plane plane, const Call& call)
{
  constexpr Plane P = D == 2 ? Plane::Strain : Plane::Solid;
  if constexpr (D == 2)
    if (plane == Plane::Stress)
    {
      switch (kind)
      {
      case LawKind::NeoHookean:
        return call.template run<NeoHookean, D, Plane::Stress>();
      case LawKind::MooneyRivlin:
        return call.template run<MooneyRivlin, D, Plane::Stress>();
      case LawKind::J2Plastic:
        return call.template run<J2Plastic, D, Plane::Stress>();
      default:
        return call.template run<LinearElastic, D, Plane::Stress>();
      }
    }
  switch (kind)
  {
  case LawKind::NeoHookean:
    return call.template run<NeoHookean, D, P>();
  case LawKind::MooneyRivlin:
    return call.template run<MooneyRivlin, D, P>();
  case LawKind::J2Plastic:
    return call.template run<J2Plastic, D, P>();
  default:
    return call.template run<LinearElastic, D, P>();
  }
}

struct StressCall
{
  const Properties& properties;
  double* F;
  double* tau;
  double* history;
  template <class Law, int D, Plane P>
  KOKKOS_INLINE_FUNCTION bool run() const
  {
    return Law::template stress<D, P>(properties, F, tau, history);
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

/// Kirchhoff stress of F [Pa]; completes F[4] in plane stress, moves the history (null for laws without one).
/// \return false where F is inverted or not a number: stop the run
template <int D>
KOKKOS_INLINE_FUNCTION bool updateStress(const Properties& properties, double* F, double* tau,
                                         double* history)
{
  return withLaw<D>(properties.kind, properties.plane, StressCall{properties, F, tau, history});
}

/// Elastic energy stored per undeformed volume [J/m3].
template <int D>
KOKKOS_INLINE_FUNCTION double storedEnergy(const Properties& properties, const double* F,
                                           const double* history)
{
  return withLaw<D>(properties.kind, properties.plane, EnergyCall{properties, F, history});
}

/// Upper bound of the wave speed in space, relative to the material [m/s].
template <int D>
KOKKOS_INLINE_FUNCTION double waveSpeed(const Properties& properties, const double* F, const double* history)
{
  return withLaw<D>(properties.kind, properties.plane, WaveSpeedCall{properties, F, history});
}

/// Energy dissipated so far per undeformed volume [J/m3].
template <int D>
KOKKOS_INLINE_FUNCTION double dissipatedEnergy(const Properties& properties, const double* history)
{
  return properties.kind == LawKind::J2Plastic ? history[dissipationIndex<D>] : 0.0;
}

} // namespace Rhegma
