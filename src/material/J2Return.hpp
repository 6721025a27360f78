#pragma once
/// Radial return of J2 plasticity, in the norm of the deviator alone.

#include "material/Law.hpp"

namespace Rhegma
{

/// Indices in Properties::own of the J2 law.
namespace J2Number
{
enum
{
  yield,         ///< initial yield stress [Pa]
  hardening,     ///< linear isotropic hardening modulus [Pa]
  saturation,    ///< by how much Voce hardening raises the yield stress in the end [Pa]
  saturationRate ///< exponent of Voce hardening [-]
};
} // namespace J2Number

/// sigma_y(alpha) = yield + hardening alpha + saturation (1 - exp(-rate alpha)), linear and Voce hardening
/// [Pa].
KOKKOS_INLINE_FUNCTION double yieldStress(const Properties& m, double alpha)
{
  using namespace J2Number;
  const double linear = m.own[yield] + m.own[hardening] * alpha;
  return m.own[saturation] > 0.0 ? linear - m.own[saturation] * std::expm1(-m.own[saturationRate] * alpha)
                                 : linear;
}

/// Slope of the yield stress [Pa].
KOKKOS_INLINE_FUNCTION double hardeningSlope(const Properties& m, double alpha)
{
  using namespace J2Number;
  return m.own[saturation] > 0.0 ? m.own[hardening] + m.own[saturation] * m.own[saturationRate] *
                                                          std::exp(-m.own[saturationRate] * alpha)
                                 : m.own[hardening];
}

/// Norm of the deviator on the yield surface, sqrt(2/3) sigma_y [Pa].
KOKKOS_INLINE_FUNCTION double yieldNorm(const Properties& m, double alpha)
{
  return std::sqrt(2.0 / 3.0) * yieldStress(m, alpha);
}

struct Return
{
  double multiplier;    ///< Delta gamma [-]
  double plasticStrain; ///< sqrt(2/3) Delta gamma [-]
  double norm;          ///< of the deviator after the return [Pa]
  double slope;         ///< d norm / d trial norm [-]
};

/// Solves trial - 2 shear Delta gamma = sqrt(2/3) sigma_y(alpha + sqrt(2/3) Delta gamma).
///
/// The yield stress rises ever slower, so that the difference of the two sides is convex and falls: Newton
/// from zero approaches the root from one side and can't fail; with linear hardening the first step is exact.
/// \param trial norm of the trial deviator, beyond the yield surface [Pa]
/// \param shear mu tr be / 3 [Pa]
KOKKOS_INLINE_FUNCTION Return radialReturn(const Properties& m, double trial, double shear, double alpha)
{
  const double ratio = std::sqrt(2.0 / 3.0);
  double multiplier = 0.0;
  double hardening = 0.0;
  for (int i = 0; i < 100; ++i)
  {
    const double now = alpha + ratio * multiplier;
    hardening = 2.0 / 3.0 * hardeningSlope(m, now);
    const double excess = trial - 2.0 * shear * multiplier - yieldNorm(m, now);
    const double step = excess / (2.0 * shear + hardening);
    multiplier += step;
    if (!(step > 1.0e-14 * multiplier) || !(m.own[J2Number::saturation] > 0.0))
      break;
  }
  return {multiplier, ratio * multiplier, trial - 2.0 * shear * multiplier,
          hardening / (2.0 * shear + hardening)};
}

/// u such that a deviator d plus (1 + u) 1 has determinant one: (1 + u)^3 - half (1 + u) + cube = 1.
///
/// \param half d:d/2 \param cube det d \param start a u at which that determinant is at least one; from there
/// Newton falls to the root of the convex cubic without passing it. The trial's u is one, since shrinking d
/// raises the determinant.
KOKKOS_INLINE_FUNCTION double unimodularExcess(double half, double cube, double start)
{
  double u = start;
  for (int i = 0; i < 50; ++i)
  {
    const double value = u * (3.0 + u * (3.0 + u) - half) - half + cube;
    const double step = value / (3.0 * (1.0 + u) * (1.0 + u) - half);
    u -= step;
    if (!(step > 1.0e-16))
      break;
  }
  return u;
}

/// Energy dissipated by plastic flow over |s| Delta gamma = sigma_y Delta alpha: what the flow takes out of
/// mu/2 (tr be - 3) where det be stays one; 1 + O(|s|/mu).
/// \param half, cube of the deviator d of be \param mean tr be / 3
KOKKOS_INLINE_FUNCTION double workFactor(double half, double cube, double mean)
{
  return 3.0 * mean * (mean - 1.5 * cube / half) / (3.0 * mean * mean - half);
}

} // namespace Rhegma
