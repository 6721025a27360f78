#pragma once
/// Stress, temperature and internal energy of some particles that a step has strained.
///
/// The internal energy follows from the law's own energy: with the free energy psi(F, T) and P : dF = dW -
/// W_T dT (ThermoLaw.hpp),
///
///     work = W(F', T') - W(F, T) - (W_T + W_T') (T' - T) / 2 + plastic work,
///
/// so that a law whose stress does not depend on temperature does the same work as without heat, W(F') -
/// W(F), for any size of the strain. (The mean of old and new stress times the strain of a step has an error
/// of second order in that strain, which cyclic straining does not cancel.)
///
/// The law is evaluated at the temperature that small straining gives the particle. The remaining change of
/// energy, of higher order in strain or by plastic work, changes the temperature and, by the thermal stress
/// of the small difference, the stress. A stress that lags behind its temperature acts as negative damping of
/// short waves, which is unstable where the adiabatic stiffness is much larger than the isothermal one.
///
/// The force at the start of a step is that of the stored stress of a particle. It contains neither changes
/// of temperature at fixed strain since that stress was computed (conduction, sources) nor viscosity of the
/// law: half of the step moves against that stress and not against the law's, and the work of the difference
/// is recorded. (The force is that of the middle between two steps.)
///
/// A step of equilibrium balances the stress at the temperatures of its start. It therefore strains particles
/// at T, whose stress stays that of this equilibrium, and temperatures follow from e afterwards, as if they
/// changed at fixed strain before the next step. Where temperatures are held (steady conduction) they do not
/// follow: a particle gets the heat e(F', T) - e - work.

#include "material/ThermoLaw.hpp"
#include "transfer/LaneStress.hpp"

#include <string>

namespace Rhegma
{

namespace fields
{
/// Fraction of a step in which the force at its start acts [-]; 1 without the field.
inline const std::string firstFraction = "fraction of the first force";
} // namespace fields

namespace detail
{

/// Thermal data of the lanes of a bundle.
template <int D>
struct HeatLanes
{
  double temperature[lanes];   ///< [K]
  double internal[lanes];      ///< [J/m3]
  double firstFraction[lanes]; ///< fraction of the step in which the force at its start acts; 1 except in
                               ///< substeps
  double supplied[lanes];      ///< out: heat that holds the temperature; zero where it is not held [J/m3]
  double isothermal = 0.0;     ///< 1 where the strain is at the temperature of the start, else 0
  double held = 0.0;           ///< 1 where temperatures are held, else 0
};

/// Work per undeformed volume that the half of the first force which lies in this step does beyond that of
/// the law's own stress [J/m3]. \param law stress at the temperature at the start
template <int D>
KOKKOS_FORCEINLINE_FUNCTION double workOfLag(const StrainLanes<D>& at, const HeatLanes<D>& heat,
                                             const double* law, int l, double dt)
{
  double power = 0.0;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
    {
      const int k = symmetricIndex<D>(i, j);
      power += (at.tau[k][l] - law[k]) * at.gradient[i * D + j][l];
    }
  return 0.5 * heat.firstFraction[l] * dt * power;
}

/// Adds the thermal stress of a small rise of temperature. \param pressure per kelvin: 3 K alpha, or in plane
/// stress that of the plane
template <int D, Plane P>
KOKKOS_FORCEINLINE_FUNCTION void addThermalStress(double pressure, double rise, double* tau)
{
  constexpr int held = P == Plane::Stress ? 2 : 3;
  for (int i = 0; i < held; ++i)
    tau[normalIndex<D>(i)] -= pressure * rise;
}

/// F <- (I + dt L) F, stress, internal energy, temperature and wave speed of the lanes from .. to - 1, all of
/// one material none of whose properties is a table.
template <int D>
struct HeatOfLanes
{
  const Properties& properties;
  const ThermoMaterial& material;
  const ThermoKnot& knot;
  StrainLanes<D>& at; ///< its stress is the old one on entry
  HeatLanes<D>& heat;
  double* history; ///< of the first lane; null for laws without one
  int historyWidth;
  double dt;       ///< times the gradient: the strain
  double duration; ///< of the strain [s]
  int from, to;

  template <class Law, int, Plane P>
  KOKKOS_INLINE_FUNCTION void run() const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double alpha = knot.expansion, T0 = material.reference, capacity = knot.capacity;
    // Change of the trace of stress with that of strain: 3 K, in plane stress E / (1 - nu).
    const double stiffness =
        P == Plane::Stress ? 2.0 * (properties.planeLambda + properties.mu) : 3.0 * properties.bulk;
    const double free = 1.0 - heat.isothermal;
    const double cooling = free * dt * alpha * stiffness / capacity, push = 3.0 * properties.bulk * alpha;
    const double adiabatic = push * push / (capacity * properties.density);
    for (int l = from; l < to; ++l)
    {
      double F[gradientSize<D>], own[gradientSize<D>], tau[symmetricSize<D>], stretching = 0.0;
      // Laws without a history let the compiler vectorise over particles.
      double* const memory = hasHistory<Law> ? history + l * historyWidth : nullptr;
      const double before = heat.temperature[l];
      // Energy of the law at the start of the step, at the present temperature.
      const double expanded = 1.0 / (1.0 + alpha * (before - T0));
      for (int k = 0; k < gradientSize<D>; ++k)
        own[k] = expanded * at.F[k][l];
      if constexpr (hasHistory<Law>)
      {
        double copy[historyCapacity];
        for (int k = 0; k < historyWidth; ++k)
          copy[k] = memory[k];
        stressOfLaw<Law, D, P>({own, 0.0, before}, properties, own, tau, copy);
      }
      else
        stressOfLaw<Law, D, P>({own, 0.0, before}, properties, own, tau, nullptr);
      double start[Law::usesStep ? gradientSize<D> : 1];
      if constexpr (Law::usesStep)
        for (int k = 0; k < gradientSize<D>; ++k)
          start[k] = own[k];
      double work = -Law::template energy<D, P>(properties, own, memory);
      if constexpr (hasHistory<Law>)
        work -= dissipatedByLaw<Law, D>(memory);
      const double slope = alpha * expanded * trace<D>(tau);
      work += workOfLag<D>(at, heat, tau, l, dt);

      strained<D>(at, l, dt, F);
      for (int i = 0; i < D; ++i)
        stretching += at.gradient[i * D + i][l];
      const bool finite = determinant<D>(F) < infinity;
      const double T = before * (1.0 - cooling * stretching);
      const double theta = 1.0 + alpha * (T - T0), inverse = 1.0 / theta;
      for (int k = 0; k < gradientSize<D>; ++k)
        own[k] = inverse * F[k];
      const bool good = stressOfLaw<Law, D, P>({start, duration, T}, properties, own, tau, memory);
      if constexpr (P == Plane::Stress)
        F[4] = theta * own[4];
      const double now = alpha * inverse * trace<D>(tau);
      const double elastic = Law::template energy<D, P>(properties, own, memory);
      double has = elastic + T * now + (T - T0) * (capacity + 0.5 * material.coupling * (T + T0));
      work += elastic + 0.5 * (slope + now) * (T - before);
      if constexpr (hasHistory<Law>)
      {
        const double flow = dissipatedByLaw<Law, D>(memory);
        work += flow;
        has += (1.0 - material.plasticHeat) * flow;
      }
      heat.internal[l] += work;
      const double excess = heat.internal[l] - has, rise = (1.0 - heat.held) * excess / capacity,
                   after = T + rise;
      heat.supplied[l] = -heat.held * excess;
      heat.internal[l] += heat.supplied[l];
      heat.temperature[l] = after;
      const double wave = Law::template waveSpeed<D, P>(properties, own, memory);
      at.speed[l] =
          good && finite && after > 0.0 ? at.speed[l] + std::sqrt(wave * wave + after * adiabatic) : infinity;
      addThermalStress<D, P>(free * alpha * stiffness, rise, tau);
      storeLane(at, l, F, tau);
    }
  }
};

/// The same for particles whose properties are tables: T' follows from the energy at the old temperature.
template <int D>
struct HeatByTables
{
  const Properties& properties;
  const ThermoTables& tables;
  int material;
  StrainLanes<D>& at; ///< its stress is the old one on entry
  HeatLanes<D>& heat;
  double* history; ///< of the first lane; null for laws without one
  int historyWidth;
  double dt;       ///< times the gradient: the strain
  double duration; ///< of the strain [s]
  int from, to;

  KOKKOS_INLINE_FUNCTION void run() const
  {
    for (int l = from; l < to; ++l)
      one(l);
  }

  KOKKOS_INLINE_FUNCTION void one(int l) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double F[gradientSize<D>], tau[symmetricSize<D>], memory[historyCapacity];
    double* const own = history == nullptr ? nullptr : history + l * historyWidth;
    double& T = heat.temperature[l];
    const double before = T;
    const ThermoPoint start(tables, material, before);
    double strainedBefore[gradientSize<D>]; // without thermal strain
    for (int k = 0; k < gradientSize<D>; ++k)
    {
      F[k] = at.F[k][l];
      strainedBefore[k] = F[k] / start.stretch();
    }
    ThermoState old, now;
    evaluate(start, {strainedBefore, 0.0, before}, F, tau, own, memory, old);
    const double lag = workOfLag<D>(at, heat, tau, l, dt);
    strained<D>(at, l, dt, F);
    const bool finite = determinant<D>(F) < infinity;
    bool good = evaluate(start, {strainedBefore, duration, before}, F, tau, own, memory, now);
    double work = lag + now.spent() - old.spent();
    const double free = 1.0 - heat.isothermal;
    T += free * (heat.internal[l] + work - now.internal) / start.capacity();
    if (start.material.coupled)
    {
      const ThermoPoint end(tables, material, T);
      good = evaluate(end, {strainedBefore, duration, T}, F, tau, own, memory, now) && good;
      work = lag + now.spent() - old.spent() - 0.5 * (old.slope + now.slope) * (T - before);
    }
    else
      now.internal += ThermoPoint(tables, material, T).heat() - start.heat(); // the rest is the same at T
    heat.internal[l] += work;
    const double excess = heat.internal[l] - now.internal;
    heat.supplied[l] = -heat.held * excess;
    heat.internal[l] += heat.supplied[l];
    const double rise = (1.0 - heat.held) * excess / start.capacity(), alpha = free * start.expansion();
    T += rise;
    if constexpr (D == 2)
    {
      if (properties.plane == Plane::Stress)
        addThermalStress<D, Plane::Stress>(2.0 * alpha * (properties.planeLambda + properties.mu), rise, tau);
      else
        addThermalStress<D, Plane::Strain>(3.0 * alpha * properties.bulk, rise, tau);
    }
    else
      addThermalStress<D, Plane::Solid>(3.0 * alpha * properties.bulk, rise, tau);
    for (int k = 0; k < historyWidth; ++k)
      own[k] = memory[k];
    at.speed[l] = good && finite && T > 0.0 ? at.speed[l] + now.wave : infinity;
    storeLane(at, l, F, tau);
  }

  /// Evaluates the law for F at a temperature, starting from its history; `memory` gets the new history.
  KOKKOS_INLINE_FUNCTION bool evaluate(const ThermoPoint& point, const LawStep& step, double* F, double* tau,
                                       const double* own, double* memory, ThermoState& result) const
  {
    for (int k = 0; k < historyWidth; ++k)
      memory[k] = own[k];
    return withLaw<D>(properties.law, properties.plane,
                      ThermoStress{step, point, step.temperature, F, tau, memory, result});
  }
};

} // namespace detail

} // namespace Rhegma
