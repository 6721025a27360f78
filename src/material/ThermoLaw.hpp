#pragma once
/// Stress and internal energy of every constitutive law at a temperature.
///
/// The free energy per undeformed volume is psi(F, T) = W(F / theta; T) + psi_T(T): the law's own energy W,
/// with its moduli at T, of what of F is not thermal strain, theta = 1 + integral of alpha (a multiplicative,
/// isotropic split: Holzapfel, Nonlinear Solid Mechanics, section 7.8). With dW/dT at fixed F,
///
///     W_T = -alpha / theta tr tau + W(F / theta; d moduli / dT),
///
/// the internal energy is e = W - T W_T + h, and psi_T is chosen so that the capacity at constant strain is
/// the given rho c in the undeformed state: h = integral of rho c + 9 K alpha^2 (T^2 - T0^2) / 2. From this
/// the first law yields all that heats a strained body: the thermoelastic term -T (C alpha) : deps, entropic
/// heating where moduli rise with T, and, since W alone is stored, the fraction of plastic work that is not
/// kept as cold work.

#include "material/Materials.hpp"
#include "material/ThermoTables.hpp"

namespace Rhegma
{

/// dW/dT at fixed F [J/(m3 K)]. \param own F without thermal strain \param tau the stress of it
template <class Law, int D, Plane P>
KOKKOS_INLINE_FUNCTION double energySlope(const ThermoPoint& at, const double* own, const double* tau,
                                          const double* history)
{
  double slope = -at.expansion() / at.stretch() * trace<D>(tau);
  if (at.varies())
    slope += Law::template energy<D, P>(at.slope(), own, history);
  return slope;
}

/// State of one particle at a temperature, per undeformed volume.
struct ThermoState
{
  double stored = 0.0;     ///< W [J/m3]
  double dissipated = 0.0; ///< plastic work so far less the part stored in W [J/m3]
  double slope = 0.0;      ///< dW/dT at fixed F [J/(m3 K)]
  double internal = 0.0;   ///< internal energy e [J/m3]
  double wave = 0.0;       ///< wave speed of the law with adiabatic stiffening [m/s]

  /// Energy put in by straining: W and plastic dissipation.
  KOKKOS_INLINE_FUNCTION double spent() const { return stored + dissipated; }
};

/// Stress and energies of one particle, F and history as the law's own `stress` has them.
struct ThermoStress
{
  const LawStep& step; ///< its deformation gradient is without thermal strain
  const ThermoPoint& at;
  double temperature;
  double* F;
  double* tau;
  double* history;
  ThermoState& result; ///< out

  template <class Law, int D, Plane P>
  KOKKOS_INLINE_FUNCTION bool run() const
  {
    const double theta = at.stretch(), inverse = 1.0 / theta;
    const Properties law = at.properties();
    double own[gradientSize<D>]; // F without thermal strain
    for (int k = 0; k < gradientSize<D>; ++k)
      own[k] = inverse * F[k];
    const bool good = stressOfLaw<Law, D, P>(step, law, own, tau, history);
    if constexpr (P == Plane::Stress)
      F[4] = theta * own[4];
    result.stored = Law::template energy<D, P>(law, own, history);
    result.dissipated = dissipatedByLaw<Law, D>(history);
    result.slope = energySlope<Law, D, P>(at, own, tau, history);
    const double T0 = at.material.reference;
    result.internal = result.stored - temperature * result.slope + at.heat() +
                      0.5 * at.material.coupling * (temperature - T0) * (temperature + T0) +
                      (1.0 - at.material.plasticHeat) * result.dissipated;
    const double speed = Law::template waveSpeed<D, P>(law, own, history);
    // Adiabatic bulk modulus: K + T (3 K alpha)^2 / (rho c).
    const double push = 3.0 * law.bulk * at.expansion();
    result.wave = std::sqrt(speed * speed + temperature * push * push / (at.capacity() * law.density));
    return good;
  }
};

/// Elastic energy stored at a temperature [J/m3].
struct ThermoEnergy
{
  const ThermoPoint& at;
  const double* F;
  const double* history;

  template <class Law, int D, Plane P>
  KOKKOS_INLINE_FUNCTION double run() const
  {
    const double inverse = 1.0 / at.stretch();
    double own[gradientSize<D>];
    for (int k = 0; k < gradientSize<D>; ++k)
      own[k] = inverse * F[k];
    return Law::template energy<D, P>(at.properties(), own, history);
  }
};

/// dW/dT at fixed F of a particle whose stress is known [J/(m3 K)].
struct ThermoSlope
{
  const ThermoPoint& at;
  const double* F;
  const double* tau;
  const double* history;

  template <class Law, int D, Plane P>
  KOKKOS_INLINE_FUNCTION double run() const
  {
    const double inverse = 1.0 / at.stretch();
    double own[gradientSize<D>];
    for (int k = 0; k < gradientSize<D>; ++k)
      own[k] = inverse * F[k];
    return energySlope<Law, D, P>(at, own, tau, history);
  }
};

} // namespace Rhegma
