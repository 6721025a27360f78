#pragma once
/// Polymers: generalised Maxwell solid at finite strain.

#include "material/AcousticBound.hpp"
#include "material/ThicknessRoot.hpp"
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
  struct Ready
  {
    int count;
    MaxwellStep step[maxwellElements];

    KOKKOS_INLINE_FUNCTION Ready(const Properties& m, double dt, double temperature)
        : count(static_cast<int>(std::lround(m.own[PronyNumber::count])))
    {
      using namespace PronyNumber;
      const double faster =
          inverseTimeShift(m.own[shift], m.own[first], m.own[second], m.own[reference], temperature);
      for (int i = 0; i < count; ++i)
        step[i] = maxwellStep(dt * faster / m.own[time + i]);
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
    Strain<D> start, now;
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
  /// Eb, J and J^(-2/3).
  template <int D>
  struct Strain
  {
    double J, scale;
    double E[symmetricSize<D>];

    /// \return false where F is inverted
    KOKKOS_INLINE_FUNCTION bool set(const double* F)
    {
      J = determinant<D>(F);
      if (!(J > 0.0))
        return false;
      const double root = std::cbrt(J);
      scale = 1.0 / (root * root);
      strain(F);
      return true;
    }

    /// The same of an F whose volume is near that of another one: without a cube root.
    KOKKOS_INLINE_FUNCTION bool setNear(const double* F, const Strain& other)
    {
      J = determinant<D>(F);
      if (!(J > 0.0))
        return false;
      const double change = other.J / J - 1.0;
      if (std::fabs(change) > seriesLimit)
        return set(F);
      scale = other.scale * twoThirdsPower(change);
      strain(F);
      return true;
    }

  private:
    static constexpr double seriesLimit = 0.02;

    /// (1 + x)^(2/3); the first term left out is 1e-14 at the limit.
    KOKKOS_INLINE_FUNCTION static double twoThirdsPower(double x)
    {
      return 1.0 + x * (2.0 / 3.0 -
                        x * (1.0 / 9.0 - x * (4.0 / 81.0 -
                                              x * (7.0 / 243.0 - x * (14.0 / 729.0 - x * (91.0 / 6561.0))))));
    }

    KOKKOS_INLINE_FUNCTION void strain(const double* F)
    {
      rightStrain<D>(F, E);
      for (int k = 0; k < symmetricSize<D>; ++k)
        E[k] *= 0.5 * scale;
      for (int i = 0; i < 3; ++i)
        E[normalIndex<D>(i)] += 0.5 * (scale - 1.0);
    }
  };

  /// Bound of rho c^2 without the stress of the elements [Pa]. The second derivative of their energy is at
  /// most 2 G |dEb|^2 <= 4/3 G b^2, with b the largest eigenvalue of J^(-2/3) F F^T, and what `stiffening`
  /// adds.
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
      // The thickness follows by theta times the dilatation of the plane, as at small strain.
      const double theta = m.thicknessRatio, rest = 1.0 - theta;
      const double elements =
          0.5 * fast * largest * largest * (4.0 + 4.0 * theta * theta - 4.0 / 3.0 * rest * rest);
      return isochoricPlaneModulus(m.own[longShear], b, range, theta, m.own[longBulk] * J * J, dilatational) +
             rest * rest * fastBulk + elements;
    }
    else
      return 0.5 * m.own[longShear] * firstInvariantBound(trace<D>(b), range) +
             4.0 / 3.0 * fast * largest * largest + dilatational + fastBulk;
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

  /// Bound of sum G_i e_i : d^2 Cb over all directions, from its spatial tensor q = J^(-2/3) F (sum 2 G_i
  /// e_i) F^T: n.q n - 4/3 p m.q n + 5/9 p^2 tr q; in plane stress it is at most 4 |q|.
  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double stiffening(const double* q)
  {
    const EigenvalueRange range = directionalRange<D>(q);
    double largest = larger(std::fabs(range.largest), std::fabs(range.smallest));
    if constexpr (P == Plane::Stress)
      return 4.0 * larger(largest, std::fabs(q[3]));
    return larger(range.largest, 0.0) + 4.0 / 3.0 * largest + 5.0 / 9.0 * std::fabs(trace<D>(q));
  }

  /// tau_zz as a function of the thickness stretch s, with S = R + G (Cb - 1).
  struct ThicknessStress
  {
    double xx, yy, xy; ///< of F^T F, in the plane
    double area;       ///< of the plane, j
    double R[4];       ///< S without the strain of this step
    double G;          ///< sum of G_i gain_i
    double bulk;       ///< after relaxation
    double base;       ///< sum of K_i v_i without the strain of this step, at J = 1
    double K;          ///< sum of K_i gain_i

    KOKKOS_INLINE_FUNCTION double operator()(double s, double& slope) const
    {
      const double J = area * s, root = std::cbrt(J), scale = 1.0 / (root * root);
      const double cx = scale * xx, cy = scale * yy, cxy = scale * xy, cz = scale * s * s;
      const double sx = R[0] + G * (cx - 1.0), sy = R[1] + G * (cy - 1.0), sxy = R[2] + G * cxy,
                   sz = R[3] + G * (cz - 1.0);
      // Derivatives by ln s.
      const double dx = -2.0 / 3.0 * cx, dy = -2.0 / 3.0 * cy, dxy = -2.0 / 3.0 * cxy, dz = 4.0 / 3.0 * cz;
      const double product = sx * cx + sy * cy + 2.0 * sxy * cxy + sz * cz;
      const double rise =
          (G * cx + sx) * dx + (G * cy + sy) * dy + 2.0 * (G * cxy + sxy) * dxy + (G * cz + sz) * dz;
      slope = (G * cz + sz) * dz - rise / 3.0 + bulk * J * J + K;
      return cz * sz - product / 3.0 + 0.5 * bulk * (J - 1.0) * (J + 1.0) + base + K * std::log(J);
    }
  };

  /// Thickness stretch of plane stress: tau_zz rises from minus to plus infinity.
  KOKKOS_INLINE_FUNCTION static double thicknessStretch(const Properties& m, const Ready& elements,
                                                        const Strain<2>& start, const double* F,
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
