#pragma once
/// Metals at high rates and in shocks.

#include "material/AcousticBound.hpp"
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
///     viscosity  none, or artificial bulk viscosity q = rho l |d| (C1 c + C2 l |d|) in compression, with d
///     the
///                rate of volume, l the cell size and c the speed of sound (von Neumann and Richtmyer 1950)
///
/// Flow is that of J2Plastic (Simo and Hughes, boxes 9.1 and 9.2), implicit in the plastic rate and explicit
/// in temperature. In scenes without heat the material is adiabatic: a fraction of plastic work and all work
/// of viscosity warm it. The parts are chosen in the kernel, not by its type, so that one kernel serves all.
///
/// The history holds Cp^-1 - 1, the equivalent plastic strain alpha, the dissipated energy, the temperature
/// rise, the internal energy E of the volume, the heat Q in it (both zero without Mie-Grueneisen), and the
/// viscous part of -tr tau / 3. Stored is E - Q and the energy of shape.
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
  static constexpr int historySize = symmetricSize<D> + 6;

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
    double warmth = m.heated ? step.temperature : step.temperature + history[warmingIndex<D>];
    if constexpr (P == Plane::Stress)
    {
      if (!(planeDeterminant(F) > 0.0))
        return noStress<D>(tau);
      F[4] = thicknessStretch(m, JohnsonCook(m, warmth, step.dt), F, history);
    }
    const double J = determinant<D>(F), volumeBefore = determinant<D>(step.before);
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
    const double excess = elasticStrain<D>(F, J, history, strain);
    const double trial = m.mu * std::sqrt(squaredNorm<D>(strain));
    double& alpha = history[plasticStrainIndex<D>];
    const JohnsonCook flow(m, warmth, step.dt);
    double heat = 0.0;
    if (flow.flows(trial, alpha))
    {
      const Return back = flow.solve(trial, m.mu * (1.0 + excess), alpha);
      const double shrink = back.norm / trial;
      const double work =
          flow.work(alpha, back.plasticStrain) * flowBack<D>(F, J, strain, excess, shrink, history);
      alpha += back.plasticStrain;
      history[dissipationIndex<D>] += work;
      heat = m.own[HighRateNumber::heatFraction] * work;
      for (int i = 0; i < symmetricSize<D>; ++i)
        strain[i] *= shrink;
    }
    const double viscous = shocked ? viscousPressure<D>(step, m, J, volumeBefore, history, heat) : 0.0;
    store<D>(m, shocked, heat, history);
    for (int i = 0; i < symmetricSize<D>; ++i)
      tau[i] = m.mu * strain[i];
    double shift = 0.5 * m.bulk * (J - 1.0) * (J + 1.0);
    if constexpr (P == Plane::Stress)
      shift = -tau[normalIndex<D>(2)];
    else if (shocked)
    {
      const MieGrueneisen volume(m);
      shift = -J * (volume.cold(1.0 - J) + volume.gamma * history[energyIndex<D>]) - viscous;
    }
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
    const double shape = 0.5 * m.mu * ((1.0 + scale) * traceBe + 3.0 * scale);
    return shape + (isShocked(m) ? history[energyIndex<D>] - history[heatIndex<D>]
                                 : 0.25 * m.bulk * (std::expm1(twiceLogJ) - twiceLogJ));
  }

  /// Of the elastic response, with artificial viscosity on top: the stable step of a viscous wave is that of
  /// the speed Q + sqrt(Q^2 + c^2), Q = C1 c + C2 l |d|, which follows from q.
  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double waveSpeed(const Properties& m, const double* F, const double* history)
  {
    const double J = determinant<D>(F);
    double be[symmetricSize<D>];
    const double excess = elasticStrain<D>(F, J, history, be);
    for (int i = 0; i < 3; ++i)
      be[normalIndex<D>(i)] += 1.0 + excess;
    const EigenvalueRange range = directionalRange<D>(be);
    if constexpr (P == Plane::Stress)
    {
      const double volumetric = m.bulk * J * J, theta = relaxation(thicknessModulus(m.mu, be), volumetric);
      return speedOf(isochoricPlaneModulus(m.mu, be, range, theta, volumetric, 0.5 * m.bulk * (J * J + 1.0)),
                     m.density);
    }
    else
    {
      const bool shocked = isShocked(m);
      const double volume =
          shocked ? MieGrueneisen(m).modulus(J, history[energyIndex<D>]) : 0.5 * m.bulk * (J * J + 1.0);
      const double elastic =
          speedOf(0.5 * m.mu * firstInvariantBound(trace<D>(be), range) + volume, m.density);
      const double q = history[viscousIndex<D>];
      if (!(q > 0.0))
        return elastic;
      using namespace HighRateNumber;
      const double linear = m.own[linearViscosity] * speedOf(volume, m.density);
      const double viscous =
          0.5 * (linear + std::sqrt(linear * linear + 4.0 * m.own[quadraticViscosity] * q / m.density));
      return viscous + std::sqrt(viscous * viscous + elastic * elastic);
    }
  }

private:
  KOKKOS_INLINE_FUNCTION static bool isShocked(const Properties& m)
  {
    return m.own[HighRateNumber::hugoniotSlope] > 0.0;
  }

  /// Part of -tr tau / 3 by artificial viscosity [Pa]. The forces on nodes do its work by the trapezoidal
  /// rule, which is what is dissipated; the heat is by the new value, so that it is never negative. Over a
  /// shock both are the same. \param heat gains the heat [J/m3]
  template <int D>
  KOKKOS_INLINE_FUNCTION static double viscousPressure(const LawStep& step, const Properties& m, double J,
                                                       double before, double* history, double& heat)
  {
    using namespace HighRateNumber;
    double& q = history[viscousIndex<D>];
    const double strain = std::log(before / J); // positive in compression
    if (!(step.dt > 0.0))
      return q;
    double now = 0.0;
    if (strain > 0.0)
    {
      const double speed = speedOf(MieGrueneisen(m).modulus(J, history[energyIndex<D>]), m.density);
      const double closing = m.cellSize * strain / step.dt;
      now = m.density * closing * (m.own[linearViscosity] * speed + m.own[quadraticViscosity] * closing);
    }
    history[dissipationIndex<D>] += 0.5 * (q + now) * strain;
    heat += now * strain;
    q = now;
    return now;
  }

  /// Warms the material.
  template <int D>
  KOKKOS_INLINE_FUNCTION static void store(const Properties& m, bool shocked, double heat, double* history)
  {
    if (shocked)
    {
      history[energyIndex<D>] += heat;
      history[heatIndex<D>] += heat;
    }
    if (!m.heated && m.own[HighRateNumber::heatCapacity] > 0.0)
      history[warmingIndex<D>] += heat / m.own[HighRateNumber::heatCapacity];
  }

  KOKKOS_INLINE_FUNCTION static double thicknessStretch(const Properties& m, const JohnsonCook& flow,
                                                        const double* F, const double* history)
  {
    return plasticThickness(ThicknessFlow{flow}, m, F, history, history[plasticStrainIndex<2>]);
  }

  /// Yield condition and return, for the thickness stretch.
  struct ThicknessFlow
  {
    const JohnsonCook& flow;
    KOKKOS_INLINE_FUNCTION double norm(double alpha) const
    {
      return flow.flows(1.0e300, alpha) ? flow.norm(alpha) : 1.0e300;
    }
    KOKKOS_INLINE_FUNCTION Return solve(double trial, double shear, double alpha) const
    {
      return flow.solve(trial, shear, alpha);
    }
  };
};

} // namespace Rhegma
