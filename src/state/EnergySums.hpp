#pragma once
/// Sums of the energy balance over particles and over ranks.

#include "state/State.hpp"

namespace Rhegma
{

/// Sums kinetic and strain energy, plastic dissipation [J] and momentum [kg m/s] of the particles into
/// state.energy and state.sample.momentum.
///
/// Kinetic energy is m v.v / 2 of the particles, strain energy the law's stored energy times the undeformed
/// volume. In one kernel; reads velocity, mass, initial volume, deformation gradient, history.
template <int D>
void measureEnergy(State<D>& state);

/// Bound of what the work of thermal strain along a straight path misses [J]: the elastic energy that
/// particles would have at their temperatures if they could not expand at all, 9 K (theta - 1)^2 / 2, times
/// their thermal strain. Zero without heat. Collective.
template <int D>
double errorOfThermalPath(const State<D>& state);

/// The energy balance summed over all ranks; the entries of this rank do not change. Collective.
template <int D>
EnergyBalance energyOfAllRanks(const State<D>& state);

/// Replaces the energy balance of every rank by the sum over all ranks. Collective; `coreRow` calls it too.
template <int D>
void sumEnergyBalance(State<D>& state);

} // namespace Rhegma
