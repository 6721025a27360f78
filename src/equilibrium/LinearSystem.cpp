#include "equilibrium/LinearSystem.hpp"

#include "equilibrium/RigidModes.hpp"

#include <algorithm>
#include <stdexcept>

namespace Rhegma::equilibrium
{

namespace
{

constexpr double linearTolerance = 1e-11;
constexpr int mostLinearIterations = 50000;

/// Residual of conjugate gradients, relative to the right side, below which the next iteration of Newton's
/// method, which is due in any case for the change of the stiffness, takes over.
constexpr double leastLinearResidual = 1e-8;

/// Residual of a linear solve, relative to its right side, with which an iteration of Newton's method still
/// gains digits: rounding keeps large matrices from the tolerance.
constexpr double usefulResidual = 1e-3;

/// Unknowns up to which a direct solution is considered: beyond, its ordering alone takes seconds.
template <int D>
constexpr int mostDirectUnknowns = D == 2 ? 400000 : 12000;

/// Floating-point operations of a factorisation that take as long as conjugate gradients: a second or two.
constexpr double mostOperations = 3e9;

/// The same where conjugate gradients have failed: minutes.
constexpr double mostOperationsAtLast = 1e12;

/// Unknowns from which the set-up of multigrid is shorter than the iterations that it saves.
template <int D>
constexpr int leastMultigridUnknowns = D == 2 ? 50000 : 5000;

/// A multigrid of an earlier matrix is replaced once it needs so many times its first iterations.
constexpr int mostAged = 2;

} // namespace

template <int D>
LinearSystem<D>::LinearSystem(const RowGraph& graph, const std::vector<Vector<D>>& positions,
                              const Held& held)
    : graph_(graph),
      position_(positions),
      held_("rhegma::equilibrium::held", D * graph.rows),
      b_("rhegma::equilibrium::right", D * graph.rows),
      x_("rhegma::equilibrium::solution", D * graph.rows)
{
  for (int k = 0; k < D * graph.rows; ++k)
  {
    held_(k) = held.is[k];
    unknowns_ += held.is[k] == 0 ? 1 : 0;
  }
}

template <int D>
bool LinearSystem<D>::fits(const RowGraph& graph, const Held& held) const
{
  const auto same = [](const View<int*>& a, const View<int*>& b)
  { return a.extent(0) == b.extent(0) && std::equal(a.data(), a.data() + a.extent(0), b.data()); };
  return same(graph.nodeOf, graph_.nodeOf) && same(graph.first, graph_.first) &&
         same(graph.column, graph_.column) && std::equal(held.is.begin(), held.is.end(), held_.data());
}

template <int D>
void LinearSystem<D>::adopt(LinearSystem& earlier)
{
  if (!earlier.multigrid_ || earlier.earlier_.any())
    return;
  earlier_ = EarlierRows::match(graph_, earlier.graph_, D);
  if (!earlier_.any())
    return;
  multigrid_ = std::move(earlier.multigrid_);
  iterationsWhenNew_ = earlier.iterationsWhenNew_;
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
void LinearSystem<D>::buildRows()
{
  const int rows = graph_.rows;
  matrix_.first = View<std::size_t*>("rhegma::equilibrium::first", D * rows + 1);
  const std::size_t entries = static_cast<std::size_t>(D) * D * graph_.column.extent(0);
  matrix_.column = View<int*>("rhegma::equilibrium::column", entries);
  matrix_.value = View<double*>("rhegma::equilibrium::value", entries);
  std::size_t next = 0;
  for (int r = 0; r < rows; ++r)
    for (int i = 0; i < D; ++i)
    {
      for (int e = graph_.first(r); e < graph_.first(r + 1); ++e)
        for (int k = 0; k < D; ++k)
          matrix_.column(next++) = D * graph_.column(e) + k;
      matrix_.first(D * r + i + 1) = next;
    }
}

template <int D>
void LinearSystem<D>::fill(const StiffnessBlocks& stiffness)
{
  const RowGraph graph = graph_;
  const SparseMatrix matrix = matrix_;
  const auto held = held_;
  Kokkos::parallel_for(
      "rhegma::equilibrium::fillRows", Kokkos::RangePolicy<ExecSpace>(0, graph.rows),
      KOKKOS_LAMBDA(const int r) {
        for (int i = 0; i < D; ++i)
        {
          std::size_t at = matrix.first(D * r + i);
          for (int e = graph.first(r); e < graph.first(r + 1); ++e)
            for (int k = 0; k < D; ++k, ++at)
            {
              const int to = D * graph.column(e) + k;
              const double entry = stiffness(D * D * static_cast<std::size_t>(e) + D * i + k);
              if (to == D * r + i)
                matrix.value(at) = held(to) != 0 && entry <= 0.0 ? 1.0 : entry;
              else
                matrix.value(at) = held(D * r + i) == 0 && held(to) == 0 ? entry : 0.0;
            }
        }
      });
}

template <int D>
void LinearSystem<D>::moveHeldToRight(const StiffnessBlocks& stiffness, const Values& right,
                                      const Values& change)
{
  const RowGraph graph = graph_;
  const auto held = held_;
  const Values b = b_;
  Kokkos::parallel_for(
      "rhegma::equilibrium::rightSide", Kokkos::RangePolicy<ExecSpace>(0, graph.rows),
      KOKKOS_LAMBDA(const int r) {
        for (int i = 0; i < D; ++i)
        {
          double sum = held(D * r + i) != 0 ? 0.0 : right(D * r + i);
          for (int e = graph.first(r); e < graph.first(r + 1) && held(D * r + i) == 0; ++e)
            for (int k = 0; k < D; ++k)
              if (const int other = D * graph.column(e) + k; held(other) != 0)
                sum -= stiffness(D * D * static_cast<std::size_t>(e) + D * i + k) * change(other);
          b(D * r + i) = sum;
        }
      });
}

template <int D>
bool LinearSystem<D>::isLarge(int rows)
{
  return D * rows > mostDirectUnknowns<D>;
}

template <int D>
typename LinearSystem<D>::Method LinearSystem<D>::choose()
{
  if (DirectSolver::available() && unknowns_ <= mostDirectUnknowns<D> &&
      direct_.analyse(matrix_) <= mostOperations)
    return Method::Direct;
  gradients_ = std::make_unique<ConjugateGradients>(linearTolerance, mostLinearIterations);
  gradients_->resize(matrix_.rows());
  return Multigrid::available() && unknowns_ >= leastMultigridUnknowns<D> ? Method::Multigrid
                                                                          : Method::Diagonal;
}

template <int D>
std::vector<std::vector<double>> LinearSystem<D>::nearNullSpace() const
{
  Vector<D> low = position_[0], high = low;
  for (const Vector<D>& x : position_)
    for (int d = 0; d < D; ++d)
    {
      low[d] = std::min(low[d], x[d]);
      high[d] = std::max(high[d], x[d]);
    }
  std::vector<std::vector<double>> motions;
  for (int m = 0; m < rigidMotions<D>; ++m)
  {
    RigidMode<D> mode;
    mode.centre = 0.5 * (low + high);
    mode.size = 0.5 * norm(high - low);
    mode.coefficient[m] = 1.0;
    std::vector<double> motion(matrix_.rows());
    for (int r = 0; r < graph_.rows; ++r)
      for (int d = 0; d < D; ++d)
        motion[D * r + d] = mode.at(position_[r])[d];
    motions.push_back(std::move(motion));
  }
  return motions;
}

template <int D>
LinearAnswer LinearSystem<D>::solveDirectly(bool symmetric)
{
  if (!symmetric && !unsymmetricAnalysed_)
  {
    unsymmetric_.analyse(matrix_);
    unsymmetricAnalysed_ = true;
  }
  DirectSolver& direct = symmetric ? direct_ : unsymmetric_;
  if (!direct.factorise(matrix_))
    return {};
  Kokkos::deep_copy(x_, b_);
  direct.solve(x_);
  return {true, 0, direct.negativeEigenvalues()};
}

template <int D>
void LinearSystem<D>::makeMultigrid()
{
  multigrid_.reset();
  earlier_ = {};
  if (method_ != Method::Multigrid)
    return;
  try
  {
    multigrid_ = std::make_unique<Multigrid>(matrix_, D, nearNullSpace());
  }
  catch (const std::exception&) // a matrix that cannot be aggregated
  {
    method_ = Method::Diagonal;
  }
}

template <int D>
SolveResult LinearSystem<D>::runGradients(const View<double*>& diagonal)
{
  return gradients_->solve([this](const BorrowedView<const double*>& x, const BorrowedView<double*>& y)
                           { matrix_.multiply(x, y); },
                           [&](const BorrowedView<const double*>& x, const BorrowedView<double*>& y)
                           { precondition(diagonal, x, y); });
}

template <int D>
LinearAnswer LinearSystem<D>::iterate(double enough)
{
  double size = 0.0;
  for (int k = 0; k < matrix_.rows(); ++k)
    size += b_(k) * b_(k);
  size = std::sqrt(size);
  if (size == 0.0)
  {
    Kokkos::deep_copy(x_, 0.0);
    return {true, 0, 0};
  }
  // The tolerance is that of a right side of size one: a smaller one needs fewer digits.
  const double wanted = std::min(std::max(enough / size, leastLinearResidual), 0.1);
  const double scale = size * std::max(1.0, wanted / linearTolerance);
  const auto right = gradients_->right();
  View<double*> diagonal("rhegma::equilibrium::diagonal", matrix_.rows());
  for (int r = 0; r < matrix_.rows(); ++r)
  {
    right(r) = b_(r) / scale;
    for (std::size_t k = matrix_.first(r); k < matrix_.first(r + 1); ++k)
      if (matrix_.column(k) == r)
        diagonal(r) = matrix_.value(k);
  }
  const bool old = multigrid_ != nullptr && method_ == Method::Multigrid;
  if (!old)
    makeMultigrid();
  SolveResult result = runGradients(diagonal);
  int iterations = result.iterations;
  if (old && !result.converged)
  {
    makeMultigrid();
    result = runGradients(diagonal);
    iterations += result.iterations;
    iterationsWhenNew_ = result.iterations;
  }
  else if (!old)
    iterationsWhenNew_ = result.iterations;
  else if (result.iterations > mostAged * iterationsWhenNew_)
    multigrid_.reset(); // the next system gets its own
  if (multigrid_ && !result.converged && !(result.residual * scale < usefulResidual * size))
  {
    multigrid_.reset();
    method_ = Method::Diagonal;
    result = runGradients(diagonal);
    iterations += result.iterations;
  }
  const auto x = gradients_->solution();
  for (int k = 0; k < matrix_.rows(); ++k)
    x_(k) = scale * x(k);
  // Newton's method corrects the rest.
  return {result.converged || result.residual * scale < usefulResidual * size, iterations, 0};
}

template <int D>
void LinearSystem<D>::prepare()
{
  if (matrix_.rows() == 0)
    buildRows();
  if (method_ == Method::Unknown)
    method_ = choose();
}

template <int D>
bool LinearSystem<D>::takesUnsymmetric()
{
  if (graph_.rows == 0)
    return true;
  prepare();
  return method_ == Method::Direct;
}

template <int D>
LinearAnswer LinearSystem<D>::solve(StiffnessBlocks stiffness, bool symmetric, const Values& right,
                                    double enough, const Values& change)
{
  if (graph_.rows == 0)
    return {true, 0, 0};
  prepare();
  fill(stiffness);
  moveHeldToRight(stiffness, right, change);
  stiffness = {};
  symmetric_ = symmetric;
  return finish(method_ == Method::Direct ? solveDirectly(symmetric) : iterate(enough), symmetric, change);
}

template <int D>
LinearAnswer LinearSystem<D>::solveAgain(const Values& right, double enough, const Values& change)
{
  if (graph_.rows == 0)
    return {true, 0, 0};
  for (int k = 0; k < matrix_.rows(); ++k)
    b_(k) = held_(k) != 0 ? 0.0 : right(k);
  if (method_ != Method::Direct)
    return finish(iterate(enough), symmetric_, change);
  DirectSolver& direct = symmetric_ ? direct_ : unsymmetric_;
  Kokkos::deep_copy(x_, b_);
  direct.solve(x_);
  return finish({true, 0, direct.negativeEigenvalues()}, symmetric_, change);
}

template <int D>
LinearAnswer LinearSystem<D>::finish(LinearAnswer answer, bool symmetric, const Values& change)
{
  if (!answer.solved && method_ != Method::Direct && DirectSolver::available() &&
      direct_.analyse(matrix_) <= mostOperationsAtLast)
  {
    method_ = Method::Direct;
    answer = solveDirectly(symmetric);
  }
  for (int k = 0; k < matrix_.rows(); ++k)
    if (held_(k) == 0)
      change(k) = x_(k);
  return answer;
}

template <int D>
const char* LinearSystem<D>::method() const
{
  switch (method_)
  {
  case Method::Direct:
    return "direct (MUMPS)";
  case Method::Multigrid:
    return "conjugate gradients with multigrid (MueLu)";
  case Method::Diagonal:
    return "conjugate gradients with the diagonal";
  case Method::Unknown:
    break;
  }
  return "none";
}

template class LinearSystem<2>;
template class LinearSystem<3>;

} // namespace Rhegma::equilibrium
