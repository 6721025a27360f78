#pragma once
/// The velocity for the work of loads.

#include "boundary/HeldMarks.hpp"
#include "plan/LoadOverStep.hpp"
#include "state/FaceVelocity.hpp"

namespace Rhegma
{

/// As WorkVelocity [m/s], but for nodes that move in substeps the mean over the substeps, in each of which
/// the load is the same.
template <int D>
struct LoadVelocity
{
  WorkVelocity<D> work; ///< of nodes that take the whole step

  /// \param state after its solve; with MUSL and USAVG after its projection
  explicit LoadVelocity(const State<D>& state) : work(state) {}

  /// Of a node along an axis [m/s].
  KOKKOS_INLINE_FUNCTION double operator()(int node, int axis) const
  {
    const MeanVelocity<D>& mean = work.face.mean;
    return mean.subcycled.moves(node) ? mean(node, axis) : work(node, axis);
  }
};

/// Nodes and axes that supports hold in this step of equilibrium. \param held gets 1 there
template <int D>
void markHeld(const State<D>& state, View<char**>& held)
{
  clearMarks(state, held);
  const Nodes<D> nodes = state.mesh.nodes;
  const NodePositions<D> positions = nodePositions(state);
  const View<char**> marks = held;
  for (const NodeConstraint<D>& constraint : state.motion.constraints)
    Kokkos::parallel_for(
        "rhegma::markHeld", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()), KOKKOS_LAMBDA(const int i) {
          const int n = activeNode(nodes, i);
          if (constraint.appliesAt(positions(latticeNode(nodes, n))))
            for (int d = 0; d < D; ++d)
              if (constraint.holds[d])
                marks(n, d) = 1;
        });
}

/// LoadVelocity where supports hold a node along an axis, else zero [m/s].
template <int D>
struct HeldLoadVelocity
{
  LoadVelocity<D> all;
  View<char**> held;

  explicit HeldLoadVelocity(const State<D>& state) : all(state) { markHeld(state, held); }

  KOKKOS_INLINE_FUNCTION double operator()(int node, int axis) const
  {
    return held(node, axis) != 0 ? all(node, axis) : 0.0;
  }
};

/// Adds the work of a load over the step to the external work. A solution for equilibrium takes loads as they
/// are at the end of the step, so that the work of its reactions contains that of this value on held nodes,
/// with the opposite sign, where the mean over the step does work: the difference is added, too.
/// \param work function of a velocity and a factor of the load [J] \param value of its function of time
template <int D, class Work>
void addWorkOfLoad(State<D>& state, const LoadOverStep& value, const Work& work)
{
  state.energy.externalWork += work(LoadVelocity<D>(state), value.works);
  if (state.method.equilibrium() && value.acts != value.works && !state.motion.constraints.empty())
    state.energy.externalWork += work(HeldLoadVelocity<D>(state), value.acts - value.works);
}

} // namespace Rhegma
