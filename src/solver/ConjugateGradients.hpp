#pragma once
/// Belos' conjugate gradients on vectors of Tpetra; their headers are included in one source file only.

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
  bool singular = false; ///< p A p <= 0 for a direction p of the search
  int iterations = 0;
  double residual = 0.0; ///< 2-norm of the residual
};

/// What a solve does when the process is asked to stop (base/StopRequest.hpp).
enum class OnStopRequest
{
  GoOn,
  Throw ///< StopRequested, after some iterations, on all ranks
};

/// Preconditioned conjugate gradients for a symmetric positive definite operator. Vectors, problem and
/// manager are made once and serve every solve of the same size.
class ConjugateGradients
{
public:
  /// y = A x
  using Apply = std::function<void(const BorrowedView<const double*>& x, const BorrowedView<double*>& y)>;

  /// \param tolerance of the 2-norm of the residual, next to a right side of a size about one
  /// \param onStopRequest for solves that take long
  ConjugateGradients(double tolerance, int maximumIterations,
                     OnStopRequest onStopRequest = OnStopRequest::GoOn);
  ~ConjugateGradients();
  ConjugateGradients(const ConjugateGradients&) = delete;
  ConjugateGradients& operator=(const ConjugateGradients&) = delete;

  double tolerance() const { return tolerance_; }

  /// Allocates vectors of n unknowns on this rank if the size has changed on some rank; dot products are sums
  /// over the ranks. Collective.
  void resize(int n, const Ranks& ranks = {});

  /// The right-hand side, to be filled before solve().
  BorrowedView<double*> right();

  /// The solution of solve().
  BorrowedView<const double*> solution() const;

  /// Finds x with A x = right() from x = 0. \param precondition called once for the first residual and for
  /// each after \param most iterations; 0: the maximum
  SolveResult solve(Apply apply, Apply precondition, int most = 0);

private:
  class Workspace;
  double tolerance_;
  int maximumIterations_;
  OnStopRequest onStopRequest_;
  std::unique_ptr<Workspace> workspace_;
};

} // namespace Rhegma
