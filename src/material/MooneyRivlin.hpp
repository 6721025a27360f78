#pragma once
/// Nearly incompressible rubber.

#include "material/AcousticBound.hpp"
#include "material/LawParameters.hpp"
#include "material/ThicknessRoot.hpp"

namespace Rhegma
{

/// W = C10 (J^(-2/3) tr b - 3) + C01 (J^(-4/3) tr cof b - 3) + K/2 (J - 1)^2;
/// tau = 2 C10 J^(-2/3) dev b + 2 C01 J^(-4/3) dev(tr b b - b b) + K J (J - 1) 1.
/// Source: Holzapfel, Nonlinear Solid Mechanics, eq. 6.146-6.147 with the isochoric split of section 6.4.
/// Wants C10, C01 >= 0, not both zero, and K > 0.
struct MooneyRivlin : LawDefaults
{
  static constexpr const char* name = "Mooney-Rivlin";
  static constexpr const char* meaning =
      "Hyperelastic rubber with two shear constants; nearly incompressible if the bulk modulus is large.";

  /// Indices in Properties::own [Pa].
  enum
  {
    c10,
    c01
  };

  template <class Section>
  static void describe(Section& s)
  {
    describeDensity(s);
    s.real("C10").orTable().unit("Pa").notNegative().meaning(
        "Coefficient of the first invariant. C10 and C01 must not both be zero.");
    s.real("C01").orTable().unit("Pa").notNegative().meaning("Coefficient of the second invariant.");
    s.real("Bulk Modulus").orTable().unit("Pa").positive().meaning("Bulk modulus.");
    describeEntropic(s);
  }

  template <class Reader>
  static void read(const Reader& reader, Properties& m)
  {
    m.own[c10] = reader.zeroOrMore("C10", "constant [Pa]");
    m.own[c01] = reader.zeroOrMore("C01", "constant [Pa]");
    m.bulk = reader.positive("Bulk Modulus", "bulk modulus [Pa]");
    m.mu = 2.0 * (m.own[c10] + m.own[c01]);
    if (!(m.mu > 0.0))
      reader.refuse("C10", "and C01 are both zero, which is a fluid; make at least one of them positive.");
    m.lambda = m.bulk - 2.0 / 3.0 * m.mu;
    if (m.lambda < 0.0)
      reader.refuse("Bulk Modulus",
                    "is " + Reader::text(m.bulk) + "; this law is for nearly incompressible material, " +
                        "give at least 4/3 (C10 + C01) = " + Reader::text(2.0 / 3.0 * m.mu) + ".");
  }

  static void scaleShear(Properties& m, double factor)
  {
    m.own[c10] *= factor;
    m.own[c01] *= factor;
  }

  /// tau_zz as a function of the thickness stretch s. Each of its three terms has one zero and is
  /// negative below and positive above it, so that the zero of the sum is between the outermost of them.
  struct ThicknessStress
  {
    double c10;
    double c01;
    double bulk;
    double area;   ///< j, the area ratio of the plane
    double traceB; ///< b_xx + b_yy

    KOKKOS_INLINE_FUNCTION double operator()(double s, double& slope) const
    {
      const double J = area * s;
      const double root = std::cbrt(J);
      const double scale = 1.0 / (root * root); // J^(-2/3)
      const double first = c10 * scale;
      const double second = c01 * scale * scale;
      slope = thicknessStiffness(s * s, first, second) + bulk * J * (2.0 * J - 1.0);
      return first * (4.0 * s * s - 2.0 * traceB) / 3.0 +
             second * (2.0 * traceB * s * s - 4.0 * area * area) / 3.0 + bulk * J * (J - 1.0);
    }

    /// Second derivative of the isochoric energy by ln s.
    KOKKOS_INLINE_FUNCTION double thicknessStiffness(double ss, double first, double second) const
    {
      return (first * (4.0 * traceB + 16.0 * ss) + second * (16.0 * area * area + 4.0 * traceB * ss)) / 9.0;
    }

    KOKKOS_INLINE_FUNCTION double solve(double start) const
    {
      const double a = 0.5 * traceB;        // s^2 where the first term vanishes
      const double b = area * area / a;     // the second
      const double c = 1.0 / (area * area); // the third
      return thicknessRoot(*this, std::sqrt(std::fmin(b, c)), std::sqrt(std::fmax(a, c)), start);
    }
  };

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static bool stress(const Properties& m, double* F, double* tau, double*)
  {
    if constexpr (P == Plane::Stress)
    {
      const double area = planeDeterminant(F);
      if (!(area > 0.0))
        return noStress<D>(tau);
      const double traceB = F[0] * F[0] + F[1] * F[1] + F[2] * F[2] + F[3] * F[3];
      F[4] = ThicknessStress{m.own[c10], m.own[c01], m.bulk, area, traceB}.solve(F[4]);
    }
    const double J = determinant<D>(F);
    if (!(J > 0.0))
      return noStress<D>(tau);
    const double root = std::cbrt(J);
    const double scale = 1.0 / (root * root); // J^(-2/3)

    // dev(tr b b - b b) = dev((1 + tr g) g - g g) with g = b - 1.
    double g[symmetricSize<D>];
    leftStrain<D>(F, g);
    double gg[symmetricSize<D>];
    square<D>(g, gg);
    const double second = 2.0 * m.own[c01] * scale * scale;
    const double first = 2.0 * m.own[c10] * scale + second * (1.0 + trace<D>(g));
    for (int i = 0; i < symmetricSize<D>; ++i)
      tau[i] = first * g[i] - second * gg[i];
    // In plane stress the pressure is the one that cancels tau_zz: no difference of large numbers.
    const double shift =
        P == Plane::Stress ? -tau[normalIndex<D>(2)] : m.bulk * J * (J - 1.0) - trace<D>(tau) / 3.0;
    for (int i = 0; i < 3; ++i)
      tau[normalIndex<D>(i)] += shift;
    return true;
  }

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double energy(const Properties& m, const double* F, const double*)
  {
    double g[symmetricSize<D>];
    leftStrain<D>(F, g);
    const double twiceLogJ = logVolumeSquared<D>(g);
    const double first = std::expm1(-twiceLogJ / 3.0);        // J^(-2/3) - 1
    const double second = std::expm1(-2.0 * twiceLogJ / 3.0); // J^(-4/3) - 1
    const double dilatation = std::expm1(0.5 * twiceLogJ);    // J - 1
    const double traceG = trace<D>(g);
    const double cofactor = 2.0 * traceG + secondInvariant<D>(g); // tr cof b - 3
    return m.own[c10] * ((1.0 + first) * traceG + 3.0 * first) +
           m.own[c01] * ((1.0 + second) * cofactor + 3.0 * second) + 0.5 * m.bulk * dilatation * dilatation;
  }

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double waveSpeed(const Properties& m, const double* F, const double*)
  {
    const double J = determinant<D>(F);
    const double root = std::cbrt(J);
    const double scale = 1.0 / (root * root);
    double b[symmetricSize<D>];
    leftStrain<D>(F, b);
    for (int i = 0; i < 3; ++i)
      b[normalIndex<D>(i)] += 1.0;
    const EigenvalueRange range = directionalRange<D>(b);
    const double first = m.own[c10] * scale;
    const double second = m.own[c01] * scale * scale;
    if constexpr (P == Plane::Stress)
      return speedOf(relaxedModulus(m, b, range, first, second, J), m.density);

    const double traceB = trace<D>(b);
    const double traceCofactor = secondInvariant<D>(b);
    const double largestCofactor = D == 2 ? b[normalIndex<D>(2)] * range.largest
                                          : eigenvalueRange(traceCofactor, traceB * J * J).largest;
    return speedOf(first * firstInvariantBound(traceB, range) +
                       second * secondInvariantBound(traceCofactor, largestCofactor) + m.bulk * J * J,
                   m.density);
  }

private:
  /// rho0 c^2 with a free thickness (AcousticBound.hpp). \param b has four components
  KOKKOS_INLINE_FUNCTION static double relaxedModulus(const Properties& m, const double* b,
                                                      EigenvalueRange range, double first, double second,
                                                      double J)
  {
    const double ss = b[3];
    const double traceB = b[0] + b[1];
    const double jj = J * J / ss; // j^2
    const double isochoric =
        ThicknessStress{m.own[c10], m.own[c01], m.bulk, std::sqrt(jj), traceB}.thicknessStiffness(ss, first,
                                                                                                  second);
    const double volumetric = m.bulk * J * (2.0 * J - 1.0);
    const double theta = relaxation(isochoric, volumetric);

    const double alpha = 2.0 * (first + second * ss);
    const double beta = first * 8.0 / 3.0 * (1.0 - theta) + second * ss * (16.0 + 8.0 * theta) / 3.0;
    const double mixed = first * (4.0 * traceB - 8.0 * ss) - second * 8.0 * (jj + ss * traceB);
    const double gamma = (first * 10.0 * (traceB + ss) + second * (28.0 * ss * traceB - 2.0 * jj)) / 9.0 -
                         2.0 * theta * mixed / 9.0 + theta * theta * isochoric + m.bulk * J * J -
                         2.0 * theta * volumetric + theta * theta * volumetric;
    return planeBound(alpha, beta, gamma, range);
  }
};

} // namespace Rhegma
