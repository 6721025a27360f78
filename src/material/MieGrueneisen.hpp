#pragma once
/// Pressure of shock-compressed solids.

#include "material/HighRateNumbers.hpp"
#include "material/Law.hpp"

namespace Rhegma
{

/// Equation of state of Mie and Grueneisen on the Hugoniot Us = c0 + s up, with Gamma rho = Gamma_0 rho_0:
///
///     p = f(eta) + Gamma_0 E,   f = K eta (1 - Gamma_0 eta / 2) / (1 - s eta)^2,   eta = 1 - J, K = rho_0
///     c0^2,
///
/// E the internal energy per undeformed volume. In tension f = K eta. Without heat dE = p d eta, with heat Q
/// in addition. Temperature follows dT = Gamma_0 T d eta + dQ / (rho_0 c). Source: Meyers, Dynamic Behavior
/// of Materials, chapter 5.
struct MieGrueneisen
{
  double stiffness, slope, gamma; ///< K [Pa], s, Gamma_0

  KOKKOS_INLINE_FUNCTION explicit MieGrueneisen(const Properties& m)
      : stiffness(m.bulk),
        slope(m.own[HighRateNumber::hugoniotSlope]),
        gamma(m.own[HighRateNumber::grueneisen])
  {
  }

  /// Whether the material can have this volume: compression has a limit at eta = 1/s.
  KOKKOS_INLINE_FUNCTION bool allows(double J) const { return slope * (1.0 - J) < 1.0; }

  /// f and df / d eta [Pa].
  struct Cold
  {
    double pressure, slope;
  };

  KOKKOS_INLINE_FUNCTION Cold cold(double eta) const
  {
    if (!(eta > 0.0))
      return {stiffness * eta, stiffness};
    const double inverse = 1.0 / (1.0 - slope * eta), square = stiffness * inverse * inverse;
    const double rest = 1.0 - 0.5 * gamma * eta;
    return {square * eta * rest, square * ((1.0 + slope * eta) * inverse * rest - 0.5 * gamma * eta)};
  }

  /// Internal energy after a change of volume without heat, by Simpson's rule for the integral of f
  /// exp(Gamma_0 (eta' - eta)): an error of fifth order in the change. \param factor out: exp(Gamma_0 change)
  KOKKOS_INLINE_FUNCTION double compress(double energy, double from, double to, double& factor) const
  {
    const double change = to - from, half = exponential(0.5 * gamma * change);
    factor = half * half;
    return energy * factor + change / 6.0 *
                                 (cold(from).pressure * factor +
                                  4.0 * cold(0.5 * (from + to)).pressure * half + cold(to).pressure);
  }

  /// Pressure, and rho_0 times the square of the speed of sound in the volume, relative to the material [Pa].
  KOKKOS_INLINE_FUNCTION double pressure(double J, double energy, double& modulus) const
  {
    const Cold at = cold(1.0 - J);
    const double p = at.pressure + gamma * energy;
    modulus = J * J * (at.slope + gamma * p);
    return p;
  }

private:
  /// exp(x), by its series where a step changes the volume little; the first term left out is 2e-18.
  KOKKOS_INLINE_FUNCTION static double exponential(double x)
  {
    if (std::fabs(x) > 0.01)
      return std::exp(x);
    return 1.0 + x * (1.0 + x / 2.0 * (1.0 + x / 3.0 * (1.0 + x / 4.0 * (1.0 + x / 5.0 * (1.0 + x / 6.0)))));
  }
};

} // namespace Rhegma
