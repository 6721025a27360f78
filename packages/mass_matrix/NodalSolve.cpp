#include "mass_matrix/NodalSolve.hpp"

#include "archive/Archive.hpp"
#include "base/SmallLoops.hpp"
#include "base/UnstableStep.hpp"
#include "mass_matrix/FirstGuess.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <sstream>

namespace Rhegma::mass_matrix
{

namespace
{

/// Products with the matrix in one application of the polynomial. On a beam of 5,400 nodes and two threads
/// more of them cost as much as the iterations they save; with fewer, the vector operations of Belos
/// dominate.
constexpr int polynomialProducts = 4;

/// Smallest relative residual in double precision.
constexpr double leastResidual = 1e-13;

/// x += scale correction, in the rows; the correction as `toWeighed` makes it.
template <int D>
void addScaled(const MassSystem<D>& system, double scale, const BorrowedView<const double*>& correction,
               const View<double*>& x)
{
  const MassSystem<D> s = system;
  parallelForSmall(
      "rhegma::mass::correct", system.first, system.last, KOKKOS_LAMBDA(const int row) {
        const double weight = scale / std::sqrt(s.weightOf(row));
        for (int i = width<D> * row; i < width<D> * (row + 1); ++i)
          x(i) += weight * correction(i);
      });
}

/// Where ranks share rows, dot products are right for vectors that have each number divided by the root of
/// how many ranks have it.
template <int D>
void toWeighed(const MassSystem<D>& system, const BorrowedView<double*>& x)
{
  const MassSystem<D> s = system;
  parallelForSmall(
      "rhegma::mass::toWeighed", width<D> * s.first, width<D> * s.last,
      KOKKOS_LAMBDA(const int i) { x(i) *= std::sqrt(s.weightOf(i / width<D>)); });
}

template <int D>
void fromWeighed(const MassSystem<D>& system, const BorrowedView<const double*>& from, const View<double*>& x)
{
  const MassSystem<D> s = system;
  parallelForSmall(
      "rhegma::mass::fromWeighed", 0, width<D> * s.rowCapacity, KOKKOS_LAMBDA(const int i) {
        const int row = i / width<D>;
        x(i) = row >= s.first && row < s.last ? from(i) / std::sqrt(s.weightOf(row)) : 0.0;
      });
}

} // namespace

template <int D>
NodalSolve<D>::NodalSolve(double tolerance, int maximumIterations, double lumpedFraction)
    : gradients_(tolerance, maximumIterations), chebyshev_(lumpedFraction, polynomialProducts)
{
}

template <int D>
void NodalSolve<D>::reserve(const State<D>& state, const MassSystem<D>& system)
{
  const std::size_t n = static_cast<std::size_t>(system.rowCapacity) * width<D>;
  if (right_.extent(0) != n)
  {
    const auto make = [n](const std::string& name) { return View<double*>(name, n); };
    inverse_ = make("rhegma::massInverse");
    freeOnly_ = make("rhegma::massFree");
    heldVelocity_ = make("rhegma::massHeldVelocity");
    right_ = make("rhegma::massRight");
    prescribed_ = make("rhegma::massPrescribed");
    image_ = make("rhegma::massImage");
    velocity_ = make("rhegma::massVelocity");
    acceleration_ = make("rhegma::massAcceleration");
    if (state.mesh.subdomain)
      plain_ = make("rhegma::massPlain");
  }
  gradients_.resize(static_cast<int>(n), state.mesh.subdomain ? state.ranks : Ranks());
}

template <int D>
void NodalSolve<D>::begin(const State<D>& state, const MassSystem<D>& system)
{
  reserve(state, system);
  renewed_ = state.mesh.nodalFields.lastRemesh() == state.clock.step;
  holdRows(state, system);
}

template <int D>
void NodalSolve<D>::holdRows(const State<D>& state, const MassSystem<D>& system)
{
  masked_ = !state.motion.constraints.empty();
  for (int d = 0; d < D; ++d)
    heldAxis_[d] = std::any_of(state.motion.constraints.begin(), state.motion.constraints.end(),
                               [d](const NodeConstraint<D>& constraint) { return constraint.holds[d]; });
  const MassSystem<D> s = system;
  const Nodes<D> nodes = state.mesh.nodes;
  const View<double*> inverse = inverse_, free = freeOnly_, value = heldVelocity_, right = right_,
                      image = image_, velocity = velocity_, acceleration = acceleration_;
  // Vectors are zero outside of the rows and in unused numbers of them.
  parallelForSmall(
      "rhegma::mass::begin", 0, s.rowCapacity, KOKKOS_LAMBDA(const int row) {
        const bool inside = row >= s.first && row < s.last;
        for (int d = 0; d < width<D>; ++d)
        {
          const int i = width<D> * row + d;
          inverse(i) = free(i) = inside && d < D && s.coupled(row) ? 1.0 / s.lumped(row) : 0.0;
          if (!inside || !s.coupled(row))
            right(i) = image(i) = velocity(i) = acceleration(i) = 0.0;
        }
      });
  for (const NodeConstraint<D>& constraint : state.motion.constraints)
  {
    const NodeConstraint<D> c = constraint;
    const NodePositions<D> positions = nodePositions(state);
    parallelForSmall(
        "rhegma::mass::hold", system.first, system.last, KOKKOS_LAMBDA(const int row) {
          const int lattice = latticeNode(nodes, s.nodeOf(row));
          if (!c.appliesAt(positions(lattice)))
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
  if (result.converged || !state.failure.empty())
    return;
  std::ostringstream reason;
  reason << "the mass matrix could not be solved for the " << what << ": ";
  if (!std::isfinite(scale))
    reason << "the right-hand side is not finite (" << unstableStep(state.mesh.subcycledLevels) << ")";
  else if (result.singular)
    reason << "it is singular, and " << result.residual
           << " of the right-hand side is left (raise Mass Matrix > Lumped Fraction above 0)";
  else
    reason << "after " << result.iterations << " iterations the residual is still " << result.residual
           << " of the right-hand side (raise Mass Matrix > Maximum Iterations, Solver Tolerance or Lumped "
              "Fraction)";
  state.failure = reason.str();
}

template <int D>
typename NodalSolve<D>::Start NodalSolve<D>::findStart(const State<D>& state, const MassSystem<D>& system,
                                                       bool masked, const View<double*>& x)
{
  const View<double*> inverse = masked ? freeOnly_ : inverse_, image = image_, prescribed = prescribed_;
  const MassSystem<D> s = system;
  if (masked)
    parallelForSmall(
        "rhegma::mass::prescribe", system.first, system.last, KOKKOS_LAMBDA(const int row) {
          for (int i = width<D> * row; i < width<D> * row + D; ++i)
            if (inverse(i) == 0.0 && s.coupled(row))
              x(i) = prescribed(i);
        });
  const GuessSums<D> guess = checkGuess(state, system, right_, x, inverse, image);
  const auto freeAxis = [&](int d) { return !masked || !heldAxis_[d]; };
  // The residual is relative to b - L c, c the mean of the solution: relative to b, a moving body would be
  // solved less accurately than one at rest, and the error would excite its vibration.
  double square = guess.rightSquare;
  for (int d = 0; d < D; ++d)
    if (freeAxis(d))
    {
      const double mean = guess.right[d] / system.coupledMass;
      square += mean * (mean * guess.lumpedSquare - 2.0 * guess.weighted[d]);
    }
  const double roundOff = leastResidual / gradients_.tolerance();
  square = std::max(square, roundOff * roundOff * guess.rightSquare);
  // Where supports alone move a body at rest, the right side of the free nodes is zero.
  Start start;
  start.scale = std::sqrt(masked ? std::max(square, guess.residualSquare) : square);
  // The multiple of the guess that is nearest to the solution in the norm of M: damping scales velocities.
  const bool scalable = !masked && guess.energy > 0.0;
  start.multiple = masked ? 1.0 : scalable ? guess.along / guess.energy : 0.0;
  // A shift of x by a constant leaves a residual without a sum, as M 1 = L 1. Axes along which nothing is
  // held keep their momentum this way; without a mask all do.
  for (int d = 0; d < D; ++d)
    if (freeAxis(d))
      start.shift[d] = (guess.right[d] - start.multiple * guess.image[d]) / system.coupledMass;
  return start;
}

template <int D>
double NodalSolve<D>::findResidual(const State<D>& state, const MassSystem<D>& system, bool masked,
                                   const Start& start, const View<double*>& x)
{
  const View<double*> inverse = masked ? freeOnly_ : inverse_, image = image_;
  const MassSystem<D> s = system;
  const double scale = start.scale, multiple = start.multiple;
  const Vector<D> shift = start.shift;
  const BorrowedView<double*> right = gradients_.right();
  const View<double*> target = right_;
  const double inverseScale = scale > 0.0 ? 1.0 / scale : 0.0;
  double remains = 0.0;
  parallelSumSmall(
      "rhegma::mass::start", 0, s.rowCapacity,
      KOKKOS_LAMBDA(const int row, double& sum) {
        const bool coupled = row >= s.first && row < s.last && s.coupled(row);
        for (int d = 0; d < width<D>; ++d)
        {
          const int i = width<D> * row + d;
          right(i) = 0.0;
          if (!coupled || d >= D)
            continue;
          x(i) = multiple * x(i) + shift[d];
          if (inverse(i) != 0.0)
            right(i) = (target(i) - multiple * image(i) - shift[d] * s.lumped(row)) * inverseScale;
          right(i) *= std::sqrt(s.weightOf(row));
          sum += right(i) * right(i);
        }
      },
      remains);
  sumParts(state, &remains, 1);
  return std::sqrt(remains);
}

template <int D>
void NodalSolve<D>::solve(State<D>& state, const MassSystem<D>& system, bool held, const View<double*>& x,
                          const std::string& what, Accuracy accuracy)
{
  const bool masked = held && masked_;
  const View<double*> inverse = masked ? freeOnly_ : inverse_, image = image_;
  const BorrowedView<double*> right = gradients_.right();
  const Start start = findStart(state, system, masked, x);
  const double scale = start.scale, norm = findResidual(state, system, masked, start, x);
  if (norm <= gradients_.tolerance() || !std::isfinite(norm))
    return record(state, {norm <= gradients_.tolerance(), false, 0, norm}, scale, what);

  const bool weighed = static_cast<bool>(state.mesh.subdomain);
  const auto precondition = [&](const BorrowedView<const double*>& from, const BorrowedView<double*>& to)
  {
    if (weighed)
      fromWeighed(system, from, plain_);
    chebyshev_.apply(&state, system, inverse, weighed ? plain_.data() : from.data(), to.data(),
                     gradients_.tolerance());
    if (weighed)
      toWeighed(system, to);
  };
  if (accuracy == Accuracy::Near)
  {
    precondition(BorrowedView<const double*>(right.data(), right.extent(0)),
                 BorrowedView<double*>(image.data(), image.extent(0)));
    addScaled(system, scale, BorrowedView<const double*>(image.data(), image.extent(0)), x);
    return;
  }
  const double* const mask = masked ? inverse.data() : nullptr;
  const auto apply = [&](const BorrowedView<const double*>& from, const BorrowedView<double*>& to)
  {
    if (weighed)
      fromWeighed(system, from, plain_);
    multiplyWhole<D>(state, system, weighed ? plain_.data() : from.data(), to.data(), mask);
    if (weighed)
      toWeighed(system, to);
  };
  const SolveResult result = gradients_.solve(apply, precondition);
  addScaled(system, scale, gradients_.solution(), x);
  record(state, result, scale, what);
}

template <int D>
void NodalSolve<D>::serialize(Archive& archive)
{
  archive("solves", count_.solves);
  archive("iterations", count_.iterations);
  archive("most_iterations", count_.mostIterations);
  archive("worst_residual", count_.worstResidual);
}

template class NodalSolve<2>;
template class NodalSolve<3>;

} // namespace Rhegma::mass_matrix
