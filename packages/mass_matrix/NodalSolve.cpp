#include "mass_matrix/NodalSolve.hpp"

#include <algorithm>
#include <sstream>

namespace Rhegma::mass_matrix
{

namespace
{

/// Products with the matrix in one application of the polynomial. On a beam of 5,400 nodes and two threads
/// more of them cost as much as the iterations they spare, fewer leave Belos' own vectors in front.
constexpr int polynomialProducts = 4;

template <int D>
constexpr int width = MassSystem<D>::width;

template <int D>
Kokkos::RangePolicy<ExecSpace> rows(const MassSystem<D>& system)
{
  return Kokkos::RangePolicy<ExecSpace>(system.first, system.last);
}

/// residual = right - M x in free rows, 0 in held ones. Sums the squares of both and the residual along each
/// axis in one pass.
template <int D, int Reach>
struct Residual
{
  using value_type = double[];
  using size_type = int;
  using execution_space = ExecSpace;

  int value_count = 2 + D;
  MassSystem<D> system;
  View<double*> right, x, inverse, residual;

  KOKKOS_INLINE_FUNCTION void operator()(const int row, double* sum) const
  {
    const Pack<width<D>> image = rowTimes<D, Reach>(system, row, x.data());
    for (int d = 0; d < D; ++d)
    {
      const int i = width<D> * row + d;
      const bool free = inverse(i) != 0.0;
      const double b = free ? right(i) : 0.0, r = free ? b - image[d] : 0.0;
      residual(i) = r;
      sum[0] += b * b;
      sum[1] += r * r;
      sum[2 + d] += r;
    }
  }
};

} // namespace

template <int D>
NodalSolve<D>::NodalSolve(double tolerance, int maximumIterations, double lumpedShare)
    : gradients_(tolerance, maximumIterations), chebyshev_(lumpedShare, polynomialProducts)
{
}

template <int D>
void NodalSolve<D>::reserve(const State<D>& state, const MassSystem<D>& system)
{
  const std::size_t n = static_cast<std::size_t>(system.room) * width<D>;
  if (right_.extent(0) != n)
  {
    const auto make = [n](const std::string& name) { return View<double*>(name, n); };
    inverse_ = make("rhegma::massInverse");
    freeOnly_ = make("rhegma::massFree");
    heldVelocity_ = make("rhegma::massHeldVelocity");
    right_ = make("rhegma::massRight");
    prescribed_ = make("rhegma::massPrescribed");
    residual_ = make("rhegma::massResidual");
    velocity_ = make("rhegma::massVelocity");
    acceleration_ = make("rhegma::massAcceleration");
    gradients_.resize(static_cast<int>(n));
  }
  if (lastAcceleration_.extent(0) < state.nodes.sums.extent(0))
  {
    lastVelocity_ = View<double* [D]>("rhegma::massLastVelocity", state.nodes.sums.extent(0));
    lastAcceleration_ = View<double* [D]>("rhegma::massLastAcceleration", state.nodes.sums.extent(0));
  }
}

template <int D>
void NodalSolve<D>::begin(const State<D>& state, const MassSystem<D>& system)
{
  reserve(state, system);
  holdRows(state, system);
}

template <int D>
void NodalSolve<D>::holdRows(const State<D>& state, const MassSystem<D>& system)
{
  masked_ = !state.constraints.empty();
  for (int d = 0; d < D; ++d)
    heldAxis_[d] = std::any_of(state.constraints.begin(), state.constraints.end(),
                               [d](const NodeConstraint<D>& constraint) { return constraint.holds[d]; });
  const MassSystem<D> s = system;
  const Nodes<D> nodes = state.nodes;
  const View<double*> inverse = inverse_, free = freeOnly_, value = heldVelocity_, right = right_,
                      residual = residual_, velocity = velocity_, acceleration = acceleration_;
  // Vectors are zero outside of the rows and in unused numbers of them.
  Kokkos::parallel_for(
      "rhegma::mass::begin", Kokkos::RangePolicy<ExecSpace>(0, s.room), KOKKOS_LAMBDA(const int row) {
        const bool inside = row >= s.first && row < s.last;
        for (int d = 0; d < width<D>; ++d)
        {
          const int i = width<D> * row + d;
          inverse(i) = free(i) = inside && d < D && s.coupled(row) ? 1.0 / s.lumped(row) : 0.0;
          if (!inside || !s.coupled(row))
            right(i) = residual(i) = velocity(i) = acceleration(i) = 0.0;
        }
      });
  for (const NodeConstraint<D>& constraint : state.constraints)
  {
    const NodeConstraint<D> c = constraint;
    const Grid<D> grid = state.grid;
    Kokkos::parallel_for(
        "rhegma::mass::hold", rows(system), KOKKOS_LAMBDA(const int row) {
          const int lattice = latticeNode(nodes, s.nodeOf(row));
          if (!c.appliesAt(grid.nodePosition(lattice)))
            return;
          for (int d = 0; d < D; ++d)
            if (c.holds[d] && s.coupled(row))
            {
              free(width<D> * row + d) = 0.0;
              value(width<D> * row + d) = c.at(lattice, d);
            }
        });
  }
}

template <int D>
void NodalSolve<D>::record(State<D>& state, const SolveResult& result, double scale, const std::string& what)
{
  ++count_.solves;
  count_.iterations += result.iterations;
  count_.mostIterations = std::max(count_.mostIterations, result.iterations);
  count_.worstResidual = std::max(count_.worstResidual, result.residual);
  if (result.converged || !state.trouble.empty())
    return;
  std::ostringstream reason;
  reason << "the mass matrix could not be solved for the " << what << ": after " << result.iterations
         << " iterations the residual is still " << result.residual << " of the right side"
         << (std::isfinite(scale) ? "" : ", which is not a number")
         << " (raise Mass Matrix > Maximum Iterations, Solver Tolerance or Lumped Share)";
  state.trouble = reason.str();
}

template <int D>
void NodalSolve<D>::solve(State<D>& state, const MassSystem<D>& system, bool held, const View<double*>& x,
                          const std::string& what)
{
  const bool masked = held && masked_;
  const View<double*> inverse = masked ? freeOnly_ : inverse_, residual = residual_, prescribed = prescribed_;
  const MassSystem<D> s = system;
  if (masked)
    Kokkos::parallel_for(
        "rhegma::mass::prescribe", rows(system), KOKKOS_LAMBDA(const int row) {
          for (int i = width<D> * row; i < width<D> * row + D; ++i)
            if (inverse(i) == 0.0 && s.coupled(row))
              x(i) = prescribed(i);
        });
  double sum[2 + D] = {};
  withReach(system,
            [&](auto reach)
            {
              Residual<D, decltype(reach)::value> work;
              work.system = system;
              work.right = right_;
              work.x = x;
              work.inverse = inverse;
              work.residual = residual;
              Kokkos::parallel_reduce("rhegma::mass::residual", rows(system), work, sum);
            });
  // Where supports alone move a body at rest, the right side of the free nodes is zero.
  const double scale = std::sqrt(std::max(sum[0], sum[1]));
  if (scale == 0.0)
    return record(state, {true, 0, 0.0}, scale, what);
  // A shift of x by a constant leaves a residual without a sum, as M 1 = L 1. Axes along which nothing is
  // held keep their momentum so; without a mask all do.
  Vector<D> shift{};
  for (int d = 0; d < D; ++d)
    shift[d] = masked && heldAxis_[d] ? 0.0 : sum[2 + d] / system.coupledMass;
  const BorrowedView<double*> right = gradients_.right();
  double square = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::mass::shift", Kokkos::RangePolicy<ExecSpace>(0, s.room),
      KOKKOS_LAMBDA(const int row, double& sum2) {
        const bool inside = row >= s.first && row < s.last;
        for (int d = 0; d < width<D>; ++d)
        {
          const int i = width<D> * row + d;
          right(i) = 0.0;
          if (!inside || d >= D || !s.coupled(row))
            continue;
          x(i) += shift[d];
          right(i) = (residual(i) - shift[d] * s.lumped(row)) / scale;
          sum2 += right(i) * right(i);
        }
      },
      square);
  const double norm = std::sqrt(square);
  if (norm <= gradients_.tolerance() || !std::isfinite(norm))
    return record(state, {norm <= gradients_.tolerance(), 0, norm}, scale, what);

  const double* const mask = masked ? inverse.data() : nullptr;
  const SolveResult result = gradients_.solve(
      [&system, mask](const BorrowedView<const double*>& from, const BorrowedView<double*>& to)
      { multiply<D>(system, from.data(), to.data(), mask); },
      [this, &system, inverse](const BorrowedView<const double*>& from, const BorrowedView<double*>& to)
      { chebyshev_.apply(system, inverse, from.data(), to.data(), gradients_.tolerance()); });
  const BorrowedView<const double*> correction = gradients_.solution();
  Kokkos::parallel_for(
      "rhegma::mass::correct", Kokkos::RangePolicy<ExecSpace>(s.first * width<D>, s.last * width<D>),
      KOKKOS_LAMBDA(const int i) { x(i) += scale * correction(i); });
  record(state, result, scale, what);
}

template <int D>
void NodalSolve<D>::solveMotion(State<D>& state, const MassSystem<D>& system)
{
  const MassSystem<D> s = system;
  const Nodes<D> nodes = state.nodes;
  const View<double*> right = right_, prescribed = prescribed_, velocity = velocity_,
                      acceleration = acceleration_, heldVelocity = heldVelocity_, image = residual_,
                      free = freeOnly_;
  const View<double* [D]> lastVelocity = lastVelocity_, last = lastAcceleration_;
  const bool masked = masked_;
  const double dt = state.dt;

  // Velocity before the forces, held by nothing: it belongs to the particles.
  Kokkos::parallel_for(
      "rhegma::mass::momentum", rows(system), KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row);
        for (int d = 0; d < D; ++d)
        {
          right(row * width<D> + d) = nodes.sums(n, Nodes<D>::momentumAt + d);
          velocity(row * width<D> + d) = lastVelocity(n, d);
        }
      });
  solve(state, system, false, velocity, "velocity of the nodes");

  Kokkos::parallel_for(
      "rhegma::mass::force", rows(system), KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row);
        for (int d = 0; d < D; ++d)
        {
          const int i = row * width<D> + d;
          right(i) = nodes.sums(n, Nodes<D>::forceAt + d);
          acceleration(i) = last(n, d);
          if (masked && free(i) == 0.0)
            prescribed(i) = (heldVelocity(i) - velocity(i)) / dt;
        }
      });
  solve(state, system, true, acceleration, "acceleration of the nodes");

  if (masked)
  {
    // Impulses of the supports: what M a takes beyond the forces that are there.
    const std::size_t unknowns = static_cast<std::size_t>(system.room) * D;
    if (state.coupledReaction.extent(0) < unknowns)
      state.coupledReaction = View<double*>("rhegma::massReaction", unknowns);
    const View<double*> reaction = state.coupledReaction;
    multiply<D>(system, acceleration.data(), image.data());
    Kokkos::parallel_for(
        "rhegma::mass::reaction", rows(system), KOKKOS_LAMBDA(const int row) {
          for (int d = 0; d < D; ++d)
          {
            const int i = row * width<D> + d;
            reaction(row * D + d) = free(i) == 0.0 && s.coupled(row) ? dt * (image(i) - right(i)) : 0.0;
          }
        });
  }
  Kokkos::parallel_for(
      "rhegma::mass::motion", rows(system), KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row);
        for (int d = 0; d < D && s.coupled(row); ++d)
        {
          const int i = row * width<D> + d;
          nodes.motion(n, d) = velocity(i) + dt * acceleration(i);
          nodes.motion(n, Nodes<D>::accelerationAt + d) = acceleration(i);
          lastVelocity(n, d) = velocity(i);
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
  const View<double* [D]> lastVelocity = lastVelocity_;
  const bool masked = masked_;
  const bool afterSolve = state.scheme == UpdateScheme::Musl;
  Kokkos::parallel_for(
      "rhegma::mass::projected", rows(system), KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row);
        for (int d = 0; d < D; ++d)
        {
          const int i = row * width<D> + d;
          right(i) = s.lumped(row) * nodes.projection(n, d);
          velocity(i) = afterSolve ? nodes.motion(n, d) : lastVelocity(n, d);
          if (masked)
            prescribed(i) = heldVelocity(i);
        }
      });
  solve(state, system, true, velocity, "velocity that strains the particles");
  // In the next step of MUSL, or later in this one of USF, the nodes move about as they do here.
  Kokkos::parallel_for(
      "rhegma::mass::projection", rows(system), KOKKOS_LAMBDA(const int row) {
        for (int d = 0; d < D && s.coupled(row); ++d)
          nodes.projection(s.nodeOf(row), d) = lastVelocity(s.nodeOf(row), d) = velocity(row * width<D> + d);
      });
}

template class NodalSolve<2>;
template class NodalSolve<3>;

} // namespace Rhegma::mass_matrix
