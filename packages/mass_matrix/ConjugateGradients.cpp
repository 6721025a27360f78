#include "mass_matrix/ConjugateGradients.hpp"

#include <BelosLinearProblem.hpp>
#include <BelosPseudoBlockCGSolMgr.hpp>
#include <BelosTpetraAdapter.hpp>
#include <Teuchos_DefaultSerialComm.hpp>
#include <Teuchos_oblackholestream.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Operator.hpp>
#include <Tpetra_Vector.hpp>

#include <stdexcept>
#include <utility>

namespace Rhegma::mass_matrix
{

namespace
{

using Map = Tpetra::Map<>;
using MultiVector = Tpetra::MultiVector<double>;
using Operator = Tpetra::Operator<double>;
using Solver = Belos::PseudoBlockCGSolMgr<double, MultiVector, Operator>;
using Problem = Belos::LinearProblem<double, MultiVector, Operator>;
using Teuchos::RCP;
using Teuchos::rcp;

/// The numbers of a vector of Tpetra with one column.
template <class Column>
auto borrow(const Column& column)
{
  using Value = typename Column::value_type;
  return BorrowedView<Value*>(column.data(), column.extent(0));
}

/// y = alpha f(x) + beta y for each column, as Tpetra asks.
class FunctionOperator : public Operator
{
public:
  FunctionOperator(RCP<const Map> map, ConjugateGradients::Apply apply)
      : map_(std::move(map)), apply_(std::move(apply)), image_(map_, 1)
  {
  }
  RCP<const Map> getDomainMap() const override { return map_; }
  RCP<const Map> getRangeMap() const override { return map_; }
  void apply(const MultiVector& x, MultiVector& y, Teuchos::ETransp, double alpha, double beta) const override
  {
    for (std::size_t c = 0; c < x.getNumVectors(); ++c)
    {
      const auto from = x.getVector(c);
      const auto to = y.getVectorNonConst(c);
      if (alpha == 1.0 && beta == 0.0)
        applyTo(*from, *to);
      else
      {
        applyTo(*from, image_);
        to->update(alpha, image_, beta);
      }
    }
  }

private:
  void applyTo(const MultiVector& from, MultiVector& to) const
  {
    const auto x = Kokkos::subview(from.getLocalViewDevice(Tpetra::Access::ReadOnly), Kokkos::ALL(), 0);
    const auto y = Kokkos::subview(to.getLocalViewDevice(Tpetra::Access::OverwriteAll), Kokkos::ALL(), 0);
    apply_(borrow(x), borrow(y));
  }

  RCP<const Map> map_;
  ConjugateGradients::Apply apply_;
  mutable MultiVector image_;
};

void copyIn(const View<double*>& from, MultiVector& to, int n)
{
  const auto column = Kokkos::subview(to.getLocalViewDevice(Tpetra::Access::OverwriteAll), Kokkos::ALL(), 0);
  Kokkos::parallel_for(
      "rhegma::mass::copyIn", Kokkos::RangePolicy<ExecSpace>(0, n),
      KOKKOS_LAMBDA(const int i) { column(i) = from(i); });
}

void copyOut(const MultiVector& from, const View<double*>& to, int n)
{
  const auto column = Kokkos::subview(from.getLocalViewDevice(Tpetra::Access::ReadOnly), Kokkos::ALL(), 0);
  Kokkos::parallel_for(
      "rhegma::mass::copyOut", Kokkos::RangePolicy<ExecSpace>(0, n),
      KOKKOS_LAMBDA(const int i) { to(i) = column(i); });
}

} // namespace

/// Vectors and solver, kept between solves of the same size.
class ConjugateGradients::Work
{
public:
  explicit Work(int n)
      : size(n),
        map(rcp(new Map(static_cast<Tpetra::global_size_t>(n), 0, rcp(new Teuchos::SerialComm<int>())))),
        left(rcp(new MultiVector(map, 1))),
        right(rcp(new MultiVector(map, 1)))
  {
  }
  int size;
  RCP<const Map> map;
  RCP<MultiVector> left, right;
  Solver solver;
};

ConjugateGradients::ConjugateGradients(double tolerance, int maximumIterations)
    : tolerance_(tolerance), maximumIterations_(maximumIterations)
{
}

ConjugateGradients::~ConjugateGradients() = default;

SolveResult ConjugateGradients::solve(int n, const Apply& apply, const View<double*>& inverseDiagonal,
                                      const View<double*>& right, double scale, const View<double*>& x)
{
  SolveResult result;
  Kokkos::parallel_for(
      "rhegma::mass::clearSolution", Kokkos::RangePolicy<ExecSpace>(0, n),
      KOKKOS_LAMBDA(const int i) { x(i) = 0.0; });
  const double norm = norm2(right, n);
  result.residual = scale > 0.0 ? norm / scale : 0.0;
  result.converged = norm <= tolerance_ * scale;
  if (result.converged || !std::isfinite(norm))
    return result;

  if (!work_ || work_->size != n)
    work_ = std::make_unique<Work>(n);
  Work& work = *work_;
  copyIn(right, *work.right, n);
  work.left->putScalar(0.0);
  const auto divide =
      [inverseDiagonal, n](const BorrowedView<const double*>& from, const BorrowedView<double*>& to)
  {
    Kokkos::parallel_for(
        "rhegma::mass::precondition", Kokkos::RangePolicy<ExecSpace>(0, n),
        KOKKOS_LAMBDA(const int i) { to(i) = inverseDiagonal(i) * from(i); });
  };
  const RCP<Problem> problem =
      rcp(new Problem(rcp(new FunctionOperator(work.map, apply)), work.left, work.right));
  problem->setLeftPrec(rcp(new FunctionOperator(work.map, divide)));
  problem->setHermitian();
  problem->setProblem();
  const RCP<Teuchos::ParameterList> settings = Teuchos::parameterList();
  // The residual that the solver starts with is `norm`, as x starts from zero.
  settings->set("Convergence Tolerance", tolerance_ * scale / norm);
  settings->set("Maximum Iterations", maximumIterations_);
  settings->set("Verbosity", static_cast<int>(Belos::Errors));
  settings->set<RCP<std::ostream>>("Output Stream", rcp(new Teuchos::oblackholestream()));
  work.solver.setParameters(settings);
  work.solver.setProblem(problem);
  try
  {
    result.converged = work.solver.solve() == Belos::Converged;
  }
  catch (const std::logic_error&) // p^T A p is not positive: A is singular to round-off
  {
    return result;
  }
  result.iterations = work.solver.getNumIters();
  result.residual = work.solver.achievedTol() * norm / scale;
  copyOut(*work.left, x, n);
  return result;
}

double norm2(const View<double*>& values, int n)
{
  double square = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::mass::norm", Kokkos::RangePolicy<ExecSpace>(0, n),
      KOKKOS_LAMBDA(const int i, double& sum) { sum += values(i) * values(i); }, square);
  return std::sqrt(square);
}

} // namespace Rhegma::mass_matrix
