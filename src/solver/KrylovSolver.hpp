#pragma once
/// Belos' conjugate gradients and GMRES on vectors of Tpetra; their headers are included in one source file
/// only.

#include "base/Types.hpp"
#include "parallel/Ranks.hpp"

#include <functional>
#include <memory>

namespace Rhegma
{

/// Result of a solve.
struct SolveResult
{
  bool converged = false;
  bool singular = false; ///< p A p <= 0 for a direction p of the search, or no basis is found
  int iterations = 0;
  double residual = 0.0; ///< 2-norm of the residual
};

/// What a solve does when the process is asked to stop (base/StopRequest.hpp).
enum class OnStopRequest
{
  GoOn,
  Throw ///< StopRequested, after some iterations, on all ranks
};

/// How many vectors GMRES stores at most for its basis: it then restarts from the solution so far. Their
/// memory is that of a matrix with 67 entries a row: the stiffness of equilibrium has 18 to 50 in 2D and 81
/// to 375 in 3D.
constexpr int mostBasisVectors = 100;

/// Preconditioned conjugate gradients for a symmetric positive definite operator, and restarted GMRES (Saad
/// and Schultz, SIAM J. Sci. Stat. Comput. 7 (1986) 856) for any other. Vectors, problem and managers are
/// made once and serve every solve of the same size; those of GMRES with its first solve.
class KrylovSolver
{
public:
  /// y = A x
  using Apply = std::function<void(const BorrowedView<const double*>& x, const BorrowedView<double*>& y)>;

  /// \param tolerance of the 2-norm of the residual, next to a right side of a size about one
  /// \param onStopRequest for solves that take long
  KrylovSolver(double tolerance, int maximumIterations, OnStopRequest onStopRequest = OnStopRequest::GoOn);
  ~KrylovSolver();
  KrylovSolver(const KrylovSolver&) = delete;
  KrylovSolver& operator=(const KrylovSolver&) = delete;

  double tolerance() const { return tolerance_; }

  /// Allocates vectors of n unknowns on this rank if the size has changed on some rank; dot products are sums
  /// over the ranks. Collective.
  void resize(int n, const Ranks& ranks = {});

  /// The right-hand side, to be filled before solve().
  BorrowedView<double*> right();

  /// The solution of solve().
  BorrowedView<const double*> solution() const;

  /// Finds x with A x = right() from x = 0, by conjugate gradients. \param precondition called once for the
  /// first residual and for each after \param most iterations; 0: the maximum
  SolveResult solve(Apply apply, Apply precondition, int most = 0);

  /// The same for an operator that need not be symmetric, by GMRES, preconditioned from the right.
  SolveResult solveUnsymmetric(Apply apply, Apply precondition, int most = 0);

private:
  class Workspace;
  double tolerance_;
  int maximumIterations_;
  OnStopRequest onStopRequest_;
  std::unique_ptr<Workspace> workspace_;
};

} // namespace Rhegma
