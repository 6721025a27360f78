/// Right sides and first guesses of the velocities and accelerations of coupled nodes.

#include "base/FewItems.hpp"
#include "mass_matrix/NodalSolve.hpp"

namespace Rhegma::mass_matrix
{

namespace
{

template <int D>
constexpr int width = MassSystem<D>::width;

/// Where what a node or a second field has is remembered: second fields by their nodes, as their own numbers
/// are others after every sort, and on every rank.
template <int D>
KOKKOS_INLINE_FUNCTION int memoryOf(const Nodes<D>& nodes, int node)
{
  return node < nodes.numLattice ? node : nodes.numLattice + latticeNode(nodes, node);
}

/// Velocity before the forces, and acceleration, of the lumped mass.
template <int D>
void guessFromRowSums(const State<D>& state, const MassSystem<D>& system, const View<double* [D]>& velocity,
                      const View<double* [D]>& acceleration)
{
  const MassSystem<D> s = system;
  const Nodes<D> nodes = state.mesh.nodes;
  const auto sums = state.mesh.nodes.sums;
  forFew(
      "rhegma::mass::guessFromRowSums", system.first, system.last, KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row), m = memoryOf(nodes, n);
        for (int d = 0; d < D; ++d)
        {
          velocity(m, d) = sums(n, Nodes<D>::momentumAt + d) / s.lumped(row);
          acceleration(m, d) = sums(n, Nodes<D>::forceAt + d) / s.lumped(row);
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
                      acceleration = acceleration_, heldVelocity = heldVelocity_, image = image_,
                      free = freeOnly_;
  const View<double*[D]> lastVelocity = lastVelocity_, last = lastAcceleration_;
  const bool masked = masked_;
  const double dt = state.clock.dt;

  // Velocity before the forces, held by nothing: it belongs to the particles. They take it over where there
  // is some PIC, and supports change it to theirs. Else what reads it are accounts of work and points that
  // ride on nodes: the last step's, brought nearer by the polynomial alone, leaves 1e-4 of it or less.
  // Where cells have changed there is no such guess.
  const Accuracy accuracy =
      masked || renewed_ || state.method.picFraction > 0.0 ? Accuracy::Solved : Accuracy::Near;
  if (renewed_ && state.mesh.subdomain)
  {
    // Where the lattice was divided anew, what nodes have is others'; a node that is barely touched would
    // keep it, as solves don't feel it.
    Kokkos::deep_copy(lastVelocity, 0.0);
    Kokkos::deep_copy(last, 0.0);
  }
  else if (renewed_)
    guessFromRowSums(state, system, lastVelocity, last);
  forFew(
      "rhegma::mass::momentum", system.first, system.last, KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row);
        for (int d = 0; d < D; ++d)
        {
          right(row * width<D> + d) = nodes.sums(n, Nodes<D>::momentumAt + d);
          velocity(row * width<D> + d) = lastVelocity(memoryOf(nodes, n), d);
        }
      });
  solve(state, system, false, velocity, "velocity of the nodes", accuracy);

  forFew(
      "rhegma::mass::force", system.first, system.last, KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row);
        for (int d = 0; d < D; ++d)
        {
          const int i = row * width<D> + d;
          right(i) = nodes.sums(n, Nodes<D>::forceAt + d);
          acceleration(i) = last(memoryOf(nodes, n), d);
          if (masked && free(i) == 0.0)
            prescribed(i) = (heldVelocity(i) - velocity(i)) / dt;
        }
      });
  solve(state, system, true, acceleration, "acceleration of the nodes", Accuracy::Solved);

  if (masked)
  {
    // Impulses of the supports: what M a takes beyond the forces that are there.
    const std::size_t unknowns = static_cast<std::size_t>(system.room) * D;
    if (state.motion.coupledReaction.extent(0) < unknowns)
      state.motion.coupledReaction = View<double*>("rhegma::massReaction", unknowns);
    const View<double*> reaction = state.motion.coupledReaction;
    multiplyWhole<D>(state, system, acceleration.data(), image.data());
    forFew(
        "rhegma::mass::reaction", system.first, system.last, KOKKOS_LAMBDA(const int row) {
          for (int d = 0; d < D; ++d)
          {
            const int i = row * width<D> + d;
            reaction(row * D + d) = free(i) == 0.0 && s.coupled(row) ? dt * (image(i) - right(i)) : 0.0;
          }
        });
  }
  forFew(
      "rhegma::mass::motion", system.first, system.last, KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row);
        for (int d = 0; d < D && s.coupled(row); ++d)
        {
          const int i = row * width<D> + d;
          nodes.motion(n, d) = velocity(i) + dt * acceleration(i);
          nodes.motion(n, Nodes<D>::accelerationAt + d) = acceleration(i);
          lastVelocity(memoryOf(nodes, n), d) = velocity(i);
          last(memoryOf(nodes, n), d) = acceleration(i);
        }
      });
}

template <int D>
void NodalSolve<D>::solveProjection(State<D>& state, const MassSystem<D>& system)
{
  const MassSystem<D> s = system;
  const Nodes<D> nodes = state.mesh.nodes;
  const View<double*> right = right_, prescribed = prescribed_, velocity = velocity_;
  const View<double* [D]> lastVelocity = lastVelocity_;
  const bool masked = masked_;
  const bool afterSolve = projectsLast(state.method.scheme) && !state.clock.strainPass.before;
  forFew(
      "rhegma::mass::projected", system.first, system.last, KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row);
        for (int d = 0; d < D; ++d)
        {
          const int i = row * width<D> + d;
          right(i) = s.lumped(row) * nodes.projection(n, d);
          velocity(i) = afterSolve ? nodes.motion(n, d) : lastVelocity(memoryOf(nodes, n), d);
          // Supports have set it: before the forces to their velocity at the start of the step.
          if (masked)
            prescribed(i) = nodes.projection(n, d);
        }
      });
  solve(state, system, true, velocity, "velocity that strains the particles", Accuracy::Solved);
  // In the next step of MUSL, or later in this one of USF, the nodes move about as they do here.
  forFew(
      "rhegma::mass::projection", system.first, system.last, KOKKOS_LAMBDA(const int row) {
        for (int d = 0; d < D && s.coupled(row); ++d)
          nodes.projection(s.nodeOf(row), d) = lastVelocity(memoryOf(nodes, s.nodeOf(row)), d) =
              velocity(row * width<D> + d);
      });
}

template void NodalSolve<2>::solveMotion(State<2>&, const MassSystem<2>&);
template void NodalSolve<3>::solveMotion(State<3>&, const MassSystem<3>&);
template void NodalSolve<2>::solveProjection(State<2>&, const MassSystem<2>&);
template void NodalSolve<3>::solveProjection(State<3>&, const MassSystem<3>&);

} // namespace Rhegma::mass_matrix
