/// Right sides and first guesses of the velocities and accelerations of coupled nodes.

#include "base/SmallLoops.hpp"
#include "mass_matrix/NodalSolve.hpp"

namespace Rhegma::mass_matrix
{

namespace
{

/// Velocity before the forces, and acceleration, of the lumped mass.
template <int D>
void guessFromRowSums(const State<D>& state, const MassSystem<D>& system,
                      const BorrowedView<double* [D]>& velocity,
                      const BorrowedView<double* [D]>& acceleration)
{
  const MassSystem<D> s = system;
  const NodalFieldRow<D> guessRow = state.mesh.nodalFields.rowsOf(state.mesh.nodes);
  const auto sums = state.mesh.nodes.sums;
  parallelForSmall(
      "rhegma::mass::guessFromRowSums", system.first, system.last, KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row), m = guessRow(n);
        for (int d = 0; d < D; ++d)
        {
          velocity(m, d) = sums(n, Nodes<D>::momentumAt + d) / s.lumped(row);
          acceleration(m, d) = sums(n, Nodes<D>::forceAt + d) / s.lumped(row);
        }
      });
}

/// Impulses of the supports: M a less the applied forces.
template <int D>
void findReaction(State<D>& state, const MassSystem<D>& system, const View<double*>& acceleration,
                  const View<double*>& image, const View<double*>& right, const View<double*>& free)
{
  const MassSystem<D> s = system;
  const double dt = state.clock.dt;
  const std::size_t unknowns = static_cast<std::size_t>(system.rowCapacity) * D;
  if (state.motion.coupledReaction.extent(0) < unknowns)
    state.motion.coupledReaction = View<double*>("rhegma::massReaction", unknowns);
  const View<double*> reaction = state.motion.coupledReaction;
  multiplyWhole<D>(state, system, acceleration.data(), image.data());
  parallelForSmall(
      "rhegma::mass::reaction", system.first, system.last, KOKKOS_LAMBDA(const int row) {
        for (int d = 0; d < D; ++d)
        {
          const int i = row * width<D> + d;
          reaction(row * D + d) = free(i) == 0.0 && s.coupled(row) ? dt * (image(i) - right(i)) : 0.0;
        }
      });
}

} // namespace

template <int D>
void NodalSolve<D>::solveMotion(State<D>& state, const MassSystem<D>& system)
{
  const MassSystem<D> s = system;
  const Nodes<D> nodes = state.mesh.nodes;
  const View<double*> right = right_, prescribed = prescribed_, velocity = velocity_,
                      acceleration = acceleration_, heldVelocity = heldVelocity_, free = freeOnly_;
  const auto lastVelocity = state.mesh.nodalFields.template real<D>(velocityGuess);
  const auto last = state.mesh.nodalFields.template real<D>(accelerationGuess);
  const NodalFieldRow<D> guessRow = state.mesh.nodalFields.rowsOf(nodes);
  const bool masked = masked_;
  const double dt = state.clock.dt;

  // Velocity before the forces, without supports, as it belongs to the particles: with a fraction of PIC they
  // take it over, and supports change it to theirs. Otherwise only the work and points that move with nodes
  // use it: the guess from the last step, improved by the polynomial alone, has an error of 1e-4 or less.
  // Where cells have changed there is no such guess.
  const Accuracy accuracy =
      masked || renewed_ || state.method.picFraction > 0.0 ? Accuracy::Solved : Accuracy::Near;
  if (renewed_)
    guessFromRowSums(state, system, lastVelocity, last);
  parallelForSmall(
      "rhegma::mass::momentum", system.first, system.last, KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row);
        for (int d = 0; d < D; ++d)
        {
          right(row * width<D> + d) = nodes.sums(n, Nodes<D>::momentumAt + d);
          velocity(row * width<D> + d) = lastVelocity(guessRow(n), d);
        }
      });
  solve(state, system, false, velocity, "velocity of the nodes", accuracy);

  parallelForSmall(
      "rhegma::mass::force", system.first, system.last, KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row);
        for (int d = 0; d < D; ++d)
        {
          const int i = row * width<D> + d;
          right(i) = nodes.sums(n, Nodes<D>::forceAt + d);
          acceleration(i) = last(guessRow(n), d);
          if (masked && free(i) == 0.0)
            prescribed(i) = (heldVelocity(i) - velocity(i)) / dt;
        }
      });
  solve(state, system, true, acceleration, "acceleration of the nodes", Accuracy::Solved);

  if (masked)
    findReaction(state, system, acceleration, image_, right, free);
  parallelForSmall(
      "rhegma::mass::motion", system.first, system.last, KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row);
        for (int d = 0; d < D && s.coupled(row); ++d)
        {
          const int i = row * width<D> + d;
          nodes.motion(n, d) = velocity(i) + dt * acceleration(i);
          nodes.motion(n, Nodes<D>::accelerationAt + d) = acceleration(i);
          lastVelocity(guessRow(n), d) = velocity(i);
          last(guessRow(n), d) = acceleration(i);
        }
      });
}

template <int D>
void NodalSolve<D>::solveProjection(State<D>& state, const MassSystem<D>& system)
{
  const MassSystem<D> s = system;
  const Nodes<D> nodes = state.mesh.nodes;
  const View<double*> right = right_, prescribed = prescribed_, velocity = velocity_;
  const auto lastVelocity = state.mesh.nodalFields.template real<D>(velocityGuess);
  const NodalFieldRow<D> guessRow = state.mesh.nodalFields.rowsOf(nodes);
  const bool masked = masked_;
  const bool afterSolve = projectsLast(state.method.scheme) && !state.clock.strainPass.before;
  parallelForSmall(
      "rhegma::mass::projected", system.first, system.last, KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row);
        for (int d = 0; d < D; ++d)
        {
          const int i = row * width<D> + d;
          right(i) = s.lumped(row) * nodes.projection(n, d);
          velocity(i) = afterSolve ? nodes.motion(n, d) : lastVelocity(guessRow(n), d);
          // Supports have set the velocity before the forces to theirs at the start of the step.
          if (masked)
            prescribed(i) = nodes.projection(n, d);
        }
      });
  solve(state, system, true, velocity, "velocity that strains the particles", Accuracy::Solved);
  // In the next step of MUSL, or later in this one of USF, the nodes move similarly, so that this is a good
  // guess.
  parallelForSmall(
      "rhegma::mass::projection", system.first, system.last, KOKKOS_LAMBDA(const int row) {
        for (int d = 0; d < D && s.coupled(row); ++d)
          nodes.projection(s.nodeOf(row), d) = lastVelocity(guessRow(s.nodeOf(row)), d) =
              velocity(row * width<D> + d);
      });
}

template void NodalSolve<2>::solveMotion(State<2>&, const MassSystem<2>&);
template void NodalSolve<3>::solveMotion(State<3>&, const MassSystem<3>&);
template void NodalSolve<2>::solveProjection(State<2>&, const MassSystem<2>&);
template void NodalSolve<3>::solveProjection(State<3>&, const MassSystem<3>&);

} // namespace Rhegma::mass_matrix
