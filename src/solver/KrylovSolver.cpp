#include "solver/KrylovSolver.hpp"

#include "parallel/StopTogether.hpp"

#include <BelosBlockCGSolMgr.hpp>
#include <BelosBlockGmresSolMgr.hpp>
#include <BelosLinearProblem.hpp>
#include <BelosTpetraAdapter.hpp>
#include <Teuchos_DefaultSerialComm.hpp>
#include <Teuchos_oblackholestream.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Operator.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace Rhegma
{

namespace
{

using Map = Tpetra::Map<>;
using MultiVector = Tpetra::MultiVector<double>;
using Operator = Tpetra::Operator<double>;
using Manager = Belos::SolverManager<double, MultiVector, Operator>;
using Gradients = Belos::BlockCGSolMgr<double, MultiVector, Operator>;
using Gmres = Belos::BlockGmresSolMgr<double, MultiVector, Operator>;
using Problem = Belos::LinearProblem<double, MultiVector, Operator>;
using Teuchos::RCP;
using Teuchos::rcp;

BorrowedView<const double*> read(const MultiVector& from)
{
  const auto column = Kokkos::subview(from.getLocalViewDevice(Tpetra::Access::ReadOnly), Kokkos::ALL(), 0);
  return BorrowedView<const double*>(column.data(), column.extent(0));
}

BorrowedView<double*> overwrite(MultiVector& to)
{
  const auto column = Kokkos::subview(to.getLocalViewDevice(Tpetra::Access::OverwriteAll), Kokkos::ALL(), 0);
  return BorrowedView<double*>(column.data(), column.extent(0));
}

RCP<const Map> makeMap(int n, const Ranks& ranks)
{
  if (!ranks.many())
    return rcp(new Map(static_cast<Tpetra::global_size_t>(n), 0, rcp(new Teuchos::SerialComm<int>())));
  return rcp(new Map(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(), static_cast<std::size_t>(n), 0,
                     ranks.comm()));
}

/// y = f(x) for vectors of one column, f set anew for each solve; y = 0 while there is none.
class FunctionOperator : public Operator
{
public:
  explicit FunctionOperator(RCP<const Map> map) : map_(std::move(map)) {}
  RCP<const Map> getDomainMap() const override { return map_; }
  RCP<const Map> getRangeMap() const override { return map_; }
  void set(KrylovSolver::Apply function) { function_ = std::move(function); }
  void apply(const MultiVector& x, MultiVector& y, Teuchos::ETransp, double alpha, double beta) const override
  {
    if (alpha != 1.0 || beta != 0.0 || x.getNumVectors() != 1)
      throw std::logic_error("the operator supports y = A x for one vector only");
    if (function_)
      function_(read(x), overwrite(y));
    else
      y.putScalar(0.0);
  }

private:
  RCP<const Map> map_;
  KrylovSolver::Apply function_;
};

/// Products after which ranks that give up together ask one another.
constexpr int productsBetweenRequests = 50;

/// The same product, which throws StopRequested. One rank asks at each product, as multigrid may take long.
KrylovSolver::Apply stoppable(KrylovSolver::Apply apply, const Ranks& ranks)
{
  return [=, products = 0](const auto& x, const auto& y) mutable
  {
    if (!ranks.many() || ++products % productsBetweenRequests == 0)
      stopTogetherIfRequested(ranks);
    apply(x, y);
  };
}

} // namespace

/// Vectors, problem and managers of solves of one size.
class KrylovSolver::Workspace
{
public:
  Workspace(int n, const Ranks& ranks, double tolerance, int maximumIterations, OnStopRequest onStopRequest)
      : size(n),
        ranks(ranks),
        map(makeMap(n, ranks)),
        left(rcp(new MultiVector(map, 1))),
        right(rcp(new MultiVector(map, 1))),
        matrix(rcp(new FunctionOperator(map))),
        preconditioner(rcp(new FunctionOperator(map))),
        problem(rcp(new Problem(matrix, left, right))),
        tolerance_(tolerance),
        maximumIterations_(maximumIterations),
        onStopRequest_(onStopRequest)
  {
    // Right preconditioning: avoids an unused preconditioned first residual, and GMRES then knows the
    // residual itself.
    problem->setRightPrec(preconditioner);
    problem->setProblem();
  }

  /// \param most iterations; 0: the maximum
  SolveResult solve(Apply apply, Apply precondition, int most, Manager& manager)
  {
    if (onStopRequest_ == OnStopRequest::Throw)
      apply = stoppable(std::move(apply), ranks);
    left->putScalar(0.0);
    // The first residual is the right-hand side: no product with the zero vector.
    matrix->set({});
    problem->setProblem();
    const RCP<Teuchos::ParameterList> settings = Teuchos::parameterList();
    settings->set("Maximum Iterations", most > 0 ? std::min(most, maximumIterations_) : maximumIterations_);
    manager.setParameters(settings);
    matrix->set(std::move(apply));
    preconditioner->set(std::move(precondition));
    SolveResult result;
    result.converged = manager.solve() == Belos::Converged;
    result.iterations = manager.getNumIters();
    result.residual = manager.achievedTol();
    return result;
  }

  /// The result of a solve with a singular operator: x = 0.
  SolveResult failed()
  {
    SolveResult result;
    result.singular = true;
    result.residual = right->getVector(0)->norm2();
    left->putScalar(0.0);
    return result;
  }

  Manager& gradients()
  {
    problem->setHermitian(true);
    if (gradients_.is_null())
      gradients_ = make<Gradients>({});
    return *gradients_;
  }

  Manager& gmres()
  {
    problem->setHermitian(false);
    if (gmres_.is_null())
    {
      Teuchos::ParameterList own;
      own.set("Num Blocks", mostBasisVectors);
      own.set("Maximum Restarts", std::numeric_limits<int>::max()); // the iterations are limited
      own.set("Explicit Residual Scaling", "None");
      gmres_ = make<Gmres>(own);
    }
    return *gmres_;
  }

  int size;
  Ranks ranks;
  RCP<const Map> map;
  RCP<MultiVector> left, right;
  RCP<FunctionOperator> matrix, preconditioner;
  RCP<Problem> problem;

private:
  template <class AnyManager>
  RCP<Manager> make(const Teuchos::ParameterList& own) const
  {
    const RCP<Teuchos::ParameterList> settings = Teuchos::parameterList(own);
    settings->set("Block Size", 1); // for which CG is the plain one
    settings->set("Convergence Tolerance", tolerance_);
    settings->set("Implicit Residual Scaling", "None");
    settings->set("Verbosity", static_cast<int>(Belos::Errors));
    settings->set<RCP<std::ostream>>("Output Stream", rcp(new Teuchos::oblackholestream()));
    const RCP<Manager> manager = rcp(new AnyManager());
    manager->setParameters(settings);
    manager->setProblem(problem);
    return manager;
  }

  double tolerance_;
  int maximumIterations_;
  OnStopRequest onStopRequest_;
  RCP<Manager> gradients_, gmres_; ///< null until they are needed
};

KrylovSolver::KrylovSolver(double tolerance, int maximumIterations, OnStopRequest onStopRequest)
    : tolerance_(tolerance), maximumIterations_(maximumIterations), onStopRequest_(onStopRequest)
{
}

KrylovSolver::~KrylovSolver() = default;

void KrylovSolver::resize(int n, const Ranks& ranks)
{
  if (ranks.max(!workspace_ || workspace_->size != n ? 1.0 : 0.0) > 0.0)
    workspace_ = std::make_unique<Workspace>(n, ranks, tolerance_, maximumIterations_, onStopRequest_);
}

BorrowedView<double*> KrylovSolver::right() { return overwrite(*workspace_->right); }

BorrowedView<const double*> KrylovSolver::solution() const { return read(*workspace_->left); }

SolveResult KrylovSolver::solve(Apply apply, Apply precondition, int most)
{
  Workspace& workspace = *workspace_;
  try
  {
    return workspace.solve(std::move(apply), std::move(precondition), most, workspace.gradients());
  }
  catch (const Belos::CGIterateFailure&) // p^T A p is not positive: A is singular to round-off
  {
    return workspace.failed();
  }
}

SolveResult KrylovSolver::solveUnsymmetric(Apply apply, Apply precondition, int most)
{
  Workspace& workspace = *workspace_;
  try
  {
    return workspace.solve(std::move(apply), std::move(precondition), most, workspace.gmres());
  }
  catch (const Belos::BelosError&) // no basis: A is singular to round-off
  {
    return workspace.failed();
  }
}

} // namespace Rhegma
