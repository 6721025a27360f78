#include "solver/ConjugateGradients.hpp"

#include "parallel/StopTogether.hpp"

#include <BelosBlockCGSolMgr.hpp>
#include <BelosLinearProblem.hpp>
#include <BelosTpetraAdapter.hpp>
#include <Teuchos_DefaultSerialComm.hpp>
#include <Teuchos_oblackholestream.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Operator.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace Rhegma
{

namespace
{

using Map = Tpetra::Map<>;
using MultiVector = Tpetra::MultiVector<double>;
using Operator = Tpetra::Operator<double>;
using Solver = Belos::BlockCGSolMgr<double, MultiVector, Operator>;
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
  void set(ConjugateGradients::Apply function) { function_ = std::move(function); }
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
  ConjugateGradients::Apply function_;
};

/// Products after which ranks that give up together ask one another.
constexpr int productsBetweenRequests = 50;

/// The same product, which throws StopRequested. One rank asks at each product, as multigrid may take long.
ConjugateGradients::Apply stoppable(ConjugateGradients::Apply apply, const Ranks& ranks)
{
  return [=, products = 0](const auto& x, const auto& y) mutable
  {
    if (!ranks.many() || ++products % productsBetweenRequests == 0)
      stopTogetherIfRequested(ranks);
    apply(x, y);
  };
}

} // namespace

/// Vectors, problem and manager of solves of one size.
class ConjugateGradients::Workspace
{
public:
  Workspace(int n, const Ranks& ranks, double tolerance, int maximumIterations)
      : size(n),
        ranks(ranks),
        map(makeMap(n, ranks)),
        left(rcp(new MultiVector(map, 1))),
        right(rcp(new MultiVector(map, 1))),
        matrix(rcp(new FunctionOperator(map))),
        preconditioner(rcp(new FunctionOperator(map))),
        problem(rcp(new Problem(matrix, left, right)))
  {
    // Right preconditioning: avoids an unused preconditioned first residual.
    problem->setRightPrec(preconditioner);
    problem->setHermitian();
    problem->setProblem();
    const RCP<Teuchos::ParameterList> settings = Teuchos::parameterList();
    settings->set("Block Size", 1); // for which the manager uses plain conjugate gradients
    settings->set("Convergence Tolerance", tolerance);
    settings->set("Implicit Residual Scaling", "None");
    settings->set("Verbosity", static_cast<int>(Belos::Errors));
    settings->set<RCP<std::ostream>>("Output Stream", rcp(new Teuchos::oblackholestream()));
    solver.setParameters(settings);
    setMost(maximumIterations);
    solver.setProblem(problem);
  }

  void setMost(int iterations)
  {
    if (iterations == most)
      return;
    const RCP<Teuchos::ParameterList> settings = Teuchos::parameterList();
    settings->set("Maximum Iterations", most = iterations);
    solver.setParameters(settings);
  }

  int size, most = 0;
  Ranks ranks;
  RCP<const Map> map;
  RCP<MultiVector> left, right;
  RCP<FunctionOperator> matrix, preconditioner;
  RCP<Problem> problem;
  Solver solver;
};

ConjugateGradients::ConjugateGradients(double tolerance, int maximumIterations, OnStopRequest onStopRequest)
    : tolerance_(tolerance), maximumIterations_(maximumIterations), onStopRequest_(onStopRequest)
{
}

ConjugateGradients::~ConjugateGradients() = default;

void ConjugateGradients::resize(int n, const Ranks& ranks)
{
  if (ranks.max(!workspace_ || workspace_->size != n ? 1.0 : 0.0) > 0.0)
    workspace_ = std::make_unique<Workspace>(n, ranks, tolerance_, maximumIterations_);
}

BorrowedView<double*> ConjugateGradients::right() { return overwrite(*workspace_->right); }

BorrowedView<const double*> ConjugateGradients::solution() const { return read(*workspace_->left); }

SolveResult ConjugateGradients::solve(Apply apply, Apply precondition, int most)
{
  Workspace& workspace = *workspace_;
  SolveResult result;
  workspace.left->putScalar(0.0);
  // The first residual is the right-hand side: no product with the zero vector.
  workspace.matrix->set({});
  workspace.problem->setProblem();
  workspace.setMost(most > 0 ? std::min(most, maximumIterations_) : maximumIterations_);
  if (onStopRequest_ == OnStopRequest::Throw)
    apply = stoppable(std::move(apply), workspace.ranks);
  workspace.matrix->set(std::move(apply));
  workspace.preconditioner->set(std::move(precondition));
  try
  {
    result.converged = workspace.solver.solve() == Belos::Converged;
  }
  catch (const Belos::CGIterateFailure&) // p^T A p is not positive: A is singular to round-off
  {
    result.singular = true;
    result.residual = workspace.right->getVector(0)->norm2();
    workspace.left->putScalar(0.0);
    return result;
  }
  result.iterations = workspace.solver.getNumIters();
  result.residual = workspace.solver.achievedTol();
  return result;
}

} // namespace Rhegma
