#pragma once
/// A viscoelastic solid: the example of docs/how-to/add-a-material.md.

#include "material/AcousticBound.hpp"
#include "material/LawParameters.hpp"

namespace Rhegma
{

/// Zener's solid at finite rotations: an elastic branch in parallel with a spring and a dashpot in series,
/// which resists changes of shape only. With Green's strain E and the second Piola-Kirchhoff stress,
///
///     S = lambda tr E 1 + 2 mu E + Q,    dQ/dt + Q / time = 2 viscousShear d(dev E)/dt.
///
/// The update of Q is exact where dE/dt is constant over a step. Source: Simo and Hughes, Computational
/// Inelasticity, section 10.3. The relaxation time follows Arrhenius, exp(activation (1/T - 1/T0)). For small
/// strain, as Linear Elastic is. The history holds Q and the energy dissipated per undeformed volume.
struct StandardLinearSolid : LawDefaults
{
  static constexpr const char* name = "Standard Linear Solid";
  static constexpr const char* meaning =
      "Viscoelastic solid: elastic, with a shear stress on top that relaxes with one relaxation time.";

  /// Indices in Properties::own.
  enum
  {
    viscousShear,   ///< shear modulus of the branch that relaxes [Pa]
    relaxationTime, ///< at the reference temperature [s]
    activation      ///< activation energy over Boltzmann's constant [K]
  };

  static constexpr bool usesStep = true;
  template <int D>
  static constexpr int historySize = symmetricSize<D> + 1;
  template <int D>
  static constexpr int dissipationIndex = symmetricSize<D>;
  template <int D>
  KOKKOS_INLINE_FUNCTION static constexpr Mean meanOf(int /*variable*/)
  {
    return Mean::Volume; // stress and energy are per volume
  }

  template <class Section>
  static void describe(Section& s)
  {
    describeElasticity(s);
    s.real("Viscous Shear Modulus")
        .orTable()
        .unit("Pa")
        .positive()
        .meaning("Shear modulus of the branch that relaxes; Young Modulus and Poisson Ratio are those after "
                 "relaxation.");
    s.real("Relaxation Time")
        .unit("s")
        .positive()
        .meaning("Time in which the stress of that branch falls to 1/e, at the reference temperature.");
    s.real("Activation Temperature")
        .unit("K")
        .notNegative()
        .byDefault(0.0)
        .meaning("B in Relaxation Time x exp(B (1/T - 1/Reference Temperature)).");
    describeHeatOfDissipation(s);
  }

  template <class Reader>
  static void read(const Reader& reader, Properties& m)
  {
    readElasticity(reader, 0.0, m);
    m.own[viscousShear] = reader.positive("Viscous Shear Modulus", "shear modulus [Pa]");
    m.own[relaxationTime] = reader.positive("Relaxation Time", "time [s]");
    m.own[activation] = reader.optional("Activation Temperature", "temperature [K]");
  }

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static bool stress(const LawStep& step, const Properties& m, double* F, double* tau,
                                            double* history)
  {
    const double ratio = step.dt / timeAt(m, step.temperature), decay = std::exp(-ratio);
    const double gain = ratio > 0.0 ? -std::expm1(-ratio) / ratio : 1.0; // mean of exp over the step
    const double stiffness = 2.0 * m.own[viscousShear] * gain;
    double before[symmetricSize<D>], E[symmetricSize<D>];
    greenStrain<D>(step.before, before);
    greenStrain<D>(F, E);
    const double meanBefore = trace<D>(before) / 3.0;
    if constexpr (P == Plane::Stress)
    {
      // S_zz = 0 is linear in E_zz.
      const double plane = E[0] + E[1];
      const double fixed =
          m.lambda * plane + decay * history[3] - stiffness * (plane / 3.0 + before[3] - meanBefore);
      E[3] = -fixed / (m.lambda + 2.0 * m.mu + 2.0 / 3.0 * stiffness);
      if (!(1.0 + 2.0 * E[3] > 0.0))
        return noStress<D>(tau);
      F[4] = std::sqrt(1.0 + 2.0 * E[3]);
    }
    if (!(determinant<D>(F) > 0.0))
      return noStress<D>(tau);
    const double mean = trace<D>(E) / 3.0;
    double work = 0.0;
    const double stored = storedInBranch<D>(m, history);
    for (int i = 0; i < symmetricSize<D>; ++i)
    {
      const bool shear = i >= shearBegin<D> && i < shearEnd<D>;
      const double change = E[i] - before[i] - (shear ? 0.0 : mean - meanBefore);
      const double old = history[i];
      history[i] = decay * old + stiffness * change;
      work += (shear ? 2.0 : 1.0) * 0.5 * (old + history[i]) * change;
    }
    history[dissipationIndex<D>] += work - (storedInBranch<D>(m, history) - stored);
    kirchhoff<D>(m, F, E, history, tau);
    return true;
  }

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double energy(const Properties& m, const double* F, const double* history)
  {
    double E[symmetricSize<D>];
    greenStrain<D>(F, E);
    const double dilatation = trace<D>(E);
    return 0.5 * m.lambda * dilatation * dilatation + m.mu * squaredNorm<D>(E) +
           storedInBranch<D>(m, history);
  }

  /// That of LinearElastic, with the moduli before relaxation and the stress of now.
  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double waveSpeed(const Properties& m, const double* F, const double* history)
  {
    const double mu = m.mu + m.own[viscousShear];
    double lambda = m.bulk - 2.0 / 3.0 * mu;
    if constexpr (P == Plane::Stress)
      lambda *= 2.0 * mu / (lambda + 2.0 * mu);
    double E[symmetricSize<D>], tau[symmetricSize<D>], g[symmetricSize<D>];
    greenStrain<D>(F, E);
    kirchhoff<D>(m, F, E, history, tau);
    leftStrain<D>(F, g);
    const double b = 1.0 + directionalRange<D>(g).largest;
    return speedOf(directionalRange<D>(tau).largest + (lambda + 2.0 * mu) * b * b, m.density);
  }

private:
  KOKKOS_INLINE_FUNCTION static double timeAt(const Properties& m, double temperature)
  {
    return m.own[relaxationTime] * std::exp(m.own[activation] * (1.0 / temperature - 1.0 / m.temperature));
  }

  /// E = (F^T F - 1) / 2.
  template <int D>
  KOKKOS_INLINE_FUNCTION static void greenStrain(const double* F, double* E)
  {
    for (int i = 0; i < D; ++i)
      for (int j = i; j < D; ++j)
      {
        double sum = i == j ? -1.0 : 0.0;
        for (int k = 0; k < D; ++k)
          sum += F[k * D + i] * F[k * D + j];
        E[symmetricIndex<D>(i, j)] = 0.5 * sum;
      }
    if constexpr (D == 2)
      E[3] = 0.5 * (F[4] * F[4] - 1.0);
  }

  /// tau = F S F^T.
  template <int D>
  KOKKOS_INLINE_FUNCTION static void kirchhoff(const Properties& m, const double* F, const double* E,
                                               const double* history, double* tau)
  {
    double S[symmetricSize<D>];
    for (int i = 0; i < symmetricSize<D>; ++i)
      S[i] = 2.0 * m.mu * E[i] + history[i];
    for (int i = 0; i < 3; ++i)
      S[normalIndex<D>(i)] += m.lambda * trace<D>(E);
    pushForward<D>(F, S, tau);
  }

  template <int D>
  KOKKOS_INLINE_FUNCTION static double storedInBranch(const Properties& m, const double* history)
  {
    return 0.25 * squaredNorm<D>(history) / m.own[viscousShear];
  }
};

} // namespace Rhegma
