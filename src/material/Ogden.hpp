#pragma once
/// Rubber at very large stretch.

#include "material/ExponentialRest.hpp"
#include "material/LawParameters.hpp"
#include "material/OgdenParameters.hpp"
#include "material/PrincipalStretches.hpp"
#include "material/ThicknessRoot.hpp"

namespace Rhegma
{

/// W = sum_p mu_p / alpha_p (l1^alpha_p + l2^alpha_p + l3^alpha_p - 3) + K/2 (J - 1)^2, with the isochoric
/// principal stretches l_i = J^(-1/3) lambda_i; principal values of tau: sum_p mu_p dev l_i^alpha_p +
/// K J (J - 1). Sources: Ogden, Proc. R. Soc. Lond. A 326 (1972) 565, and for the compressible solid 328
/// (1972) 567; Holzapfel, Nonlinear Solid Mechanics, eq. 6.119 with the isochoric split of section 6.4. With
/// alpha = 2 and -2 it is Mooney-Rivlin, C10 = mu_1 / 2 and C01 = -mu_2 / 2.
///
/// Wants mu_p alpha_p > 0 in each term: then, at constant volume, the Kirchhoff stress rises with the
/// logarithmic strain (Hill) and the larger stress lies along the larger stretch (Baker and Ericksen).
struct Ogden : LawDefaults
{
  static constexpr const char* name = "Ogden";
  static constexpr const char* meaning = "Hyperelastic rubber for very large stretch: a sum of powers of the "
                                         "principal stretches; nearly incompressible if the bulk modulus is "
                                         "large.";

  template <class Section>
  static void describe(Section& s)
  {
    describeOgden(s);
  }
  template <class Reader>
  static void read(const Reader& reader, Properties& m)
  {
    readOgden(reader, m);
  }

  static void scaleShear(Properties& m, double factor)
  {
    for (int p = 0; p < OgdenNumber::terms; ++p)
      m.own[OgdenNumber::modulus + p] *= factor;
  }

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static bool stress(const Properties& m, double* F, double* tau, double*)
  {
    if (!((P == Plane::Stress ? planeDeterminant(F) : determinant<D>(F)) > 0.0))
      return noStress<D>(tau);
    PrincipalStretches<D> stretches(F);
    if constexpr (P == Plane::Stress)
      F[4] = thicknessStretch(m, stretches.log[0], stretches.log[1], F[4]);
    if constexpr (D == 2)
      stretches.log[2] = std::log(F[4]);
    double t[3], slope[3];
    const double sum = principalStress(m, stretches.log, t, slope);
    // A stretch that rounding has made negative, or a number that is none.
    if (!std::isfinite(sum))
      return noStress<D>(tau);
    // In plane stress the pressure is the one that cancels tau_zz: no difference of large numbers.
    double shift = -t[2];
    if constexpr (P != Plane::Stress)
    {
      const double J = determinant<D>(F);
      shift = m.bulk * J * (J - 1.0) - sum / 3.0;
    }
    for (double& value : t)
      value += shift;
    stretches.assemble(t, tau);
    return true;
  }

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double energy(const Properties& m, const double* F, const double*)
  {
    double e[3], square[3];
    PrincipalStretches<D>::logarithms(F, e, square);
    const double logJ = e[0] + e[1] + e[2], dilatation = std::expm1(logJ);
    double shape = 0.0;
    for (int p = 0; p < count(m); ++p)
    {
      // The isochoric logarithms add up to nothing, and so do the first terms of their exponentials.
      const double alpha = exponent(m, p);
      double sum = 0.0;
      for (int i = 0; i < 3; ++i)
        sum += exponentialRest(alpha * (e[i] - logJ / 3.0));
      shape += modulus(m, p) / alpha * sum;
    }
    return shape + 0.5 * m.bulk * dilatation * dilatation;
  }

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double waveSpeed(const Properties& m, const double* F, const double*)
  {
    double e[3], square[3];
    PrincipalStretches<D>::logarithms(F, e, square);
    PrincipalTangent at;
    const double sum = principalStress(m, e, at.stress, at.curvature);
    const double J = determinant<D>(F);
    const double shift = P == Plane::Stress ? -at.stress[2] : m.bulk * J * (J - 1.0) - sum / 3.0;
    for (double& value : at.stress)
      value += shift;
    at.volumetric = m.bulk * J * (2.0 * J - 1.0);
    return speedOf(principalWaveModulus<D, P>(at, square), m.density);
  }

private:
  KOKKOS_FORCEINLINE_FUNCTION static int count(const Properties& m)
  {
    return static_cast<int>(m.own[OgdenNumber::count]);
  }
  KOKKOS_FORCEINLINE_FUNCTION static double modulus(const Properties& m, int p)
  {
    return m.own[OgdenNumber::modulus + p];
  }
  KOKKOS_FORCEINLINE_FUNCTION static double exponent(const Properties& m, int p)
  {
    return m.own[OgdenNumber::exponent + p];
  }

  /// f(e) = sum_p mu_p (exp(alpha_p e) - 1) of the isochoric logarithms, and f'. \return the sum of f
  KOKKOS_INLINE_FUNCTION static double principalStress(const Properties& m, const double (&log)[3],
                                                       double (&f)[3], double (&slope)[3])
  {
    const double mean = (log[0] + log[1] + log[2]) / 3.0;
    for (int i = 0; i < 3; ++i)
      f[i] = slope[i] = 0.0;
    for (int p = 0; p < count(m); ++p)
      for (int i = 0; i < 3; ++i)
      {
        const double power = std::exp(exponent(m, p) * (log[i] - mean));
        f[i] += modulus(m, p) * (power - 1.0);
        slope[i] += modulus(m, p) * exponent(m, p) * power;
      }
    return f[0] + f[1] + f[2];
  }

  /// tau_zz as a function of the thickness stretch. Its part of the shape rises and is zero between the two
  /// stretches of the plane, that of the volume is negative below J = 1 and positive above.
  struct ThicknessStress
  {
    const Properties& m;
    double first, second; ///< logarithms of the stretches in the plane

    KOKKOS_INLINE_FUNCTION double operator()(double s, double& slope) const
    {
      const double log[3] = {first, second, std::log(s)};
      double f[3], h[3];
      const double sum = principalStress(m, log, f, h);
      const double J = std::exp(first + second) * s;
      slope = (4.0 * h[2] + h[0] + h[1]) / 9.0 + m.bulk * J * (2.0 * J - 1.0);
      return f[2] - sum / 3.0 + m.bulk * J * (J - 1.0);
    }
  };

  KOKKOS_INLINE_FUNCTION static double thicknessStretch(const Properties& m, double first, double second,
                                                        double start)
  {
    const double unchanged = -(first + second);
    const double low = std::fmin(std::fmin(first, second), unchanged);
    const double high = std::fmax(std::fmax(first, second), unchanged);
    return thicknessRoot(ThicknessStress{m, first, second}, std::exp(low), std::exp(high), start);
  }
};

} // namespace Rhegma
