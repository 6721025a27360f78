#pragma once
/// Equations of state of fluids. E is the internal energy per undeformed volume above that of the undeformed
/// fluid [J/m3].

#include "material/ExponentialRest.hpp"
#include "material/Law.hpp"

namespace Rhegma
{

/// Numbers of the law Fluid.
namespace FluidNumber
{
/// Indices in Properties::own.
enum
{
  state,             ///< a FluidState
  initialPressure,   ///< at J = 1 [Pa]
  exponent,          ///< gamma of an ideal gas, n of Tait [-]
  cutOff,            ///< least pressure of Tait [Pa]
  viscosity,         ///< [Pa s]
  linearViscosity,   ///< coefficient of artificial viscosity [-]
  quadraticViscosity ///< [-]
};
} // namespace FluidNumber

enum class FluidState
{
  idealGas,
  tait
};

/// p = (gamma - 1) (E0 + E) / J, E0 = p0 / (gamma - 1). Without heat p J^gamma and E0 + E over J^(1 - gamma)
/// are constant, exactly in each step; the temperature is proportional to E0 + E. Never negative. Source:
/// Landau and Lifshitz, Statistical Physics, section 43.
struct IdealGas
{
  double rest;  ///< E0 [J/m3]
  double gamma; ///< ratio of specific heats

  KOKKOS_INLINE_FUNCTION explicit IdealGas(const Properties& m)
      : rest(m.own[FluidNumber::initialPressure] / (m.own[FluidNumber::exponent] - 1.0)),
        gamma(m.own[FluidNumber::exponent])
  {
  }

  /// E after a change of volume without heat [J/m3]. \param before, J volume ratios
  KOKKOS_INLINE_FUNCTION double compress(double energy, double before, double J) const
  {
    const double rise = std::expm1((gamma - 1.0) * std::log(before / J));
    return energy + (rest + energy) * rise;
  }

  /// Pressure, and rho_0 times the square of the speed of sound [Pa].
  KOKKOS_INLINE_FUNCTION double pressure(double J, double energy, double& modulus) const
  {
    const double p = (gamma - 1.0) * (rest + energy) / J;
    modulus = gamma * p * J;
    return p;
  }
};

/// p = p0 + K/n (J^-n - 1), without an effect of heat; below the cut-off, where the liquid has voids, the
/// pressure is that. E is the integral of -p dJ from 1, so that it is a function of J. Source: Cole,
/// Underwater Explosions (1948), section 2.3, for water n = 7.15 (Tait's equation as modified by Kirkwood).
struct Tait
{
  double bulk, start, exponent, least;

  KOKKOS_INLINE_FUNCTION explicit Tait(const Properties& m)
      : bulk(m.bulk),
        start(m.own[FluidNumber::initialPressure]),
        exponent(m.own[FluidNumber::exponent]),
        least(m.own[FluidNumber::cutOff])
  {
  }

  /// J from which on the liquid has voids; infinite where the pressure never falls so low.
  KOKKOS_INLINE_FUNCTION double voidsFrom() const
  {
    const double power = 1.0 + exponent * (least - start) / bulk;
    constexpr double never = 1.0e300;
    return power > 0.0 ? std::exp(-std::log(power) / exponent) : never;
  }

  KOKKOS_INLINE_FUNCTION double energy(double J) const
  {
    const double voids = voidsFrom(), liquid = J < voids ? J : voids;
    const double x = std::log(liquid);
    // The first terms of both exponentials cancel.
    const double stored =
        bulk / exponent * (exponentialRest((1.0 - exponent) * x) / (exponent - 1.0) + exponentialRest(x));
    const double constant = -start * (liquid - 1.0);
    return J < voids ? stored + constant : stored + constant - least * (J - voids);
  }

  /// Pressure, and a bound of rho_0 times the square of the speed of sound [Pa]: with voids that of the
  /// liquid, which closes again.
  KOKKOS_INLINE_FUNCTION double pressure(double J, double& modulus) const
  {
    const double power = std::exp(-exponent * std::log(J));
    const double p = start + bulk / exponent * (power - 1.0);
    const double voids = p > least ? 1.0 : voidsFrom();
    modulus = p > least ? bulk * J * power : bulk * std::exp((1.0 - exponent) * std::log(voids));
    return p > least ? p : least;
  }
};

} // namespace Rhegma
