#pragma once
/// Damping: mass-proportional, viscous in the material, or both; and stopping when the run has settled.

#include "step/Effect.hpp"

namespace Rhegma::damping
{

/// The effect `Damping`.
EffectEntry dampingEntry();

/// Takes v to v exp(-rate dt) on every particle: the exact motion under the force -rate m v over dt.
///
/// It acts on the particles and not on the nodes because particles have motions that the nodes can't see,
/// which would never come to rest (measured: 0.1 % of the strain energy for ever). \return the kinetic energy
/// [J] that is lost
template <int D>
double dampVelocity(State<D>& state, double rate);

/// Adds the viscous stress 2 eta D + zeta (tr D) 1 to the particles' Kirchhoff stress [Pa], D the rate of
/// strain. \return the energy [J] that it dissipates over dt: dt sum V0 tau_v : D, never negative
template <int D>
double addViscousStress(State<D>& state, double shearViscosity, double bulkViscosity);

} // namespace Rhegma::damping
