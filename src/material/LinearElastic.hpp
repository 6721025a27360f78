#pragma once
/// Linear elasticity with finite rotations.

#include "material/AcousticBound.hpp"
#include "material/LawParameters.hpp"

namespace Rhegma
{

/// Saint Venant-Kirchhoff: W = lambda/2 (tr E)^2 + mu E:E, E = (F^T F - 1)/2; Hooke's law in any rotated
/// frame.
///
/// With g = F F^T - 1 the stress is tau = lambda/2 tr g (1 + g) + mu (g + g g), which needs neither E nor a
/// rotation. Plane stress is closed: E_zz = -nu/(1 - nu) (E_xx + E_yy). It is meant for small strain. In
/// uniaxial compression it softens: its force is largest at the stretch 1/sqrt(3) = 0.577 and vanishes at
/// stretch zero; use Neo-Hookean for large strains. In plane stress the thickness vanishes at E_xx + E_yy =
/// (1 - nu)/(2 nu), where `stress` returns false. Source: Holzapfel, Nonlinear Solid Mechanics, section 6.5.
struct LinearElastic : LawDefaults
{
  static constexpr const char* name = "Linear Elastic";
  static constexpr const char* meaning =
      "Isotropic linear elasticity for small strain; rotations may be large.";

  static constexpr bool linear = true;
  static constexpr int yieldAt = 0; ///< in Properties::own [Pa]
  /// Known for warnings only; the law does not yield.
  static double firstYield(const Properties& m) { return m.own[yieldAt]; }

  template <class Section>
  static void describe(Section& s)
  {
    describeElasticity(s);
    s.real("Yield Stress")
        .orTable()
        .unit("Pa")
        .positive()
        .optional("not known")
        .meaning("Stress in tension at which the material yields. The law stays linear; warnings compare "
                 "stresses with it.");
  }
  template <class Reader>
  static void read(const Reader& reader, Properties& m)
  {
    readElasticity(reader, -1.0, m);
    m.own[yieldAt] = reader.optional("Yield Stress", "yield stress [Pa]");
  }

  template <int D, Plane P>
  KOKKOS_FORCEINLINE_FUNCTION static bool stress(const Properties& m, double* F, double* tau, double*)
  {
    double g[symmetricSize<D>];
    leftStrain<D>(F, g);
    double gg[symmetricSize<D>];
    square<D>(g, gg);
    const double mu = m.mu;
    const double traceG = P == Plane::Stress ? g[0] + g[1] : trace<D>(g);
    const double pressure = 0.5 * m.planeLambda * traceG;
    const double factor = mu + pressure;
    const double thickness = 1.0 - m.thicknessRatio * traceG;
    // Without a branch, so that the compiler can find the stress of several particles at once.
    bool good = (P == Plane::Stress ? planeDeterminant(F) : determinant<D>(F)) > 0.0;
    if constexpr (P == Plane::Stress)
      good = good && thickness > 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const int normal = normalIndex<D>(i);
      tau[normal] = good ? pressure + factor * g[normal] + mu * gg[normal] : 0.0;
    }
    for (int i = shearBegin<D>; i < shearEnd<D>; ++i)
      tau[i] = good ? factor * g[i] + mu * gg[i] : 0.0;
    if constexpr (P == Plane::Stress)
    {
      F[4] = good ? std::sqrt(thickness) : F[4];
      tau[3] = 0.0;
    }
    return good;
  }

  template <int D, Plane P>
  KOKKOS_FORCEINLINE_FUNCTION static double energy(const Properties& m, const double* F, const double*)
  {
    // E and g/2 have the same invariants; in plane stress F[4] brings E_zz.
    double g[symmetricSize<D>];
    leftStrain<D>(F, g);
    const double traceG = trace<D>(g);
    return 0.125 * m.lambda * traceG * traceG + 0.25 * m.mu * squaredNorm<D>(g);
  }

  /// rho0 c^2 = n.tau n + (lambda + mu) (m.b n)^2 + mu (n.b n) (m.b m): at most the largest stress plus
  /// (lambda + 2 mu) times the squared largest eigenvalue of b. An eigenvalue of tau is a convex function of
  /// that of g.
  template <int D, Plane P>
  KOKKOS_FORCEINLINE_FUNCTION static double waveSpeed(const Properties& m, const double* F, const double*)
  {
    double g[symmetricSize<D>];
    leftStrain<D>(F, g);
    const EigenvalueRange range = directionalRange<D>(g);
    const double pressure = 0.5 * m.planeLambda * (P == Plane::Stress ? g[0] + g[1] : trace<D>(g));
    const double factor = m.mu + pressure;
    const double stress = pressure + larger((factor + m.mu * range.largest) * range.largest,
                                            (factor + m.mu * range.smallest) * range.smallest);
    const double b = 1.0 + range.largest;
    return speedOf(stress + (m.planeLambda + 2.0 * m.mu) * b * b, m.density);
  }
};

} // namespace Rhegma
