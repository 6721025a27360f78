#pragma once
/// Gases and liquids.

#include "material/ArtificialViscosity.hpp"
#include "material/FluidParameters.hpp"
#include "material/FluidStates.hpp"
#include "material/Tensors.hpp"

namespace Rhegma
{

/// A material without shear strength: tau = -J p 1 + 2 eta J dev d - q 1, with the pressure p of an equation
/// of state (FluidStates.hpp), Newton's viscosity eta without a viscosity of the volume (Stokes), and
/// artificial viscosity q (ArtificialViscosity.hpp). d is the rate of strain of the step, of the midpoint
/// rule, so that a rotation has none.
///
/// Adiabatic: a gas warms by compression and by all work of both viscosities; a liquid by Tait has a pressure
/// of its volume alone. The history holds the viscous stress of the last step, what both viscosities have
/// dissipated, E, the heat Q in it (zero for Tait), q, and the speed of waves. Stored is E - Q.
///
/// Plane stress has no meaning and is refused.
struct Fluid : LawDefaults
{
  static constexpr const char* name = "Fluid";
  static constexpr const char* meaning =
      "Gas or liquid: a pressure by an equation of state, and viscosity; no strength in shear. Dynamic only.";

  static constexpr bool usesStep = true;
  template <int D>
  static constexpr int dissipationIndex = symmetricSize<D>;
  template <int D>
  static constexpr int energyIndex = symmetricSize<D> + 1;
  template <int D>
  static constexpr int heatIndex = symmetricSize<D> + 2;
  template <int D>
  static constexpr int viscousIndex = symmetricSize<D> + 3;
  template <int D>
  static constexpr int speedIndex = symmetricSize<D> + 4;
  template <int D>
  static constexpr int historySize = symmetricSize<D> + 5;
  template <int D>
  KOKKOS_INLINE_FUNCTION static constexpr Mean meanOf(int variable)
  {
    return variable == speedIndex<D> ? Mean::Largest : Mean::Volume;
  }

  static const char* refusesHeat(const Properties&)
  {
    return "the law Fluid is adiabatic and has an internal energy of its own; remove the section Thermal";
  }
  template <class Section>
  static void describe(Section& s)
  {
    describeFluid(s);
  }
  template <class Reader>
  static void read(const Reader& reader, Properties& m)
  {
    readFluid(reader, m);
  }

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static bool stress(const LawStep& step, const Properties& m, double* F, double* tau,
                                            double* history)
  {
    const double J = determinant<D>(F), before = determinant<D>(step.before);
    if (!(J > 0.0) || !(before > 0.0))
      return noStress<D>(tau);
    double& energy = history[energyIndex<D>];
    if (isGas(m))
      energy = IdealGas(m).compress(energy, before, J);
    double modulus = 0.0;
    pressure(m, J, energy, modulus);

    double heat = 0.0;
    const double viscous =
        artificial(m).pressure(step.dt, J, before, speedOf(modulus, m.density), history[viscousIndex<D>],
                               history[dissipationIndex<D>], heat);
    if (m.own[FluidNumber::viscosity] > 0.0 && step.dt > 0.0)
      shear<D>(step, m, F, J, history, heat);
    if (isGas(m))
    {
      energy += heat;
      history[heatIndex<D>] += heat;
    }
    const double shift = -J * pressure(m, J, energy, modulus) - viscous;
    if (!isGas(m))
      energy = Tait(m).energy(J);
    for (int i = 0; i < symmetricSize<D>; ++i)
      tau[i] = history[i];
    for (int i = 0; i < 3; ++i)
      tau[normalIndex<D>(i)] += shift;
    history[speedIndex<D>] = speed<D>(m, J, modulus, viscous);
    return true;
  }

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double energy(const Properties&, const double*, const double* history)
  {
    return history[energyIndex<D>] - history[heatIndex<D>];
  }

  /// That of the last stress; before the first one that of the undeformed fluid.
  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double waveSpeed(const Properties& m, const double*, const double* history)
  {
    const double now = history[speedIndex<D>];
    return now > 0.0 ? now : speed<D>(m, 1.0, m.bulk, 0.0);
  }

private:
  KOKKOS_INLINE_FUNCTION static bool isGas(const Properties& m)
  {
    return m.own[FluidNumber::state] == static_cast<double>(FluidState::idealGas);
  }

  KOKKOS_INLINE_FUNCTION static double pressure(const Properties& m, double J, double energy, double& modulus)
  {
    return isGas(m) ? IdealGas(m).pressure(J, energy, modulus) : Tait(m).pressure(J, modulus);
  }

  KOKKOS_INLINE_FUNCTION static ArtificialViscosity artificial(const Properties& m)
  {
    return {m.own[FluidNumber::linearViscosity], m.own[FluidNumber::quadraticViscosity], m.density,
            m.cellSize};
  }

  /// Speed of sound, with the viscosities on top. Newton's: the stable step rho l^2 / (4 D eta) of Damping >
  /// Shear Viscosity is that of V = 2 D eta / (rho l) in V + sqrt(V^2 + c^2).
  template <int D>
  KOKKOS_INLINE_FUNCTION static double speed(const Properties& m, double J, double modulus, double q)
  {
    const double sound = speedOf(modulus, m.density), eta = m.own[FluidNumber::viscosity];
    double viscous = q > 0.0 ? artificial(m).speed(sound, q) : 0.0;
    viscous += eta > 0.0 ? 2.0 * D * eta * J / (m.density * m.cellSize) : 0.0;
    return viscous + std::sqrt(viscous * viscous + sound * sound);
  }

  /// Newton's viscous stress, its dissipation by the trapezoidal rule, and its heat, which is not negative.
  template <int D>
  KOKKOS_INLINE_FUNCTION static void shear(const LawStep& step, const Properties& m, const double* F,
                                           double J, double* history, double& heat)
  {
    double strain[symmetricSize<D>];
    midpointStrain<D>(step.before, F, strain);
    const double mean = trace<D>(strain) / 3.0;
    for (int i = 0; i < 3; ++i)
      strain[normalIndex<D>(i)] -= mean;
    const double factor = 2.0 * m.own[FluidNumber::viscosity] * J / step.dt;
    double now[symmetricSize<D>];
    for (int i = 0; i < symmetricSize<D>; ++i)
      now[i] = factor * strain[i];
    const double work = contraction<D>(now, strain);
    history[dissipationIndex<D>] += 0.5 * (work + contraction<D>(history, strain));
    heat += work;
    for (int i = 0; i < symmetricSize<D>; ++i)
      history[i] = now[i];
  }

  /// Symmetric part of 2 (A - 1)(A + 1)^-1, A = F before^-1: the strain of a step with the gradient at its
  /// middle; none of a rotation (Hughes and Winget, Int. J. Numer. Meth. Eng. 15 (1980) 1862).
  template <int D>
  KOKKOS_INLINE_FUNCTION static void midpointStrain(const double* before, const double* F, double* strain)
  {
    double sum[gradientSize<D>], inverted[gradientSize<D>];
    for (int k = 0; k < gradientSize<D>; ++k)
      sum[k] = F[k] + before[k];
    inverse<D>(sum, determinant<D>(sum), inverted);
    for (int i = 0; i < D; ++i)
      for (int j = i; j < D; ++j)
      {
        double ij = 0.0, ji = 0.0;
        for (int k = 0; k < D; ++k)
        {
          ij += (F[D * i + k] - before[D * i + k]) * inverted[D * k + j];
          ji += (F[D * j + k] - before[D * j + k]) * inverted[D * k + i];
        }
        strain[symmetricIndex<D>(i, j)] = ij + ji;
      }
    if constexpr (D == 2)
      strain[3] = 2.0 * (F[4] - before[4]) * inverted[4];
  }
};

} // namespace Rhegma
