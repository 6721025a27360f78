#pragma once
/// What acts on the motion of nodes in addition to the forces of stresses and loads.

#include "base/Types.hpp"
#include "state/NodeConstraint.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace Rhegma
{

template <int D>
struct State;
template <int D>
class StepForce;

/// Rows of the nodes that take part in substeps: those that move in substeps come first.
struct NodeSlots
{
  View<int*> of; ///< of each node, or -1
  int inner = 0; ///< number of nodes that move in substeps
  KOKKOS_INLINE_FUNCTION bool moves(int node) const { return inner > 0 && of(node) >= 0 && of(node) < inner; }
};

/// The substeps of this step, for effects that compute work; empty without sub-cycling.
struct Substeps
{
  NodeSlots nodes;     ///< nodes that move in substeps or next to such nodes
  double length = 0.0; ///< of the shortest ones [s]
  /// Impulses on subcycled nodes except those at the start of the step, times the velocity that the nodes had
  /// before the step [J]. Nodes held by supports are left out.
  double lateWork = 0.0;
};

/// A displacement-dependent nodal force (contact, front springs), for effects that move nodes in substeps.
/// Their values at the start of the step are part of the nodal force before the solve. `force`,
/// `displacement` and `velocity` have a row a slot [N, m, m/s].
template <int D>
struct DisplacementDependentForce
{
  using Values = View<double* [D]>; ///< a row a slot
  /// Adds the part that is constant over the step, with its value at the start of the step: it acts on nodes
  /// that do not move in substeps.
  std::function<void(const State<D>&, const NodeSlots&, const Values& force)> frozen;
  /// Adds the change of the part that depends on displacement and velocity.
  std::function<void(const State<D>&, const NodeSlots&, const Values& displacement, const Values& velocity,
                     const Values& force)>
      change;
  /// Records the work that the present force does at a velocity over a duration [s]. Called twice a substep,
  /// with the velocities before and after it, each time for half of its length: the kinetic energy changes by
  /// that work.
  using Work =
      std::function<void(const State<D>&, const NodeSlots&, const Values& velocity, double duration)>;
  Work work; ///< empty where the force keeps no record of its work
};

/// The mass of subcycled nodes where a mass matrix couples them. Values have a row a slot [N, m].
template <int D>
struct CoupledSlots
{
  using Values = View<double* [D]>; ///< a row a slot
  /// Once a step, when nodes have their masses. \param held not 0 where a support holds a slot along an axis
  std::function<void(const State<D>&, const NodeSlots&, const View<int* [D]>& held)> begin;
  /// Solves M x = right for coupled nodes that move in substeps. \param x on entry given on all other slots
  /// and, where `supports` is set, where these hold
  std::function<void(const Values& right, const Values& x, bool supports)> solve;
};

/// Prescribed motion, displacement-dependent forces, coupled masses and added inertia of nodes.
template <int D>
struct NodalMotion
{
  std::vector<NodeConstraint<D>> constraints; ///< prescribed motion at the end of this step
  View<double*> coupledReaction; ///< impulse that holds each unknown (row, axis) of coupled nodes [N s]
  View<int*> coupledRow;         ///< of each node, -1 where its mass is lumped; empty where all masses are
  std::vector<DisplacementDependentForce<D>> displacementDependentForces; ///< of effects that have any
  std::vector<std::shared_ptr<StepForce<D>>> stepForces; ///< the same in equilibrium (StepForce.hpp)
  CoupledSlots<D> coupledSlots;                          ///< empty where all masses are lumped
  Substeps substeps;                                     ///< of this step
  /// Inertia added to the relative motion of the two fields of each lattice node [kg] (slowRelativeMotion);
  /// empty where there is none.
  View<double*> relativeInertia;
};

} // namespace Rhegma
