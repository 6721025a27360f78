#pragma once
/// Prescribed motion, symmetry, loads and gravity.

#include "plan/Effect.hpp"

namespace Rhegma
{

/// Name of the part of the core that they make.
constexpr const char* boundariesName = "Boundaries";

/// The boundaries of a scene (its section `Boundaries`) as a part of the core.
template <int D>
Effect<D> makeBoundaries(const Teuchos::ParameterList& scene, bool cellsChange);

/// What the forces that hold a motion did over a step.
template <int D>
struct Reaction
{
  double work;       ///< on the body [J]
  Vector<D> impulse; ///< on the body [N s]
};

/// Prescribes the nodes' motion (velocity and acceleration).
/// \param earlier as it was at the start of the step
/// \return the impulse that this takes, the change of the nodes' momentum, and its work: the impulse times
/// the mean of old and new velocity, with MUSL of the prescribed ones, to which constrainProjection adds
template <int D>
Reaction<D> constrainMotion(State<D>& state, const NodeConstraint<D>& constraint,
                            const NodeConstraint<D>& earlier);

/// Prescribes the velocity that strains the particles.
///
/// With MUSL the particles about a held node keep a velocity v of their own, by what they move in the next
/// cell: the solve finds it at the node, brings it to the prescribed V, and the projection finds some of it
/// again, v'. Internal forces f have strained the particles with V there. So what the node's mass m takes is
/// m (V - v) (v + v') / 2, and what they take -f dt V, with V the mean over the step; of that the impulse
/// m (V - v) - f dt times V has all but m (V - v) ((v + v') / 2 - V).
/// \param held node and axis: not 0 where another support has recorded it, which this one marks; empty where
/// there is one support only \return this rest [J], negative where a support takes energy out of waves of a
/// few cells; 0 with other schemes
template <int D>
double constrainProjection(State<D>& state, const NodeConstraint<D>& constraint,
                           const NodeConstraint<D>& earlier, const View<char**>& held);

} // namespace Rhegma
