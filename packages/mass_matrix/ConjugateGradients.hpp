#pragma once
/// Belos' conjugate gradients on vectors of Tpetra, behind a wall: only one source file pays for their
/// headers.

#include "state/Types.hpp"

#include <functional>
#include <memory>

namespace Rhegma::mass_matrix
{

/// How a solve ended.
struct SolveResult
{
  bool converged = false;
  int iterations = 0;
  double residual = 0.0; ///< 2-norm of what is left of the right side, over the scale that was given
};

/// Preconditioned conjugate gradients for a symmetric positive definite operator.
class ConjugateGradients
{
public:
  /// y = A x
  using Apply = std::function<void(const BorrowedView<const double*>& x, const BorrowedView<double*>& y)>;

  /// \param tolerance of the 2-norm of the residual, over `scale` of solve()
  ConjugateGradients(double tolerance, int maximumIterations);
  ~ConjugateGradients();
  ConjugateGradients(const ConjugateGradients&) = delete;
  ConjugateGradients& operator=(const ConjugateGradients&) = delete;

  /// Finds x from x = 0. \param n unknowns \param inverseDiagonal preconditioner, n values \param scale
  /// 2-norm that residuals are compared with. Nothing is done where the right side itself is below the
  /// tolerance.
  SolveResult solve(int n, const Apply& apply, const View<double*>& inverseDiagonal,
                    const View<double*>& right, double scale, const View<double*>& x);

private:
  class Work;
  double tolerance_;
  int maximumIterations_;
  std::unique_ptr<Work> work_;
};

/// 2-norm of the first n values.
double norm2(const View<double*>& values, int n);

} // namespace Rhegma::mass_matrix
