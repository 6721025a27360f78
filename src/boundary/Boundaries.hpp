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

/// Sets the velocity of nodes inside or outside of a box, axis by axis.
template <int D>
struct NodeConstraint
{
  Vector<D> lower, upper;  ///< the box, both corners inside [m]
  bool outside = false;    ///< nodes beyond the box and on its rim instead
  bool holds[D];           ///< axes that are prescribed
  Vector<D> value;         ///< velocity along them now [m/s]
  View<double* [D]> field; ///< velocity of each lattice node, to be multiplied by `factor`; empty: `value`
  double factor = 1.0;

  KOKKOS_INLINE_FUNCTION bool appliesAt(const Vector<D>& x) const
  {
    bool in = true;
    for (int d = 0; d < D; ++d)
      in = in && x[d] >= lower[d] && x[d] <= upper[d];
    return in != outside;
  }
  KOKKOS_INLINE_FUNCTION double at(int latticeNode, int axis) const
  {
    return field.extent(0) > 0 ? factor * field(latticeNode, axis) : value[axis];
  }
};

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
