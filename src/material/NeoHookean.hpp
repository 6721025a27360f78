#pragma once
/// Compressible rubber.

#include "material/AcousticBound.hpp"
#include "material/LawParameters.hpp"
#include "material/ThicknessRoot.hpp"

namespace Rhegma
{

/// W = mu/2 (tr b - 3) - mu ln J + lambda/2 (ln J)^2, tau = mu (b - 1) + lambda ln J 1.
/// Source: Bonet and Wood, Nonlinear Continuum Mechanics for Finite Element Analysis, eq. 6.27-6.29.
/// Wants lambda >= 0 (a Poisson ratio from 0 to 1/2).
struct NeoHookean : LawDefaults
{
  static constexpr const char* name = "Neo-Hookean";
  static constexpr const char* meaning = "Compressible hyperelastic solid for large strain.";

  template <class Section>
  static void describe(Section& s)
  {
    describeElasticity(s);
    describeEntropic(s);
  }
  template <class Reader>
  static void read(const Reader& reader, Properties& m)
  {
    readElasticity(reader, 0.0, m);
  }

  /// tau_zz as a function of the thickness stretch s: mu (s^2 - 1) + lambda ln(j s), which rises everywhere;
  /// its zero is between 1 and 1/j.
  struct ThicknessStress
  {
    double lambda;
    double mu;
    double area; ///< j, the area ratio of the plane
    KOKKOS_INLINE_FUNCTION double operator()(double s, double& slope) const
    {
      slope = 2.0 * mu * s * s + lambda;
      return mu * (s * s - 1.0) + lambda * std::log(area * s);
    }
  };

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static bool stress(const Properties& m, double* F, double* tau, double*)
  {
    double volumetric = 0.0;
    if constexpr (P == Plane::Stress)
    {
      const double area = planeDeterminant(F);
      if (!(area > 0.0))
        return noStress<D>(tau);
      F[4] = thicknessRoot(ThicknessStress{m.lambda, m.mu, area}, std::fmin(1.0, 1.0 / area),
                           std::fmax(1.0, 1.0 / area), F[4]);
      volumetric = m.mu * (1.0 - F[4] * F[4]); // lambda ln J where tau_zz = 0
    }
    else
    {
      const double J = determinant<D>(F);
      if (!(J > 0.0))
        return noStress<D>(tau);
      volumetric = m.lambda * std::log(J);
    }
    double g[symmetricSize<D>];
    leftStrain<D>(F, g);
    for (int i = 0; i < symmetricSize<D>; ++i)
      tau[i] = m.mu * g[i];
    for (int i = 0; i < 3; ++i)
      tau[normalIndex<D>(i)] += volumetric;
    if constexpr (P == Plane::Stress)
      tau[3] = 0.0;
    return true;
  }

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double energy(const Properties& m, const double* F, const double*)
  {
    double g[symmetricSize<D>];
    leftStrain<D>(F, g);
    const double twiceLogJ = logVolumeSquared<D>(g);
    return 0.5 * m.mu * (trace<D>(g) - twiceLogJ) + 0.125 * m.lambda * twiceLogJ * twiceLogJ;
  }

  /// rho0 c^2 = mu n.b n + p^2 (lambda + mu - lambda ln J), in plane stress with -lambda^2 / (lambda + 2 mu
  /// s^2) more in the bracket, s the thickness stretch, and tau_zz = 0 used. The largest value over all
  /// directions is exact in 2D.
  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double waveSpeed(const Properties& m, const double* F, const double*)
  {
    double g[symmetricSize<D>];
    leftStrain<D>(F, g);
    double dilatational = 0.0;
    if constexpr (P == Plane::Stress)
    {
      const double thickness = m.mu * F[4] * F[4];
      dilatational = thickness + 2.0 * m.lambda * thickness / (m.lambda + 2.0 * thickness);
    }
    else
      dilatational = std::fmax(m.mu + m.lambda * (1.0 - std::log(determinant<D>(F))), 0.0);
    return speedOf(m.mu * (1.0 + directionalRange<D>(g).largest) + dilatational, m.density);
  }
};

} // namespace Rhegma
