#pragma once
/// The nodes' equation of motion with lumped mass.

#include "state/State.hpp"

namespace Rhegma
{

/// Force of added inertia on a node's primary field along an axis [N]; the enriched field gets the opposite
/// one. Fields of masses m1, m2 then part as if m1 m2 / (m1 + m2) were larger by `added`.
/// \param mass, other: of the fields [kg] \param force, otherForce: on them [N] \param added [kg]
KOKKOS_INLINE_FUNCTION double relativeInertiaForce(double mass, double other, double force, double otherForce,
                                                   double added)
{
  const double both = mass + other, reduced = mass * other / both;
  return -added / (reduced + added) * (other * force - mass * otherForce) / both;
}

/// Adds the force of State::motion.relativeInertia to nodes that take the whole step, once their forces are
/// sums over all ranks.
template <int D>
void resistRelativeMotion(State<D>& state);

/// a = f / m and v = p / m + a dt on every node with mass; zero elsewhere.
template <int D>
void solveLumped(State<D>& state);

} // namespace Rhegma
