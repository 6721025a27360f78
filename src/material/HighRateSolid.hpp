#pragma once
/// Metals at high rates and in shocks.

#include "material/AcousticBound.hpp"
#include "material/ArtificialViscosity.hpp"
#include "material/HighRateParameters.hpp"
#include "material/JohnsonCook.hpp"
#include "material/MieGrueneisen.hpp"
#include "material/PlasticSplit.hpp"

namespace Rhegma
{

/// A solid of parts, which the parameters of a scene choose:
///
///     volume     K/2 ((J^2 - 1)/2 - ln J), or Mie-Grueneisen (MieGrueneisen.hpp)
///     shape      mu/2 (tr be - 3), be = J^(-2/3) F Cp^-1 F^T
///     flow       none, or Johnson-Cook, with Voce hardening or without (JohnsonCook.hpp)
///     viscosity  none, or artificial bulk viscosity (ArtificialViscosity.hpp)
///
/// Flow is that of J2Plastic (Simo and Hughes, boxes 9.1 and 9.2), implicit in the plastic rate and explicit
/// in temperature. In scenes without heat the material is adiabatic: a fraction of plastic work and all work
/// of viscosity warm it. The parts are chosen in the kernel, not by its type, so that one kernel serves all.
///
/// The history holds Cp^-1 - 1, the equivalent plastic strain alpha, the dissipated energy, the temperature
/// rise, the internal energy E of the volume, the heat Q in it (both zero without Mie-Grueneisen), the
/// viscous part of -tr tau / 3, the logarithm of the last plastic rate over the reference rate, and the speed
/// of waves. Stored is E - Q and the energy of shape.
struct HighRateSolid : LawDefaults
{
  static constexpr const char* name = "High-Rate Solid";
  static constexpr const char* meaning = "Metal at high strain rates and in shocks: Johnson-Cook flow, "
                                         "Mie-Grueneisen pressure, both or neither.";

  static constexpr bool usesStep = true;
  static constexpr bool warms = true;
  template <int D>
  static constexpr int plasticStrainIndex = symmetricSize<D>;
  template <int D>
  static constexpr int dissipationIndex = symmetricSize<D> + 1;
  template <int D>
  static constexpr int warmingIndex = symmetricSize<D> + 2;
  template <int D>
  static constexpr int energyIndex = symmetricSize<D> + 3;
  template <int D>
  static constexpr int heatIndex = symmetricSize<D> + 4;
  template <int D>
  static constexpr int viscousIndex = symmetricSize<D> + 5;
  template <int D>
  static constexpr int rateIndex = symmetricSize<D> + 6;
  template <int D>
  static constexpr int speedIndex = symmetricSize<D> + 7;
  template <int D>
  static constexpr int historySize = symmetricSize<D> + 8;
  template <int D>
  KOKKOS_INLINE_FUNCTION static constexpr Mean meanOf(int variable)
  {
    return variable == speedIndex<D> ? Mean::Largest : Mean::Volume;
  }

  static double firstYield(const Properties& m) { return m.own[HighRateNumber::yield]; }
  static const char* refusesHeat(const Properties& m)
  {
    return isShocked(m)
               ? "the law with Mie-Grueneisen has its own internal energy and temperature; remove the "
                 "section Thermal, or write Equation Of State = Elastic"
               : nullptr;
  }
  template <class Section>
  static void describe(Section& s)
  {
    describeHighRate(s);
  }
  template <class Reader>
  static void read(const Reader& reader, Properties& m)
  {
    readHighRate(reader, m);
  }

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static bool stress(const LawStep& step, const Properties& m, double* F, double* tau,
                                            double* history)
  {
    const bool shocked = isShocked(m);
    double& alpha = history[plasticStrainIndex<D>];
    double warmth = m.heated ? step.temperature : step.temperature + history[warmingIndex<D>];
    if constexpr (P == Plane::Stress)
    {
      if (!(planeDeterminant(F) > 0.0))
        return noStress<D>(tau);
      F[4] = thicknessStretch(JohnsonCook(m, alpha, warmth, step.dt), m, F, history);
    }
    const double J = determinant<D>(F), volumeBefore = shocked ? determinant<D>(step.before) : 1.0;
    if (!(J > 0.0) || !(volumeBefore > 0.0) || (shocked && !MieGrueneisen(m).allows(J)))
      return noStress<D>(tau);
    if (shocked)
    {
      double factor = 1.0;
      double& energy = history[energyIndex<D>];
      energy = MieGrueneisen(m).compress(energy, 1.0 - volumeBefore, 1.0 - J, factor);
      history[warmingIndex<D>] += warmth * (factor - 1.0);
      warmth *= factor;
    }

    double strain[symmetricSize<D>]; // deviator of be
    const double scale = isochoricScale(J);
    double excess = elasticStrain<D>(F, scale, history, strain);
    const double trial = m.mu * std::sqrt(squaredNorm<D>(strain));
    JohnsonCook metal(m, alpha, warmth, step.dt);
    double heat = 0.0;
    if (metal.flows(trial))
    {
      const JohnsonCook::Flow flow = metal.solve(trial, m.mu * (1.0 + excess), history[rateIndex<D>]);
      const double shrink = flow.back.norm / trial;
      const double work = flow.work * flowBack<D>(F, J, scale, strain, shrink, excess, history);
      alpha += flow.back.plasticStrain;
      history[dissipationIndex<D>] += work;
      heat = m.own[HighRateNumber::heatFraction] * work;
      for (int i = 0; i < symmetricSize<D>; ++i)
        strain[i] *= shrink;
    }
    for (int i = 0; i < symmetricSize<D>; ++i)
      tau[i] = m.mu * strain[i];

    double shift = 0.5 * m.bulk * (J - 1.0) * (J + 1.0), modulus = 0.5 * m.bulk * (J * J + 1.0);
    double viscous = 0.0;
    if constexpr (P == Plane::Stress)
      shift = -tau[normalIndex<D>(2)];
    else if (shocked)
    {
      const MieGrueneisen volume(m);
      volume.pressure(J, history[energyIndex<D>] + heat, modulus);
      viscous = artificial(m).pressure(step.dt, J, volumeBefore, speedOf(modulus, m.density),
                                       history[viscousIndex<D>], history[dissipationIndex<D>], heat);
      shift = -J * volume.pressure(J, history[energyIndex<D>] + heat, modulus) - viscous;
    }
    for (int i = 0; i < 3; ++i)
      tau[normalIndex<D>(i)] += shift;
    warm<D>(m, shocked, heat, history);
    for (int i = 0; i < 3; ++i)
      strain[normalIndex<D>(i)] += 1.0 + excess;
    history[speedIndex<D>] = speed<D, P>(m, J, strain, modulus, viscous);
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
    const double shape = 0.5 * m.mu * ((1.0 + scale) * traceBe + 3.0 * scale);
    return shape + (isShocked(m) ? history[energyIndex<D>] - history[heatIndex<D>]
                                 : 0.25 * m.bulk * (std::expm1(twiceLogJ) - twiceLogJ));
  }

  /// That of the last stress.
  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double waveSpeed(const Properties& m, const double* /*F*/,
                                                 const double* history)
  {
    const double speed = history[speedIndex<D>];
    return speed > 0.0 ? speed : speedOf(m.planeLambda + 2.0 * m.mu, m.density);
  }

private:
  KOKKOS_INLINE_FUNCTION static bool isShocked(const Properties& m)
  {
    return m.own[HighRateNumber::hugoniotSlope] > 0.0;
  }

  /// Bound of the speed of waves of the elastic response, with artificial viscosity on top: the stable step
  /// of a viscous wave is that of the speed V + sqrt(V^2 + c^2), V = C1 c + C2 l |d|, which follows from q.
  /// \param be left elastic tensor \param modulus of the volume [Pa] \param q viscous pressure [Pa]
  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double speed(const Properties& m, double J, const double* be, double modulus,
                                             double q)
  {
    const EigenvalueRange range = directionalRange<D>(be);
    if constexpr (P == Plane::Stress)
    {
      const double volumetric = m.bulk * J * J, theta = relaxation(thicknessModulus(m.mu, be), volumetric);
      return speedOf(isochoricPlaneModulus(m.mu, be, range, theta, volumetric, modulus), m.density);
    }
    const double elastic =
        speedOf(0.5 * m.mu * firstInvariantBound(trace<D>(be), range) + modulus, m.density);
    if (!(q > 0.0))
      return elastic;
    const double viscous = artificial(m).speed(speedOf(modulus, m.density), q);
    return viscous + std::sqrt(viscous * viscous + elastic * elastic);
  }

  KOKKOS_INLINE_FUNCTION static ArtificialViscosity artificial(const Properties& m)
  {
    return {m.own[HighRateNumber::linearViscosity], m.own[HighRateNumber::quadraticViscosity], m.density,
            m.cellSize};
  }

  template <int D>
  KOKKOS_INLINE_FUNCTION static void warm(const Properties& m, bool shocked, double heat, double* history)
  {
    if (shocked)
    {
      history[energyIndex<D>] += heat;
      history[heatIndex<D>] += heat;
    }
    if (!m.heated && m.own[HighRateNumber::heatCapacity] > 0.0)
      history[warmingIndex<D>] += heat / m.own[HighRateNumber::heatCapacity];
  }

  /// Yield condition and return, for the thickness stretch.
  struct ThicknessFlow
  {
    const JohnsonCook& metal;
    double logRate;

    KOKKOS_INLINE_FUNCTION double norm() const
    {
      constexpr double never = 1.0e300;
      return metal.canFlow() ? metal.norm() : never;
    }
    KOKKOS_INLINE_FUNCTION Return solve(double trial, double shear) const
    {
      double rate = logRate;
      return metal.solve(trial, shear, rate).back;
    }
  };

  KOKKOS_INLINE_FUNCTION static double thicknessStretch(JohnsonCook metal, const Properties& m,
                                                        const double* F, const double* history)
  {
    metal.harden();
    return plasticThickness(ThicknessFlow{metal, history[rateIndex<2>]}, m, F, history);
  }
};

} // namespace Rhegma
