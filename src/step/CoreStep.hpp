#pragma once
/// The material point method as calls of the stages.

#include "equilibrium/EquilibriumCore.hpp"
#include "plan/Effect.hpp"

namespace Rhegma
{

/// The calls of MUSL, USF, USL or USAVG with a lumped mass.
///
/// MUSL (Sulsky, Zhou and Schreyer 1995) strains the particles by the projection of their new velocities; USF
/// by the projection of the old ones before forces are found; USL by the nodes' new velocity (Bardenhagen, J.
/// Comput. Phys. 180 (2002) 383); USAVG half of the step as USF, by the projection before the forces, and
/// half as MUSL, by the one after them, both with the weights of these forces (Nairn, CMES 4 (2003) 649).
/// Each moves them by the velocity that strains them (Gather.hpp), USAVG by the last.
///
/// Where the scene asks for equilibrium, the calls of EquilibriumCore.hpp instead.
/// \param last gets what a step of equilibrium leaves
template <int D>
Effect<D> makeCore(const State<D>& state, const std::shared_ptr<equilibrium::LastStep>& last = {});

/// Sorts the particles and updates data that depend on their order.
template <int D>
void sortState(State<D>& state);

/// Current largest wave speed plus particle speed [m/s].
template <int D>
double fastestSpeed(const State<D>& state);

} // namespace Rhegma
