#include "equilibrium/LinearSystem.hpp"

#include "equilibrium/RigidModes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace Rhegma::equilibrium
{

namespace
{

constexpr double linearTolerance = 1e-11;
constexpr int mostLinearIterations = 50000;

/// Residual of conjugate gradients or GMRES, relative to the right side, below which the next iteration of
/// Newton's method, which is due in any case for the change of the stiffness, takes over.
constexpr double leastLinearResidual = 1e-8;

/// Residual of a linear solve, relative to its right side, with which an iteration of Newton's method still
/// gains digits: rounding keeps large matrices from the tolerance.
constexpr double usefulResidual = 1e-3;

/// Unknowns up to which a direct solution is considered: beyond, its ordering alone takes seconds. The second
/// number is that of systems that conjugate gradients solve slowly.
template <int D>
constexpr int mostDirectUnknowns = D == 2 ? 400000 : 12000;
template <int D>
constexpr int mostDirectUnknownsOfForces = D == 2 ? 400000 : 50000;

/// Floating-point operations of a factorisation that take as long as conjugate gradients with multigrid: a
/// second or two with OpenBLAS.
constexpr double mostOperations = 2e10;

/// The same of forces of the step that change the stiffness in each iteration and are up to a thousand times
/// as stiff as the material, by which conjugate gradients take hundreds of iterations.
constexpr double mostOperationsOfForces = 2e11;

/// The same where conjugate gradients have failed, or would take longer: minutes.
constexpr double mostOperationsAtLast = 1e12;

/// Unknowns from which the set-up of multigrid is shorter than the iterations that it saves.
template <int D>
constexpr int leastMultigridUnknowns = D == 2 ? 50000 : 5000;

/// A multigrid of an earlier matrix is replaced after a system for which it needs so many times its first
/// iterations per decade of the residual, and within a system, which is then solved anew, beyond the second
/// number of times.
constexpr double mostAged = 2.0, mostTooOld = 4.0;

/// Iterations that are no reason to replace a multigrid: its set-up takes longer.
constexpr int fewIterations = 20;

/// Whether the energy of a displacement is negative, by more than rounding. Collective.
/// \param force by the stiffness
bool isNegative(const Ranks& ranks, const BorrowedView<const double*>& displacement,
                const BorrowedView<double*>& force)
{
  constexpr double rounding = 1e-10;
  double sums[] = {0.0, 0.0, 0.0}; // of u . f, u . u, f . f
  for (std::size_t k = 0; k < displacement.extent(0); ++k)
  {
    sums[0] += displacement(k) * force(k);
    sums[1] += displacement(k) * displacement(k);
    sums[2] += force(k) * force(k);
  }
  ranks.sum(sums, 3);
  return sums[0] < -rounding * std::sqrt(sums[1] * sums[2]);
}

} // namespace

template <int D>
LinearSystem<D>::LinearSystem(const RowGraph& graph, const RowOwners& owners,
                              const std::vector<Vector<D>>& positions, const Held& held)
    : owners_(owners),
      position_(positions),
      held_("rhegma::equilibrium::held", D * graph.rows),
      matrix_(graph, owners_)
{
  double counts[] = {0.0, 0.0}; // unknowns, rows
  for (int r = 0; r < graph.rows; ++r)
  {
    for (int k = D * r; k < D * (r + 1); ++k)
    {
      held_(k) = held.is[k];
      counts[0] += owners.owns(r) && held.is[k] == 0 ? 1.0 : 0.0;
    }
    if (owners.owns(r))
      nodes_.push_back(graph.nodeOf(r));
  }
  b_ = Values("rhegma::equilibrium::right", matrix_.rows());
  x_ = Values("rhegma::equilibrium::solution", matrix_.rows());
  counts[1] = static_cast<double>(nodes_.size());
  owners.ranks().sum(counts, 2);
  unknowns_ = static_cast<int>(counts[0]);
  rowsOfAll_ = static_cast<int>(counts[1]);
}

template <int D>
bool LinearSystem<D>::fits(const RowGraph& graph, const Held& held) const
{
  const auto same = [](const View<int*>& a, const View<int*>& b)
  { return a.extent(0) == b.extent(0) && std::equal(a.data(), a.data() + a.extent(0), b.data()); };
  const bool fit = same(graph.nodeOf, matrix_.graph().nodeOf) && same(graph.first, matrix_.graph().first) &&
                   same(graph.column, matrix_.graph().column) &&
                   std::equal(held.is.begin(), held.is.end(), held_.data());
  return owners_.ranks().max(fit ? 0.0 : 1.0) == 0.0;
}

template <int D>
void LinearSystem<D>::adopt(LinearSystem& earlier)
{
  if (!earlier.multigrid_ || earlier.earlier_.any())
    return;
  earlier_ = EarlierRows::match(owners_.ranks(), nodes_, earlier.nodes_, D);
  if (!earlier_.any())
    return;
  multigrid_ = std::move(earlier.multigrid_);
  perDecade_ = earlier.perDecade_;
}

template <int D>
void LinearSystem<D>::precondition(const View<double*>& diagonal, const BorrowedView<const double*>& x,
                                   const BorrowedView<double*>& y) const
{
  if (!multigrid_)
    divideByDiagonal(diagonal, x, y);
  else if (earlier_.any())
    earlier_.apply(*multigrid_, diagonal, x, y);
  else
    multigrid_->apply(x, y);
}

template <int D>
bool LinearSystem<D>::isLarge(int rows)
{
  return D * rows > mostDirectUnknowns<D>;
}

template <int D>
void LinearSystem<D>::makeKrylov()
{
  krylov_ = std::make_unique<KrylovSolver>(linearTolerance, mostLinearIterations, OnStopRequest::Throw);
  krylov_->resize(matrix_.rows(), owners_.ranks());
}

template <int D>
typename LinearSystem<D>::Method LinearSystem<D>::chooseMethod()
{
  const bool iterates = choice_ == SolverChoice::Iterative, factorises = choice_ == SolverChoice::Direct;
  const bool multigrid = Multigrid::available() && (iterates || unknowns_ >= leastMultigridUnknowns<D>);
  // Conjugate gradients with the diagonal take longer than any factorisation of so few unknowns.
  const double most = factorises  ? std::numeric_limits<double>::max()
                      : multigrid ? mostOperations
                                  : mostOperationsAtLast;
  const bool considered = factorises || (!iterates && unknowns_ <= mostDirectUnknowns<D>);
  if (DirectSolver::available() && considered && direct_.analyse(matrix_.sparse()) <= most)
    return Method::Direct;
  makeKrylov();
  return multigrid ? Method::Multigrid : Method::Diagonal;
}

template <int D>
Multigrid::Vectors LinearSystem<D>::nearNullSpace() const
{
  double ends[2 * D]; // -lowest, highest
  std::fill(ends, ends + 2 * D, std::numeric_limits<double>::lowest());
  for (const Vector<D>& x : position_)
    for (int d = 0; d < D; ++d)
    {
      ends[2 * d] = std::max(ends[2 * d], -x[d]);
      ends[2 * d + 1] = std::max(ends[2 * d + 1], x[d]);
    }
  owners_.ranks().max(ends, 2 * D);
  Vector<D> low, high;
  for (int d = 0; d < D; ++d)
  {
    low[d] = -ends[2 * d];
    high[d] = ends[2 * d + 1];
  }
  Multigrid::Vectors motions;
  for (int m = 0; m < rigidMotions<D>; ++m)
  {
    RigidMode<D> mode;
    mode.centre = 0.5 * (low + high);
    mode.size = 0.5 * norm(high - low);
    mode.coefficient[m] = 1.0;
    std::vector<double> motion(matrix_.rows());
    for (int k = 0; k < matrix_.rows(); ++k)
      motion[k] = mode.at(position_[matrix_.unknownOf(k) / D])[k % D];
    motions.push_back(std::move(motion));
  }
  return motions;
}

template <int D>
Multigrid::Vectors LinearSystem<D>::coordinates() const
{
  Multigrid::Vectors along(D);
  for (int k = 0; k < matrix_.rows(); ++k)
    along[k % D].push_back(position_[matrix_.unknownOf(k) / D][k % D]);
  return along;
}

template <int D>
LinearAnswer LinearSystem<D>::solveDirectly(bool symmetric)
{
  if (!symmetric && !unsymmetricAnalysed_)
  {
    unsymmetric_.analyse(matrix_.sparse());
    unsymmetricAnalysed_ = true;
  }
  DirectSolver& direct = symmetric ? direct_ : unsymmetric_;
  if (!direct.factorise(matrix_.sparse()))
    return {false, 0, {}, direct.failure()};
  Kokkos::deep_copy(x_, b_);
  direct.solve(x_);
  return {true, 0, direct.negativeEigenvalues(), {}};
}

template <int D>
void LinearSystem<D>::makeMultigrid()
{
  multigrid_.reset();
  earlier_ = {};
  if (method_ != Method::Multigrid)
    return;
  double failed = 0.0;
  const Multigrid::Vectors motions = nearNullSpace();
  if (approximate_ != nullptr)
  {
    if (!matrix_.isBuilt())
      matrix_.build();
    matrix_.fill((*approximate_)(), held_);
  }
  try
  {
    multigrid_ = std::make_unique<Multigrid>(matrix_.sparse(), D, motions, coordinates());
  }
  catch (const std::exception&) // a matrix that cannot be aggregated
  {
    failed = 1.0;
  }
  if (owners_.ranks().max(failed) == 0.0)
    return;
  multigrid_.reset();
  method_ = Method::Diagonal;
}

template <int D>
SolveResult LinearSystem<D>::runKrylov(const Values& diagonal, int most)
{
  const auto product = [this](const BorrowedView<const double*>& x, const BorrowedView<double*>& y)
  {
    multiply(x, y);
    metNegative_ = metNegative_ || (symmetric_ && isNegative(owners_.ranks(), x, y));
  };
  const auto preconditioned = [&](const BorrowedView<const double*>& x, const BorrowedView<double*>& y)
  { precondition(diagonal, x, y); };
  return symmetric_ ? krylov_->solve(product, preconditioned, most)
                    : krylov_->solveUnsymmetric(product, preconditioned, most);
}

template <int D>
LinearAnswer LinearSystem<D>::iterate(const LinearGoal& goal)
{
  double size = 0.0;
  for (int k = 0; k < matrix_.rows(); ++k)
    size += b_(k) * b_(k);
  size = std::sqrt(owners_.ranks().sum(size));
  if (size == 0.0)
  {
    Kokkos::deep_copy(x_, 0.0);
    return {true, 0, {}, {}};
  }
  metNegative_ = false;
  // The tolerance is that of a right side of size one: a smaller one needs fewer digits.
  const double wanted = std::min(std::max({goal.force / size, goal.fraction, leastLinearResidual}), 0.1);
  const double scale = size * std::max(1.0, wanted / linearTolerance);
  const auto right = krylov_->right();
  const Values ofMatrix = diagonal();
  for (int r = 0; r < matrix_.rows(); ++r)
    right(r) = b_(r) / scale;
  const bool old = multigrid_ != nullptr && method_ == Method::Multigrid;
  if (!old)
    makeMultigrid();
  const double decades = -std::log10(wanted);
  const auto beyond = [&](double times)
  { return std::max(fewIterations, static_cast<int>(times * perDecade_ * decades)); };
  SolveResult result = runKrylov(ofMatrix, old ? beyond(mostTooOld) : 0);
  int iterations = result.iterations;
  if (old && !result.converged)
  {
    makeMultigrid();
    result = runKrylov(ofMatrix);
    iterations += result.iterations;
    perDecade_ = result.iterations / decades;
  }
  else if (!old)
    perDecade_ = result.iterations / decades;
  else if (result.iterations > beyond(mostAged))
    multigrid_.reset(); // the next system gets its own
  if (multigrid_ && !result.converged && !(result.residual * scale < usefulResidual * size))
  {
    multigrid_.reset();
    method_ = Method::Diagonal;
    result = runKrylov(ofMatrix);
    iterations += result.iterations;
  }
  const auto x = krylov_->solution();
  for (int k = 0; k < matrix_.rows(); ++k)
    x_(k) = scale * x(k);
  // Newton's method corrects the rest.
  const bool solved = result.converged || result.residual * scale < usefulResidual * size;
  return {solved, iterations, metNegative_ ? std::optional<int>(1) : std::nullopt, {}};
}

template <int D>
void LinearSystem<D>::prepare()
{
  if (!matrix_.isBuilt())
    matrix_.build();
  if (method_ == Method::Unknown)
    method_ = chooseMethod();
}

template <int D>
bool LinearSystem<D>::takesUnsymmetric()
{
  if (rowsOfAll_ == 0)
    return true;
  prepare();
  const bool tries = choice_ != SolverChoice::Iterative && unknowns_ <= mostDirectUnknownsOfForces<D> &&
                     DirectSolver::available();
  if (method_ != Method::Direct && !isTooLarge_ && tries)
  {
    isTooLarge_ = direct_.analyse(matrix_.sparse()) > mostOperationsOfForces;
    method_ = isTooLarge_ ? method_ : Method::Direct;
  }
  return method_ != Method::Diagonal;
}

template <int D>
LinearAnswer LinearSystem<D>::solve(StiffnessBlocks stiffness, bool symmetric, const Values& right,
                                    const LinearGoal& goal, const Values& change)
{
  if (rowsOfAll_ == 0)
    return {true, 0, 0, {}};
  prepare();
  matrix_.fill(stiffness, held_);
  matrix_.moveHeldToRight(stiffness, held_, right, change, b_);
  stiffness = {};
  symmetric_ = symmetric;
  return finish(method_ == Method::Direct ? solveDirectly(symmetric) : iterate(goal), symmetric, goal,
                change);
}

template <int D>
LinearAnswer LinearSystem<D>::solveAgain(const Values& right, const LinearGoal& goal, const Values& change)
{
  if (rowsOfAll_ == 0)
    return {true, 0, 0, {}};
  for (int k = 0; k < matrix_.rows(); ++k)
  {
    const int of = matrix_.unknownOf(k);
    b_(k) = held_(of) != 0 ? 0.0 : right(of);
  }
  if (method_ != Method::Direct)
    return finish(iterate(goal), symmetric_, goal, change);
  DirectSolver& direct = symmetric_ ? direct_ : unsymmetric_;
  Kokkos::deep_copy(x_, b_);
  direct.solve(x_);
  return finish({true, 0, direct.negativeEigenvalues(), {}}, symmetric_, goal, change);
}

template <int D>
LinearAnswer LinearSystem<D>::finish(LinearAnswer answer, bool symmetric, const LinearGoal& goal,
                                     const Values& change)
{
  // A factorisation that memory does not suffice for; conjugate gradients need a tenth of it.
  if (!answer.solved && method_ == Method::Direct && !answer.failure.empty() && symmetric &&
      Multigrid::available())
  {
    method_ = Method::Multigrid;
    makeKrylov();
    const std::string failure = answer.failure;
    answer = iterate(goal);
    answer.failure = answer.solved ? std::string() : failure;
    return take(answer, change);
  }
  if (!answer.solved && method_ != Method::Direct && DirectSolver::available() &&
      direct_.analyse(matrix_.sparse()) <= mostOperationsAtLast)
  {
    method_ = Method::Direct;
    answer = solveDirectly(symmetric);
  }
  return take(answer, change);
}

template <int D>
LinearAnswer LinearSystem<D>::take(const LinearAnswer& answer, const Values& change) const
{
  for (int k = 0; k < matrix_.rows(); ++k)
    if (const int of = matrix_.unknownOf(k); held_(of) == 0)
      change(of) = x_(k);
  return answer;
}

template <int D>
std::string LinearSystem<D>::method() const
{
  switch (method_)
  {
  case Method::Direct:
    return "direct (MUMPS)";
  case Method::Multigrid:
    return (symmetric_ ? "conjugate gradients with multigrid (" : "GMRES with multigrid (") +
           std::string(Multigrid::name()) + ")";
  case Method::Diagonal:
    return symmetric_ ? "conjugate gradients with the diagonal" : "GMRES with the diagonal";
  case Method::Unknown:
    break;
  }
  return "none";
}

template class LinearSystem<2>;
template class LinearSystem<3>;

} // namespace Rhegma::equilibrium
