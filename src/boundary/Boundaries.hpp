#pragma once
/// Prescribed motion, symmetry, loads and gravity.

#include "plan/Effect.hpp"

namespace Rhegma
{

/// Name of the boundaries as a part of the core.
constexpr const char* boundariesName = "Boundaries";

/// The boundaries of a scene (its section `Boundaries`) as a part of the core.
/// \param scene must outlive the effect, which reads it at its start
/// \param cellsChange whether cells refine or coarsen in the run
template <int D>
Effect<D> makeBoundaries(const Teuchos::ParameterList& scene, bool cellsChange);

/// Work and impulse of the forces that enforce a prescribed motion over a step.
template <int D>
struct Reaction
{
  double work;       ///< on the body [J]
  Vector<D> impulse; ///< on the body [N s]
};

/// Prescribes the nodes' motion (velocity and acceleration).
/// \param earlier as it was at the start of the step
/// \return the impulse, the change of the nodes' momentum, and its work: the impulse times the mean of old
/// and new velocity; with MUSL that of the prescribed velocities, to which constrainProjection adds the rest
template <int D>
Reaction<D> constrainMotion(State<D>& state, const NodeConstraint<D>& constraint,
                            const NodeConstraint<D>& earlier);

/// Prescribes the velocity that strains the particles.
///
/// With MUSL the particles around a held node have a velocity v that differs from the prescribed V, because
/// they also belong to nodes that are not held: the solve finds v at the node and replaces it by V, and the
/// projection finds v' again. Internal forces f strain the particles with V. So the node's mass m receives
/// the energy m (V - v) (v + v') / 2, and strain -f dt V, with V the mean over the step. The work of the
/// impulse m (V - v) - f dt at V lacks m (V - v) ((v + v') / 2 - V) of this sum.
/// \param held node and axis: not 0 where another support has counted it; this one sets its marks; empty with
/// a single support \return this rest [J], negative where a support absorbs energy of waves of a few cells; 0
/// with other schemes
template <int D>
double constrainProjection(State<D>& state, const NodeConstraint<D>& constraint,
                           const NodeConstraint<D>& earlier, const View<char**>& held);

} // namespace Rhegma
