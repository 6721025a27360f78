#pragma once
/// Plastic-bonded explosives: generalised Maxwell solid that many small cracks soften.

#include "material/ViscoScramParameters.hpp"
#include "material/ViscoScramStep.hpp"

namespace Rhegma
{

/// ViscoSCRAM at finite strain: a generalised Maxwell solid in series with the shear of small cracks of the
/// mean radius c. With Cb = J^(-2/3) F^T F, Eb = (Cb - 1)/2, G the shear modulus at once and G_i, t_i those
/// of the elements, mu the modulus after relaxation,
///
///     Eb = E + (c/a)^3 S / (2 G),    S = 2 mu E + sum 2 G_i e_i,    de_i/dt + e_i/t_i = dE/dt,
///     tau = K/2 (J^2 - 1) 1 + dev(J^(-2/3) F S F^T),    dc/dt by CrackGrowth from the true stress,
///     W = K/2 ((J^2 - 1)/2 - ln J) + mu E:E + sum G_i e_i:e_i + (c/a)^3 S:S / (4 G).
///
/// The elements dissipate 2 G_i e_i:e_i / t_i, growth of cracks d(c/a)^3/dt S:S / (4 G); neither is negative.
/// At small strain these are the equations of Bennett, Haberman, Johnson, Asay, Henson (J. Mech. Phys. Solids
/// 46 (1998) 2303) and Hackett, Bennett (Int. J. Numer. Methods Eng. 49 (2000) 1191). Tensors of the
/// undeformed body stand for their objective rates. They count all work on the strain of the cracks as heat;
/// here its elastic part is stored, and returns when the load goes.
///
/// The history holds e_i, c less its value at the start, the dissipated energy and the speed of waves.
struct ViscoScram : LawDefaults
{
  static constexpr const char* name = "ViscoSCRAM";
  static constexpr const char* meaning =
      "Plastic-bonded explosive: shear modulus that relaxes by a Prony series, and damage by many small "
      "cracks that grow.";

  static constexpr bool usesStep = true;
  static constexpr bool prepares = true;
  static constexpr bool damages = true;
  template <int D>
  static constexpr int growthIndex = maxwellElements* symmetricSize<D>;
  template <int D>
  static constexpr int dissipationIndex = growthIndex<D> + 1;
  template <int D>
  static constexpr int speedIndex = growthIndex<D> + 2;
  template <int D>
  static constexpr int historySize = growthIndex<D> + 3;
  /// The radius is a mean of many cracks, so that of a merged particle is the mean by volume.
  template <int D>
  KOKKOS_INLINE_FUNCTION static constexpr Mean meanOf(int variable)
  {
    return variable == speedIndex<D> ? Mean::Largest : Mean::Volume;
  }

  template <class Section>
  static void describe(Section& s)
  {
    describeScram(s);
  }
  template <class Reader>
  static void read(const Reader& reader, Properties& m)
  {
    readScram(reader, m);
  }

  using Ready = ScramElements;

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static bool stress(const Ready& elements, const LawStep& step, const Properties& m,
                                            double* F, double* tau, double* history)
  {
    if constexpr (P == Plane::Stress)
      if (!(planeDeterminant(F) > 0.0))
        return noStress<D>(tau);
    IsochoricStrain<D> start, now;
    if (!start.set(step.before))
      return noStress<D>(tau);
    const double before = m.own[ScramNumber::radius] + history[growthIndex<D>];
    ScramStep<D> path(elements, m, start, history, before);
    double radius = before;
    if constexpr (P == Plane::Stress)
      radius = radiusInPlaneStress(path, step.dt, F, before);
    if (!now.set(F))
      return noStress<D>(tau);
    path.endAt(now);
    if constexpr (P != Plane::Stress)
      radius = path.radiusAfter(step.dt);

    double S[symmetricSize<D>];
    history[dissipationIndex<D>] += path.finish(radius, history, S);
    history[growthIndex<D>] = radius - m.own[ScramNumber::radius];
    finishStress<D, P>(m, now, F, S, tau, history[speedIndex<D>]);
    return true;
  }

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double energy(const Properties& m, const double* F, const double* history)
  {
    using namespace ScramNumber;
    double g[symmetricSize<D>], S[symmetricSize<D>], E[symmetricSize<D>];
    leftStrain<D>(F, g);
    const double twiceLogJ = logVolumeSquared<D>(g);
    IsochoricStrain<D> now;
    if (!now.set(F))
      return 0.0;
    const double compliance = crackCompliance(m, m.own[radius] + history[growthIndex<D>]);
    crackedStress<D>(m, now.E, history, compliance, S, E);
    double sum = 0.25 * m.bulk * (std::expm1(twiceLogJ) - twiceLogJ) + m.own[longShear] * squaredNorm<D>(E) +
                 0.5 * compliance * squaredNorm<D>(S);
    for (int i = 0; i < maxwellElements; ++i)
      sum += m.own[shear + i] * squaredNorm<D>(history + i * symmetricSize<D>);
    return sum;
  }

  /// That of the last stress; of the moduli before relaxation, without cracks.
  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double waveSpeed(const Properties& m, const double* /*F*/,
                                                 const double* history)
  {
    const double speed = history[speedIndex<D>];
    return speed > 0.0 ? speed : speedOf(m.planeLambda + 2.0 * m.mu, m.density);
  }

  /// c^3 / (a^3 + c^3), the part of the shear compliance that the cracks have [-].
  template <int D>
  KOKKOS_INLINE_FUNCTION static double damage(const Properties& m, const double* history)
  {
    using namespace ScramNumber;
    const double ratio = (m.own[radius] + history[growthIndex<D>]) / m.own[scale];
    const double cube = ratio * ratio * ratio;
    return cube / (1.0 + cube);
  }

private:
  /// Sets F[4]. The radius depends on the thickness and the reverse: the thickness is found for the radius of
  /// the start, then twice more for that which follows, after which the error is of third order in the step.
  template <int D>
  KOKKOS_INLINE_FUNCTION static double radiusInPlaneStress(ScramStep<D>& path, double dt, double* F,
                                                           double radius)
  {
    for (int pass = 0; pass < 3; ++pass)
    {
      F[4] = path.thicknessStretch(F, radius);
      IsochoricStrain<D> now;
      if (pass == 2 || !now.set(F))
        break;
      path.endAt(now);
      const double grown = path.radiusAfter(dt);
      constexpr double still = 1.0e-14; // relative
      const bool stands = std::fabs(grown - radius) <= still * radius;
      radius = grown;
      if (stands)
        break;
    }
    return radius;
  }

  /// \param speed becomes a bound of the speed of waves [m/s]
  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static void finishStress(const Properties& m, const IsochoricStrain<D>& now,
                                                  const double* F, const double* S, double* tau,
                                                  double& speed)
  {
    double b[symmetricSize<D>];
    leftStrain<D>(F, b);
    pushForward<D>(F, S, tau);
    for (int k = 0; k < symmetricSize<D>; ++k)
    {
      b[k] *= now.scale;
      tau[k] *= now.scale;
    }
    for (int i = 0; i < 3; ++i)
      b[normalIndex<D>(i)] += now.scale;
    speed = speedOf(waveModulus<D, P>(m, now.J, b) + stiffening<D, P>(tau), m.density);
    // In plane stress the pressure is the one that cancels tau_zz.
    const double spherical = 0.5 * m.bulk * (now.J - 1.0) * (now.J + 1.0);
    const double shift = P == Plane::Stress ? -tau[normalIndex<D>(2)] : spherical - trace<D>(tau) / 3.0;
    for (int i = 0; i < 3; ++i)
      tau[normalIndex<D>(i)] += shift;
  }

  /// Bound of rho c^2 without the stress of the elements [Pa]: cracks only make it less.
  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double waveModulus(const Properties& m, double J, const double* b)
  {
    const EigenvalueRange range = directionalRange<D>(b);
    const double largest = larger(range.largest, b[normalIndex<D>(2)]), theta = m.thicknessRatio;
    const double dilatational = 0.5 * m.bulk * (J * J + 1.0);
    const double elements = elementsModulus<P>(m.mu, largest, theta);
    return P == Plane::Stress ? dilatational + theta * (theta - 2.0) * m.bulk * J * J + elements
                              : dilatational + elements;
  }
};

} // namespace Rhegma
