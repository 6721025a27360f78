#pragma once
/// Damping: mass-proportional, viscous in the material, or both; and stopping when the run has settled.

#include "plan/Effect.hpp"

namespace Rhegma::damping
{

/// The effect `Damping`.
EffectEntry dampingEntry();

/// Takes v to v exp(-rate dt) on every particle: the exact motion under the force -rate m v over dt.
///
/// It acts on the particles and not on the nodes because particles have motions that nodes do not resolve,
/// which would never be damped (measured: 0.1 % of the strain energy remains). \return the kinetic energy [J]
/// that is lost
template <int D>
double dampVelocity(State<D>& state, double rate);

/// The same of the nodes' momentum, where it is known already.
template <int D>
void dampMomentum(const State<D>& state, double rate);

/// Energy that mass damping removes from the work of stresses, in addition to what dampVelocity returned [J],
/// for MUSL and USAVG, once nodes have the forces of stresses f and no others. Damped velocities are v
/// exp(-rate dt), but particles have been strained by v: in between stresses have given, in the mean of the
/// steps' starts and ends, f (v - v exp(-rate dt)) dt / 2 to a motion that has been damped. At supports it is
/// part of their work, except where masses are coupled: there the work is on the solved velocity before the
/// forces, which was damped. Their velocity is taken as momentum over lumped mass, which is off by what the
/// coupling changes in it, as a part of the loss again. First order in rate dt, as all of the loss is exact
/// without stresses. \param held buffer for the marks of held nodes, reused in each step
template <int D>
double lossToStresses(const State<D>& state, double rate, View<char**>& held);

/// Adds the viscous stress 2 eta D + zeta (tr D) 1 to the particles' Kirchhoff stress [Pa], D the rate of
/// strain. \return the energy [J] that it dissipates over dt: dt sum V0 tau_v : D, never negative
template <int D>
double addViscousStress(State<D>& state, double shearViscosity, double bulkViscosity);

} // namespace Rhegma::damping
