#include "mass_matrix/NodalSolve.hpp"

#include <algorithm>
#include <sstream>

namespace Rhegma::mass_matrix
{

namespace
{

Kokkos::RangePolicy<ExecSpace> range(int n) { return Kokkos::RangePolicy<ExecSpace>(0, n); }

template <class Value>
BorrowedView<const double*> readOnly(const View<Value*>& view)
{
  return BorrowedView<const double*>(view.data(), view.extent(0));
}

BorrowedView<double*> borrow(const View<double*>& view)
{
  return BorrowedView<double*>(view.data(), view.extent(0));
}

} // namespace

template <int D>
void NodalSolve<D>::reserve(int unknowns)
{
  if (room_ >= unknowns)
    return;
  room_ = unknowns + unknowns / 4 + 16;
  const auto make = [this](const std::string& name) { return View<double*>(name, room_); };
  heldRoom_ = View<int*>("rhegma::massHeld", room_);
  heldVelocity_ = make("rhegma::massHeldVelocity");
  inverseDiagonal_ = make("rhegma::massInverseDiagonal");
  right_ = make("rhegma::massRight");
  prescribed_ = make("rhegma::massPrescribed");
  residual_ = make("rhegma::massResidual");
  correction_ = make("rhegma::massCorrection");
  velocity_ = make("rhegma::massVelocity");
  acceleration_ = make("rhegma::massAcceleration");
}

template <int D>
void NodalSolve<D>::begin(const State<D>& state, const MassSystem<D>& system)
{
  reserve(system.numRows * D);
  if (lastAcceleration_.extent(0) < state.nodes.sums.extent(0))
    lastAcceleration_ = View<double* [D]>("rhegma::massLastAcceleration", state.nodes.sums.extent(0));
  held_ = state.constraints.empty() ? View<int*>() : heldRoom_;
  for (int d = 0; d < D; ++d)
    heldAxis_[d] = std::any_of(state.constraints.begin(), state.constraints.end(),
                               [d](const NodeConstraint<D>& constraint) { return constraint.holds[d]; });
  const MassSystem<D> s = system;
  const Nodes<D> nodes = state.nodes;
  const View<int*> held = heldRoom_;
  const View<double*> value = heldVelocity_, inverse = inverseDiagonal_;
  Kokkos::parallel_for(
      "rhegma::mass::begin", range(system.numRows), KOKKOS_LAMBDA(const int row) {
        const double mass = s.lumped(row);
        for (int d = 0; d < D; ++d)
        {
          held(row * D + d) = 0;
          inverse(row * D + d) = mass > 0.0 ? 1.0 / mass : 0.0;
        }
      });
  for (const NodeConstraint<D>& constraint : state.constraints)
  {
    const NodeConstraint<D> c = constraint;
    const Grid<D> grid = state.grid;
    Kokkos::parallel_for(
        "rhegma::mass::hold", range(system.numRows), KOKKOS_LAMBDA(const int row) {
          const int lattice = latticeNode(nodes, s.nodeOf(row));
          if (!c.appliesAt(grid.nodePosition(lattice)))
            return;
          for (int d = 0; d < D; ++d)
            if (c.holds[d])
            {
              held(row * D + d) = 1;
              value(row * D + d) = c.at(lattice, d);
            }
        });
  }
}

template <int D>
void NodalSolve<D>::applyMass(const State<D>& state, const MassSystem<D>& system,
                              const BorrowedView<const double*>& x, const BorrowedView<double*>& y) const
{
  multiply<D, D>(state, system, x, y);
  const MassSystem<D> s = system;
  Kokkos::parallel_for(
      "rhegma::mass::addLumped", range(system.numRows * D),
      KOKKOS_LAMBDA(const int i) { y(i) += s.lumped(i / D) * x(i); });
}

template <int D>
void NodalSolve<D>::matchSums(const MassSystem<D>& system, int axis, const View<double*>& residual,
                              const View<double*>& x)
{
  const MassSystem<D> s = system;
  double left = 0.0, mass = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::mass::sums", range(system.numRows),
      KOKKOS_LAMBDA(const int row, double& sum, double& total) {
        sum += residual(row * D + axis);
        total += s.lumped(row);
      },
      left, mass);
  const double shift = left / mass;
  Kokkos::parallel_for(
      "rhegma::mass::shift", range(system.numRows), KOKKOS_LAMBDA(const int row) {
        x(row * D + axis) += shift;
        residual(row * D + axis) -= shift * s.lumped(row); // M 1 = L 1
      });
}

template <int D>
void NodalSolve<D>::solve(State<D>& state, const MassSystem<D>& system, const View<int*>& held,
                          const View<double*>& x, const std::string& what)
{
  const int n = system.numRows * D;
  const bool masked = held.extent(0) > 0;
  const View<double*> right = right_, prescribed = prescribed_, residual = residual_,
                      correction = correction_;
  if (masked)
    Kokkos::parallel_for(
        "rhegma::mass::prescribe", range(n), KOKKOS_LAMBDA(const int i) {
          if (held(i) != 0)
            x(i) = prescribed(i);
        });
  applyMass(state, system, readOnly(x), borrow(residual));
  double scale = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::mass::residual", range(n),
      KOKKOS_LAMBDA(const int i, double& sum) {
        const bool free = !masked || held(i) == 0;
        residual(i) = free ? right(i) - residual(i) : 0.0;
        sum += free ? right(i) * right(i) : 0.0;
      },
      scale);
  scale = std::sqrt(scale);
  // Axes along which nothing is held keep their momentum; without a mask all do.
  for (int d = 0; d < D; ++d)
    if (!masked || !heldAxis_[d])
      matchSums(system, d, residual, x);
  // Where supports alone move a body at rest, the right side of the free nodes is zero.
  scale = std::max(scale, norm2(residual, n));

  const auto apply = [&](const BorrowedView<const double*>& from, const BorrowedView<double*>& to)
  {
    applyMass(state, system, from, to);
    if (masked)
      Kokkos::parallel_for(
          "rhegma::mass::mask", range(n), KOKKOS_LAMBDA(const int i) {
            if (held(i) != 0)
              to(i) = 0.0;
          });
  };
  const SolveResult result = gradients_.solve(n, apply, inverseDiagonal_, residual, scale, correction);
  Kokkos::parallel_for(
      "rhegma::mass::correct", range(n), KOKKOS_LAMBDA(const int i) { x(i) += correction(i); });

  ++count_.solves;
  count_.iterations += result.iterations;
  count_.mostIterations = std::max(count_.mostIterations, result.iterations);
  count_.worstResidual = std::max(count_.worstResidual, result.residual);
  if (!result.converged && state.trouble.empty())
  {
    std::ostringstream reason;
    reason << "the mass matrix could not be solved for the " << what << ": after " << result.iterations
           << " iterations the residual is still " << result.residual
           << " of the right side (raise Mass Matrix > Maximum Iterations, Solver Tolerance or Lumped Share)";
    state.trouble = reason.str();
  }
}

template <int D>
void NodalSolve<D>::solveMotion(State<D>& state, const MassSystem<D>& system)
{
  const int rows = system.numRows;
  const MassSystem<D> s = system;
  const Nodes<D> nodes = state.nodes;
  const View<double*> right = right_, prescribed = prescribed_, velocity = velocity_,
                      acceleration = acceleration_, heldVelocity = heldVelocity_, image = residual_;
  const View<double* [D]> last = lastAcceleration_;
  const View<int*> held = held_;
  const bool masked = held.extent(0) > 0;
  const double dt = state.dt;

  // Velocity before the forces, held by nothing: it belongs to the particles. The last projection is near it.
  Kokkos::parallel_for(
      "rhegma::mass::momentum", range(rows), KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row);
        for (int d = 0; d < D; ++d)
        {
          right(row * D + d) = nodes.sums(n, Nodes<D>::momentumAt + d);
          velocity(row * D + d) = nodes.projection(n, d);
        }
      });
  solve(state, system, View<int*>(), velocity, "velocity of the nodes");

  Kokkos::parallel_for(
      "rhegma::mass::force", range(rows), KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row);
        for (int d = 0; d < D; ++d)
        {
          const int i = row * D + d;
          right(i) = nodes.sums(n, Nodes<D>::forceAt + d);
          acceleration(i) = last(n, d);
          if (masked)
            prescribed(i) = held(i) != 0 ? (heldVelocity(i) - velocity(i)) / dt : 0.0;
        }
      });
  solve(state, system, held, acceleration, "acceleration of the nodes");

  if (masked)
  {
    // Impulses of the supports: what M a takes beyond the forces that are there.
    if (state.coupledReaction.extent(0) < image.extent(0))
      state.coupledReaction = View<double*>("rhegma::massReaction", image.extent(0));
    const View<double*> reaction = state.coupledReaction;
    applyMass(state, system, readOnly(acceleration), borrow(image));
    Kokkos::parallel_for(
        "rhegma::mass::reaction", range(rows * D),
        KOKKOS_LAMBDA(const int i) { reaction(i) = held(i) != 0 ? dt * (image(i) - right(i)) : 0.0; });
  }
  Kokkos::parallel_for(
      "rhegma::mass::motion", range(rows), KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row);
        for (int d = 0; d < D; ++d)
        {
          const int i = row * D + d;
          nodes.motion(n, d) = velocity(i) + dt * acceleration(i);
          nodes.motion(n, Nodes<D>::accelerationAt + d) = acceleration(i);
          last(n, d) = acceleration(i);
        }
      });
}

template <int D>
void NodalSolve<D>::solveProjection(State<D>& state, const MassSystem<D>& system)
{
  const MassSystem<D> s = system;
  const Nodes<D> nodes = state.nodes;
  const View<double*> right = right_, prescribed = prescribed_, velocity = velocity_,
                      heldVelocity = heldVelocity_;
  const View<int*> held = held_;
  const bool masked = held.extent(0) > 0;
  const bool afterSolve = state.scheme == UpdateScheme::Musl;
  Kokkos::parallel_for(
      "rhegma::mass::projected", range(system.numRows), KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row);
        for (int d = 0; d < D; ++d)
        {
          const int i = row * D + d;
          right(i) = s.lumped(row) * nodes.projection(n, d);
          velocity(i) = afterSolve ? nodes.motion(n, d) : nodes.projection(n, d);
          if (masked)
            prescribed(i) = heldVelocity(i);
        }
      });
  solve(state, system, held, velocity, "velocity that strains the particles");
  Kokkos::parallel_for(
      "rhegma::mass::projection", range(system.numRows), KOKKOS_LAMBDA(const int row) {
        for (int d = 0; d < D; ++d)
          nodes.projection(s.nodeOf(row), d) = velocity(row * D + d);
      });
}

template class NodalSolve<2>;
template class NodalSolve<3>;

} // namespace Rhegma::mass_matrix
