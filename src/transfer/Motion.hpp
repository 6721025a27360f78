#pragma once
/// The nodes' equation of motion with lumped mass.

#include "state/State.hpp"

namespace Rhegma
{

/// What added inertia takes from the momentum of a node's primary field, or from the force on it, along an
/// axis; the enriched field gets as much. The relative velocity or acceleration of the fields falls by the
/// factor m0 / (m0 + added), with their reduced mass m0. \param mass, other: of the fields [kg] \param value,
/// otherValue: their momenta [kg m/s] or the forces on them [N] \param added [kg]
KOKKOS_INLINE_FUNCTION double takenByInertia(double mass, double other, double value, double otherValue,
                                             double added)
{
  const double both = mass + other, reduced = mass * other / both;
  return added / (reduced + added) * (other * value - mass * otherValue) / both;
}

/// Nodal values with a relative part.
enum class RelativePart
{
  Momentum,
  Force,
  Projection
};

/// Makes the relative part of the fields of nodes smaller as inertia against it would
/// (State::motion.relativeInertia), for springs between the fields that are too stiff for the step.
///
/// With the particles' masses m, their interpolation N, the lumped masses M and the added ones A, a step is
/// v += dt N (M + A)^-1 f, w = (M + A)^-1 N' m v, u += dt w, if it acts on momentum, force and projection. It
/// keeps the energy of an elastic force f = -K u as without A, and as N' m N <= M it is stable with
/// K <= 4 / dt^2 (M + A): a spring of stiffness S needs A = S dt^2 / 4 where the material alone is stable. On
/// forces alone the step would not be symmetric, and would gain energy. What is at rest does not feel it, and
/// the sum of both fields does not change. (Selective mass scaling: Olovsson, Simonsson, Unosson, Int. J.
/// Numer. Meth. Eng. 63 (2005) 1436.)
///
/// The values must be sums over all ranks.
template <int D>
void slowRelativeMotion(State<D>& state, RelativePart part);

/// a = f / m and v = p / m + a dt on every node with mass; zero elsewhere.
template <int D>
void solveLumped(State<D>& state);

} // namespace Rhegma
