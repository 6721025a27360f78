#pragma once
/// Polymers: generalised Maxwell solid at finite strain.

#include "material/MaxwellElements.hpp"
#include "material/ViscoelasticParameters.hpp"

namespace Rhegma
{

/// A spring in parallel with up to five Maxwell elements, at finite strain. With Cb = J^(-2/3) F^T F,
/// Eb = (Cb - 1)/2 and b = Cb pushed forward,
///
///     W = K/2 ((J^2 - 1)/2 - ln J) + mu/2 (tr Cb - 3) + sum G_i e_i:e_i + sum K_i/2 v_i^2,
///     de_i/dt + e_i/t_i = dEb/dt,    dv_i/dt + v_i/t_i = d(ln J)/dt,
///     tau = (K/2 (J^2 - 1) + sum K_i v_i) 1 + dev(J^(-2/3) F S F^T),    S = mu 1 + sum 2 G_i e_i,
///
/// mu and K after relaxation, e_i and v_i the strain of the springs of the elements. The elements dissipate
/// 2 G_i e_i:e_i / t_i + K_i v_i^2 / t_i, never negative. This is the theory of Simo (Comput. Methods Appl.
/// Mech. Eng. 60 (1987) 153; Simo and Hughes, Computational Inelasticity, section 10.3) with elements whose
/// energy is quadratic in Eb, so that stored and dissipated energy are known (Holzapfel and Simo, Int. J.
/// Solids Struct. 33 (1996) 3019). The update is exact where the rates of Eb and ln J are constant over a
/// step; so is the dissipation.
///
/// The history holds e_i, v_i, the dissipated energy and the speed of waves.
struct Viscoelastic : LawDefaults
{
  static constexpr const char* name = "Viscoelastic";
  static constexpr const char* meaning =
      "Polymer: shear and bulk moduli that relax by a Prony series, for large strain.";

  static constexpr bool usesStep = true;
  static constexpr bool prepares = true;
  template <int D>
  static constexpr int volumeIndex = maxwellElements* symmetricSize<D>;
  template <int D>
  static constexpr int dissipationIndex = volumeIndex<D> + maxwellElements;
  template <int D>
  static constexpr int speedIndex = dissipationIndex<D> + 1;
  template <int D>
  static constexpr int historySize = dissipationIndex<D> + 2;
  template <int D>
  KOKKOS_INLINE_FUNCTION static constexpr Mean meanOf(int variable)
  {
    return variable == speedIndex<D> ? Mean::Largest : Mean::Volume;
  }

  template <class Section>
  static void describe(Section& s)
  {
    describeViscoelasticity(s);
  }
  template <class Reader>
  static void read(const Reader& reader, Properties& m)
  {
    readViscoelasticity(reader, m);
  }

  /// The elements over one step.
  struct Ready : MaxwellSteps<maxwellElements>
  {
    KOKKOS_INLINE_FUNCTION Ready(const Properties& m, double dt, double temperature)
        : MaxwellSteps(m.own[PronyNumber::count], m.own + PronyNumber::time, m.own + PronyNumber::shift, dt,
                       temperature)
    {
    }
  };

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static bool stress(const Ready& elements, const LawStep& step, const Properties& m,
                                            double* F, double* tau, double* history)
  {
    using namespace PronyNumber;
    if constexpr (P == Plane::Stress)
      if (!(planeDeterminant(F) > 0.0))
        return noStress<D>(tau);
    IsochoricStrain<D> start, now;
    if constexpr (P == Plane::Stress)
    {
      if (!start.set(step.before))
        return noStress<D>(tau);
      F[4] = thicknessStretch(m, elements, start, F, history);
    }
    if (!now.set(F))
      return noStress<D>(tau);
    if constexpr (P != Plane::Stress)
      if (!start.setNear(step.before, now))
        return noStress<D>(tau);

    double change[symmetricSize<D>], S[symmetricSize<D>] = {};
    for (int k = 0; k < symmetricSize<D>; ++k)
      change[k] = now.E[k] - start.E[k];
    double lost = relaxShape<D>(m, elements, change, history, S);
    double spherical = 0.5 * m.own[longBulk] * (now.J - 1.0) * (now.J + 1.0), relaxing = 0.0;
    if (m.own[volumetric] > 0.0)
      relaxing = relaxVolume(m, elements, std::log(now.J / start.J), history + volumeIndex<D>, lost);
    spherical += relaxing;
    history[dissipationIndex<D>] += lost;

    double b[symmetricSize<D>]; // J^(-2/3) F F^T, first less J^(-2/3)
    leftStrain<D>(F, b);
    pushForward<D>(F, S, tau);
    for (int k = 0; k < symmetricSize<D>; ++k)
    {
      b[k] *= now.scale;
      tau[k] *= now.scale;
    }
    const double stiffer = stiffening<D, P>(tau) + larger(-relaxing, 0.0);
    for (int k = 0; k < symmetricSize<D>; ++k)
      tau[k] += m.own[longShear] * b[k];
    for (int i = 0; i < 3; ++i)
      b[normalIndex<D>(i)] += now.scale;
    history[speedIndex<D>] = speedOf(waveModulus<D, P>(m, now.J, b) + stiffer, m.density);
    // In plane stress the pressure is the one that cancels tau_zz.
    const double shift = P == Plane::Stress ? -tau[normalIndex<D>(2)] : spherical - trace<D>(tau) / 3.0;
    for (int i = 0; i < 3; ++i)
      tau[normalIndex<D>(i)] += shift;
    return true;
  }

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double energy(const Properties& m, const double* F, const double* history)
  {
    using namespace PronyNumber;
    double g[symmetricSize<D>];
    leftStrain<D>(F, g);
    const double twiceLogJ = logVolumeSquared<D>(g);
    const double scale = std::expm1(-twiceLogJ / 3.0); // J^(-2/3) - 1
    double sum = 0.25 * m.own[longBulk] * (std::expm1(twiceLogJ) - twiceLogJ) +
                 0.5 * m.own[longShear] * ((1.0 + scale) * trace<D>(g) + 3.0 * scale);
    const double* const volume = history + volumeIndex<D>;
    for (int i = 0; i < maxwellElements; ++i)
      sum += m.own[shear + i] * squaredNorm<D>(history + i * symmetricSize<D>) +
             0.5 * m.own[bulk + i] * volume[i] * volume[i];
    return sum;
  }

  /// That of the last stress; of the moduli before relaxation.
  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double waveSpeed(const Properties& m, const double* /*F*/,
                                                 const double* history)
  {
    const double speed = history[speedIndex<D>];
    return speed > 0.0 ? speed : speedOf(m.planeLambda + 2.0 * m.mu, m.density);
  }

private:
  /// Bound of rho c^2 without the stress of the elements [Pa], which `stiffening` adds.
  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double waveModulus(const Properties& m, double J, const double* b)
  {
    using namespace PronyNumber;
    const EigenvalueRange range = directionalRange<D>(b);
    const double largest = larger(range.largest, b[normalIndex<D>(2)]);
    const double fast = m.mu - m.own[longShear], fastBulk = m.bulk - m.own[longBulk];
    const double dilatational = 0.5 * m.own[longBulk] * (J * J + 1.0);
    if constexpr (P == Plane::Stress)
    {
      const double theta = m.thicknessRatio, rest = 1.0 - theta;
      return isochoricPlaneModulus(m.own[longShear], b, range, theta, m.own[longBulk] * J * J, dilatational) +
             rest * rest * fastBulk + elementsModulus<P>(fast, largest, theta);
    }
    else
      return 0.5 * m.own[longShear] * firstInvariantBound(trace<D>(b), range) +
             elementsModulus<P>(fast, largest, 0.0) + dilatational + fastBulk;
  }

  /// Strains the elements of the shape. \param S gains sum 2 G_i e_i \return what they dissipate [J/m3]
  template <int D>
  KOKKOS_INLINE_FUNCTION static double relaxShape(const Properties& m, const Ready& elements,
                                                  const double* change, double* history, double* S)
  {
    using namespace PronyNumber;
    const double square = squaredNorm<D>(change);
    double lost = 0.0;
    for (int i = 0; i < elements.count; ++i)
    {
      double* const e = history + i * symmetricSize<D>;
      const MaxwellStep& at = elements.step[i];
      const double twice = 2.0 * m.own[shear + i], keep = 1.0 - at.loss;
      lost += m.own[shear + i] * at.dissipated(squaredNorm<D>(e), contraction<D>(e, change), square);
      for (int k = 0; k < symmetricSize<D>; ++k)
      {
        e[k] = keep * e[k] + at.gain * change[k];
        S[k] += twice * e[k];
      }
    }
    return lost;
  }

  /// Strains the elements of the volume. \param lost gains what they dissipate \return sum K_i v_i
  KOKKOS_INLINE_FUNCTION static double relaxVolume(const Properties& m, const Ready& elements, double change,
                                                   double* v, double& lost)
  {
    using namespace PronyNumber;
    double sum = 0.0;
    for (int i = 0; i < elements.count; ++i)
    {
      const MaxwellStep& at = elements.step[i];
      lost += 0.5 * m.own[bulk + i] * at.dissipated(v[i] * v[i], v[i] * change, change * change);
      v[i] = (1.0 - at.loss) * v[i] + at.gain * change;
      sum += m.own[bulk + i] * v[i];
    }
    return sum;
  }

  /// Thickness stretch of plane stress: tau_zz rises from minus to plus infinity.
  KOKKOS_INLINE_FUNCTION static double thicknessStretch(const Properties& m, const Ready& elements,
                                                        const IsochoricStrain<2>& start, const double* F,
                                                        const double* history)
  {
    using namespace PronyNumber;
    constexpr double widest = 1.0e3;
    ThicknessStress at{F[0] * F[0] + F[2] * F[2],
                       F[1] * F[1] + F[3] * F[3],
                       F[0] * F[1] + F[2] * F[3],
                       planeDeterminant(F),
                       {m.own[longShear], m.own[longShear], 0.0, m.own[longShear]},
                       0.0,
                       m.own[longBulk],
                       0.0,
                       0.0};
    const double* const v = history + volumeIndex<2>;
    for (int i = 0; i < elements.count; ++i)
    {
      const double* const e = history + i * symmetricSize<2>;
      const double twice = 2.0 * m.own[shear + i], keep = 1.0 - elements.step[i].loss,
                   gain = elements.step[i].gain;
      for (int k = 0; k < 4; ++k)
        at.R[k] += twice * (keep * e[k] - gain * start.E[k]);
      at.G += m.own[shear + i] * gain;
      at.base += m.own[bulk + i] * (keep * v[i] - gain * std::log(start.J));
      at.K += m.own[bulk + i] * gain;
    }
    return thicknessRoot(at, 1.0 / widest, widest, F[4]);
  }
};

} // namespace Rhegma
