#pragma once
/// Stress, and where there is heat the temperature, of some particles that a step has strained.

#include "grid/Blocks.hpp"
#include "material/HistoryRoom.hpp"
#include "material/ThermoLaw.hpp"
#include "state/Types.hpp"

#include <limits>

namespace Rhegma
{

namespace detail
{

/// What the lanes of a bundle hold; component by component, so that a loop over lanes reads and writes
/// neighbours.
template <int D>
struct StrainLanes
{
  double gradient[D * D][lanes];    ///< of the straining velocity, row by row [1/s]
  double shift[D][lanes];           ///< velocity of the particles' places [m/s]
  double F[gradientSize<D>][lanes]; ///< old, then new
  double tau[symmetricSize<D>][lanes];
  double speed[lanes]; ///< of the particle, then with the wave speed on top [m/s]
};

/// F <- (I + dt L) F, stress and wave speed of the lanes from .. to - 1, all of one material.
template <int D>
struct StressOfLanes
{
  const Properties& properties;
  StrainLanes<D>& at;
  double* history; ///< of the first lane; null for laws without one
  int historyWidth;
  double dt;
  int from, to;

  template <class Law, int, Plane P>
  KOKKOS_INLINE_FUNCTION void run() const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (int l = from; l < to; ++l)
    {
      double F[gradientSize<D>], tau[symmetricSize<D>];
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
        {
          double change = 0.0;
          for (int k = 0; k < D; ++k)
            change += at.gradient[i * D + k][l] * at.F[k * D + j][l];
          F[i * D + j] = at.F[i * D + j][l] + dt * change;
        }
      if constexpr (D == 2)
        F[4] = at.F[4][l];
      // Finite only if every component is.
      const bool finite = determinant<D>(F) < infinity;
      double* const own = history == nullptr ? nullptr : history + l * historyWidth;
      const bool good = Law::template stress<D, P>(properties, F, tau, own);
      const double wave = Law::template waveSpeed<D, P>(properties, F, own);
      at.speed[l] = good && finite ? at.speed[l] + wave : infinity;
      for (int k = 0; k < gradientSize<D>; ++k)
        at.F[k][l] = F[k];
      for (int k = 0; k < symmetricSize<D>; ++k)
        at.tau[k][l] = tau[k];
    }
  }
};

/// What the lanes of a bundle hold of heat.
template <int D>
struct HeatLanes
{
  double temperature[lanes]; ///< [K]
  double internal[lanes];    ///< [J/m3]
};

/// Power of a stress, per undeformed volume [W/m3].
template <int D>
KOKKOS_FORCEINLINE_FUNCTION double powerOfLane(const double* tau, const StrainLanes<D>& at, int l)
{
  double power = 0.0;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      power += tau[symmetricIndex<D>(i, j)] * at.gradient[i * D + j][l];
  return power;
}

/// F <- (I + dt L) F, stress, internal energy, temperature and wave speed of the lanes from .. to - 1, all of
/// one material none of whose properties is a table.
///
/// The internal energy takes up the work of the mean of old and new stress, which is what the nodes' forces
/// do, so that no energy is lost or made whatever the law; the temperature is what that energy leaves beside
/// the elastic one (ThermoLaw.hpp). A stress that lags behind its temperature would excite short waves; so
/// the stress is found at the temperature to which straining brings the material at small strain, and what
/// the energy says beyond that, of higher order in strain or of plastic work, waits for the next step.
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
  double dt;
  int from, to;

  template <class Law, int, Plane P>
  KOKKOS_INLINE_FUNCTION void run() const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double alpha = knot.expansion, T0 = material.reference, capacity = knot.capacity;
    // Change of the trace of stress with that of strain: 3 K, in plane stress E / (1 - nu).
    const double stiffness =
        P == Plane::Stress ? 2.0 * (properties.planeLambda + properties.mu) : 3.0 * properties.bulk;
    const double cooling = dt * alpha * stiffness / capacity, push = 3.0 * properties.bulk * alpha;
    const double adiabatic = push * push / (capacity * properties.density);
    for (int l = from; l < to; ++l)
    {
      double F[gradientSize<D>], own[gradientSize<D>], tau[symmetricSize<D>], stretching = 0.0;
      for (int k = 0; k < symmetricSize<D>; ++k)
        tau[k] = at.tau[k][l];
      const double before = dt * powerOfLane<D>(tau, at, l);
      for (int i = 0; i < D; ++i)
      {
        stretching += at.gradient[i * D + i][l];
        for (int j = 0; j < D; ++j)
        {
          double change = 0.0;
          for (int k = 0; k < D; ++k)
            change += at.gradient[i * D + k][l] * at.F[k * D + j][l];
          F[i * D + j] = at.F[i * D + j][l] + dt * change;
        }
      }
      if constexpr (D == 2)
        F[4] = at.F[4][l];
      const bool finite = determinant<D>(F) < infinity;
      double T = heat.temperature[l] * (1.0 - cooling * stretching);
      const double theta = 1.0 + alpha * (T - T0), inverse = 1.0 / theta;
      for (int k = 0; k < gradientSize<D>; ++k)
        own[k] = inverse * F[k];
      double* const memory = history == nullptr ? nullptr : history + l * historyWidth;
      const bool good = Law::template stress<D, P>(properties, own, tau, memory);
      if constexpr (P == Plane::Stress)
        F[4] = theta * own[4];
      double has = Law::template energy<D, P>(properties, own, memory) + T * alpha * inverse * trace<D>(tau) +
                   (T - T0) * (capacity + 0.5 * material.coupling * (T + T0));
      if (historyWidth > 0)
        has += (1.0 - material.plasticHeat) * dissipatedEnergy<D>(properties, memory);
      const double energy = heat.internal[l] + 0.5 * (before + dt * powerOfLane<D>(tau, at, l));
      const double wave = Law::template waveSpeed<D, P>(properties, own, memory);
      heat.internal[l] = energy;
      const double after = T + (energy - has) / capacity;
      heat.temperature[l] = after;
      at.speed[l] =
          good && finite && after > 0.0 ? at.speed[l] + std::sqrt(wave * wave + after * adiabatic) : infinity;
      for (int k = 0; k < gradientSize<D>; ++k)
        at.F[k][l] = F[k];
      for (int k = 0; k < symmetricSize<D>; ++k)
        at.tau[k][l] = tau[k];
    }
  }
};

/// The same for particles whose properties are tables: with two looks at their law, the stress that of the
/// temperature in the end.
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
  double dt;
  int from, to;

  KOKKOS_INLINE_FUNCTION void run() const
  {
    for (int l = from; l < to; ++l)
      one(l);
  }

  KOKKOS_INLINE_FUNCTION void one(int l) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double F[gradientSize<D>], tau[symmetricSize<D>], wave = 0.0, has = 0.0;
    for (int k = 0; k < symmetricSize<D>; ++k)
      tau[k] = at.tau[k][l];
    const double before = powerOfLane<D>(tau, at, l);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
      {
        double change = 0.0;
        for (int k = 0; k < D; ++k)
          change += at.gradient[i * D + k][l] * at.F[k * D + j][l];
        F[i * D + j] = at.F[i * D + j][l] + dt * change;
      }
    if constexpr (D == 2)
      F[4] = at.F[4][l];
    const bool finite = determinant<D>(F) < infinity;
    double& T = heat.temperature[l];
    double* const own = history == nullptr ? nullptr : history + l * historyWidth;
    double trial[historyRoom];
    for (int k = 0; k < historyWidth; ++k)
      trial[k] = own[k];
    const ThermoPoint start(tables, material, T);
    bool good =
        withLaw<D>(properties.kind, properties.plane, ThermoStress{start, T, F, tau, trial, has, wave});
    const double energy = heat.internal[l] + 0.5 * dt * (before + powerOfLane<D>(tau, at, l));
    T += (energy - has) / start.capacity();
    if (start.material.coupled)
    {
      const ThermoPoint end(tables, material, T);
      for (int k = 0; k < historyWidth; ++k)
        trial[k] = own[k];
      good = good &&
             withLaw<D>(properties.kind, properties.plane, ThermoStress{end, T, F, tau, trial, has, wave});
    }
    heat.internal[l] += 0.5 * dt * (before + powerOfLane<D>(tau, at, l));
    for (int k = 0; k < historyWidth; ++k)
      own[k] = trial[k];
    at.speed[l] = good && finite && T > 0.0 ? at.speed[l] + wave : infinity;
    for (int k = 0; k < gradientSize<D>; ++k)
      at.F[k][l] = F[k];
    for (int k = 0; k < symmetricSize<D>; ++k)
      at.tau[k][l] = tau[k];
  }
};

} // namespace detail

} // namespace Rhegma
