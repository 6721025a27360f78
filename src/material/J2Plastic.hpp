#pragma once
/// Metal plasticity at finite strain.

#include "material/AcousticBound.hpp"
#include "material/J2Return.hpp"
#include "material/LawParameters.hpp"
#include "material/ThicknessRoot.hpp"

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
    const double excess = elasticStrain<D>(F, J, history, strain);
    const double trial = m.mu * std::sqrt(squaredNorm<D>(strain));
    const double limit = yieldNorm(m, history[plasticStrainIndex<D>]);
    if (trial > limit)
    {
      const Return flow = radialReturn(m, trial, m.mu * (1.0 + excess), history[plasticStrainIndex<D>]);
      const double shrink = flow.norm / trial;
      storeFlow<D>(m, F, J, strain, excess, shrink, flow, history);
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
    const double excess = elasticStrain<D>(F, J, history, be);
    for (int i = 0; i < 3; ++i)
      be[normalIndex<D>(i)] += 1.0 + excess;
    const EigenvalueRange range = directionalRange<D>(be);
    const double dilatational = 0.5 * m.bulk * (J * J + 1.0);
    if constexpr (P == Plane::Stress)
    {
      const double inPlane = be[0] + be[1];
      const double isochoric = 0.5 * m.mu * (4.0 * inPlane + 16.0 * be[3]) / 9.0;
      const double volumetric = m.bulk * J * J;
      const double theta = relaxation(isochoric, volumetric);
      const double gamma =
          0.5 * m.mu * (10.0 * (inPlane + be[3]) - 2.0 * theta * (4.0 * inPlane - 8.0 * be[3])) / 9.0 +
          theta * theta * isochoric + dilatational - 2.0 * theta * volumetric + theta * theta * volumetric;
      return speedOf(planeBound(m.mu, 4.0 / 3.0 * m.mu * (1.0 - theta), gamma, range), m.density);
    }
    else
      return speedOf(0.5 * m.mu * firstInvariantBound(trace<D>(be), range) + dilatational, m.density);
  }

private:
  /// Splits be = J^(-2/3) F Cp^-1 F^T. \param deviator out: dev be. \return tr be / 3 - 1
  template <int D>
  KOKKOS_INLINE_FUNCTION static double elasticStrain(const double* F, double J, const double* history,
                                                     double* deviator)
  {
    double g[symmetricSize<D>];
    leftStrain<D>(F, g);
    pushForward<D>(F, history, deviator);
    const double root = std::cbrt(J);
    const double scale = 1.0 / (root * root);
    for (int i = 0; i < symmetricSize<D>; ++i)
      deviator[i] = scale * (deviator[i] + g[i]);
    const double mean = trace<D>(deviator) / 3.0;
    for (int i = 0; i < 3; ++i)
      deviator[normalIndex<D>(i)] -= mean;
    return mean + scale - 1.0;
  }

  /// Moves the history along a return that shrinks the trial deviator of be by `shrink`.
  template <int D>
  KOKKOS_INLINE_FUNCTION static void storeFlow(const Properties& m, const double* F, double J,
                                               const double* deviator, double excess, double shrink,
                                               const Return& flow, double* history)
  {
    const double half = 0.5 * shrink * shrink * squaredNorm<D>(deviator);
    const double cube = shrink * shrink * shrink * symmetricDeterminant<D>(deviator);
    const double relaxed = unimodularExcess(half, cube, excess);

    // Cp^-1 = J^(2/3) F^-1 be F^-T, by the change of be so that it keeps its digits.
    double change[symmetricSize<D>];
    const double root = std::cbrt(J);
    for (int i = 0; i < symmetricSize<D>; ++i)
      change[i] = -root * root * (1.0 - shrink) * deviator[i];
    for (int i = 0; i < 3; ++i)
      change[normalIndex<D>(i)] += root * root * (relaxed - excess);
    double back[gradientSize<D>];
    inverse<D>(F, J, back);
    double plastic[symmetricSize<D>];
    pushForward<D>(back, change, plastic);
    for (int i = 0; i < symmetricSize<D>; ++i)
      history[i] += plastic[i];

    double& alpha = history[plasticStrainIndex<D>];
    const double before = yieldStress(m, alpha);
    alpha += flow.plasticStrain;
    const double work = 0.5 * (before + yieldStress(m, alpha)) * flow.plasticStrain;
    history[dissipationIndex<D>] += work * workFactor(half, cube, 1.0 + relaxed);
  }

  /// tau_zz after the return as a function of the thickness stretch s. The return only shrinks the deviator,
  /// so that the zero is between the s of no volume change and the s of no trial deviator in zz.
  struct ThicknessStress
  {
    const Properties& m;
    double area;   ///< of the plane, j
    double xx, yy; ///< of F Cp^-1 F^T, less 1
    double xy;
    double zz;    ///< of Cp^-1, less 1
    double alpha; ///< equivalent plastic strain

    KOKKOS_INLINE_FUNCTION double operator()(double s, double& slope) const
    {
      const double J = area * s;
      const double root = std::cbrt(J);
      const double mu = m.mu / (root * root);
      const double thickness = (s - 1.0) * (s + 1.0) + s * s * zz;
      const double mean = (xx + yy + thickness) / 3.0;
      const double sx = mu * (xx - mean), sy = mu * (yy - mean), sz = mu * (thickness - mean), sxy = mu * xy;
      const double pull = 2.0 * mu * (1.0 + thickness); // d dev tau / d ln s = pull dev(zz) - 2/3 dev tau
      double value = sz;
      double rise = 2.0 / 3.0 * (pull - sz);

      const double trial = std::sqrt(sx * sx + sy * sy + sz * sz + 2.0 * sxy * sxy);
      if (trial > yieldNorm(m, alpha))
      {
        const double shear = mu * (1.0 + mean);
        const Return flow = radialReturn(m, trial, shear, alpha);
        const double trialRise = pull * sz / trial - 2.0 / 3.0 * trial;
        const double shearRise = (pull - 2.0 * shear) / 3.0;
        const double normRise = flow.slope * (trialRise - 2.0 * shearRise * flow.multiplier);
        value = sz * flow.norm / trial;
        rise = (rise * flow.norm + sz * normRise - value * trialRise) / trial;
      }
      slope = rise + m.bulk * J * J;
      return value + 0.5 * m.bulk * (J - 1.0) * (J + 1.0);
    }
  };

  KOKKOS_INLINE_FUNCTION static double thicknessStretch(const Properties& m, const double* F,
                                                        const double* history)
  {
    double g[4];
    leftStrain<2>(F, g);
    double plastic[4];
    pushForward<2>(F, history, plastic);
    const ThicknessStress residual{
        m,          planeDeterminant(F),           g[0] + plastic[0], g[1] + plastic[1], g[2] + plastic[2],
        history[3], history[plasticStrainIndex<2>]};
    const double isochoric = 1.0 / residual.area;
    const double even = std::sqrt((1.0 + 0.5 * (residual.xx + residual.yy)) / (1.0 + residual.zz));
    return thicknessRoot(residual, std::fmin(isochoric, even), std::fmax(isochoric, even), F[4]);
  }
};

} // namespace Rhegma
