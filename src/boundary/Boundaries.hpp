#pragma once
/// Prescribed motion, symmetry, loads and gravity.

#include "step/Effect.hpp"

namespace Rhegma
{

/// Name of the part of the core that they make.
constexpr const char* boundariesName = "Boundaries";

/// The boundaries of a scene (its section `Boundaries`) as a part of the core.
template <int D>
Effect<D> makeBoundaries(const Teuchos::ParameterList& scene);

/// What the forces that hold a motion did over a step.
template <int D>
struct Reaction
{
  double work;       ///< on the body [J]
  Vector<D> impulse; ///< on the body [N s]
};

/// Prescribes the nodes' motion (velocity and acceleration). \return the impulse that this takes, the change
/// of the nodes' momentum, and its work: the impulse times the mean of old and new velocity
template <int D>
Reaction<D> constrainMotion(State<D>& state, const NodeConstraint<D>& constraint);

/// Prescribes the velocity that strains the particles.
template <int D>
void constrainProjection(State<D>& state, const NodeConstraint<D>& constraint);

} // namespace Rhegma
