#pragma once
/// Metal plasticity at finite strain.

#include "material/AcousticBound.hpp"
#include "material/J2Return.hpp"
#include "material/LawParameters.hpp"
#include "material/PlasticSplit.hpp"

namespace Rhegma
{

/// Multiplicative J2 plasticity with isotropic hardening: W = K/2 ((J^2 - 1)/2 - ln J) + mu/2 (tr be - 3),
/// tau = K/2 (J^2 - 1) 1 + mu dev be, be = J^(-2/3) F Cp^-1 F^T; yield where |dev tau| = sqrt(2/3)
/// sigma_y(alpha). Source: Simo and Hughes, Computational Inelasticity, boxes 9.1 and 9.2 (radial return),
/// with det be = 1 restored after each return: box 9.1 keeps tr be instead, and its stored energy would then
/// contain the plastic work.
///
/// The history holds Cp^-1 - 1 (Cp the plastic right Cauchy-Green tensor), the equivalent plastic strain
/// alpha and the energy dissipated per undeformed volume. Cp^-1 stands where box 9.1 stores be: the same
/// state, but it changes only in plastic steps, needs no increment of F, and elastic steps add no round-off.
struct J2Plastic : LawDefaults
{
  static constexpr const char* name = "J2 Plastic";
  static constexpr const char* meaning =
      "Metal plasticity: von Mises yield condition with isotropic hardening.";

  template <int D>
  static constexpr int plasticStrainIndex = symmetricSize<D>;
  template <int D>
  static constexpr int dissipationIndex = symmetricSize<D> + 1;
  template <int D>
  static constexpr int historySize = symmetricSize<D> + 2;

  static double firstYield(const Properties& m) { return m.own[J2Number::yield]; }

  template <class Section>
  static void describe(Section& s)
  {
    describeElasticity(s);
    s.real("Yield Stress").orTable().unit("Pa").positive().meaning("Initial yield stress in tension.");
    s.real("Hardening Modulus")
        .orTable()
        .unit("Pa")
        .notNegative()
        .byDefault(0.0)
        .meaning("Linear isotropic hardening: increase of the yield stress per unit of plastic strain.");
    s.real("Saturation Stress")
        .orTable()
        .unit("Pa")
        .positive()
        .optional()
        .meaning("Saturation yield stress of Voce hardening, at least Yield Stress. Hardening Modulus adds "
                 "to it.");
    s.real("Saturation Rate")
        .orTable()
        .positive()
        .optional()
        .meaning(
            "Rate of Voce hardening. Yield stress = Yield Stress + (Saturation Stress - Yield Stress) (1 "
            "- exp(-Saturation Rate x plastic strain)) + Hardening Modulus x plastic strain.");
    s.allOrNoneOf({"Saturation Stress", "Saturation Rate"});
    describeHeatOfDissipation(s);
  }

  template <class Reader>
  static void read(const Reader& reader, Properties& m)
  {
    using namespace J2Number;
    readElasticity(reader, -1.0, m);
    m.own[yield] = reader.positive("Yield Stress", "yield stress [Pa]");
    m.own[hardening] = reader.optional("Hardening Modulus", "hardening modulus [Pa]");
    const double limit = reader.optional("Saturation Stress", "saturation yield stress [Pa]");
    m.own[saturationRate] = reader.optional("Saturation Rate", "rate of saturation");
    if ((limit > 0.0) != (m.own[saturationRate] > 0.0))
      reader.refuse(limit > 0.0 ? "Saturation Rate" : "Saturation Stress",
                    "is missing; give both Saturation Stress and Saturation Rate, or neither.");
    if (limit > 0.0 && limit < m.own[yield])
      reader.refuse("Saturation Stress", "is " + Reader::text(limit) + ", below the yield stress " +
                                             Reader::text(m.own[yield]) +
                                             "; give at least the yield stress.");
    m.own[saturation] = limit > 0.0 ? limit - m.own[yield] : 0.0;
  }

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static bool stress(const Properties& m, double* F, double* tau, double* history)
  {
    if constexpr (P == Plane::Stress)
    {
      if (!(planeDeterminant(F) > 0.0))
        return noStress<D>(tau);
      F[4] = thicknessStretch(m, F, history);
    }
    const double J = determinant<D>(F);
    if (!(J > 0.0))
      return noStress<D>(tau);

    double strain[symmetricSize<D>]; // deviator of be
    const double scale = isochoricScale(J), excess = elasticStrain<D>(F, scale, history, strain);
    const double trial = m.mu * std::sqrt(squaredNorm<D>(strain));
    const double limit = yieldNorm(m, history[plasticStrainIndex<D>]);
    if (trial > limit)
    {
      const Return flow = radialReturn(m, trial, m.mu * (1.0 + excess), history[plasticStrainIndex<D>]);
      const double shrink = flow.norm / trial;
      storeFlow<D>(m, F, J, scale, strain, excess, shrink, flow, history);
      for (int i = 0; i < symmetricSize<D>; ++i)
        strain[i] *= shrink;
    }
    for (int i = 0; i < symmetricSize<D>; ++i)
      tau[i] = m.mu * strain[i];
    const double shift = P == Plane::Stress ? -tau[normalIndex<D>(2)] : 0.5 * m.bulk * (J - 1.0) * (J + 1.0);
    for (int i = 0; i < 3; ++i)
      tau[normalIndex<D>(i)] += shift;
    return true;
  }

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double energy(const Properties& m, const double* F, const double* history)
  {
    double g[symmetricSize<D>];
    leftStrain<D>(F, g);
    const double twiceLogJ = logVolumeSquared<D>(g);
    const double scale = std::expm1(-twiceLogJ / 3.0); // J^(-2/3) - 1
    double plastic[symmetricSize<D>];
    pushForward<D>(F, history, plastic);
    const double traceBe = trace<D>(g) + trace<D>(plastic); // less 3
    return 0.25 * m.bulk * (std::expm1(twiceLogJ) - twiceLogJ) +
           0.5 * m.mu * ((1.0 + scale) * traceBe + 3.0 * scale);
  }

  /// Of the elastic response: plastic flow only slows waves down.
  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double waveSpeed(const Properties& m, const double* F, const double* history)
  {
    const double J = determinant<D>(F);
    double be[symmetricSize<D>];
    const double excess = elasticStrain<D>(F, isochoricScale(J), history, be);
    for (int i = 0; i < 3; ++i)
      be[normalIndex<D>(i)] += 1.0 + excess;
    const EigenvalueRange range = directionalRange<D>(be);
    const double dilatational = 0.5 * m.bulk * (J * J + 1.0);
    if constexpr (P == Plane::Stress)
    {
      const double volumetric = m.bulk * J * J, theta = relaxation(thicknessModulus(m.mu, be), volumetric);
      return speedOf(isochoricPlaneModulus(m.mu, be, range, theta, volumetric, dilatational), m.density);
    }
    else
      return speedOf(0.5 * m.mu * firstInvariantBound(trace<D>(be), range) + dilatational, m.density);
  }

private:
  /// Moves the history along a return that shrinks the trial deviator of be by `shrink`.
  template <int D>
  KOKKOS_INLINE_FUNCTION static void storeFlow(const Properties& m, const double* F, double J, double scale,
                                               const double* deviator, double excess, double shrink,
                                               const Return& flow, double* history)
  {
    const double factor = flowBack<D>(F, J, scale, deviator, shrink, excess, history);
    double& alpha = history[plasticStrainIndex<D>];
    const double before = yieldStress(m, alpha);
    alpha += flow.plasticStrain;
    const double work = 0.5 * (before + yieldStress(m, alpha)) * flow.plasticStrain;
    history[dissipationIndex<D>] += work * factor;
  }

  /// Yield condition and return, for the thickness stretch.
  struct Flow
  {
    const Properties& m;
    double alpha;
    KOKKOS_INLINE_FUNCTION double norm() const { return yieldNorm(m, alpha); }
    KOKKOS_INLINE_FUNCTION Return solve(double trial, double shear) const
    {
      return radialReturn(m, trial, shear, alpha);
    }
  };

  KOKKOS_INLINE_FUNCTION static double thicknessStretch(const Properties& m, const double* F,
                                                        const double* history)
  {
    return plasticThickness(Flow{m, history[plasticStrainIndex<2>]}, m, F, history);
  }
};

} // namespace Rhegma
