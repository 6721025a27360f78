#pragma once
/// Direct solution of sparse symmetric systems on this rank, by MUMPS where the library was built with it.

#include "solver/SparseMatrix.hpp"

#include <memory>

namespace Rhegma
{

/// Factorises a symmetric matrix, definite or not, as L D L^T by the multifrontal method (Amestoy, Duff,
/// L'Excellent and Koster, SIAM J. Matrix Anal. Appl. 23 (2001) 15).
class DirectSolver
{
public:
  /// Whether the library was built with MUMPS; without it no factorisation succeeds.
  static bool available();

  DirectSolver();
  ~DirectSolver();
  DirectSolver(const DirectSolver&) = delete;
  DirectSolver& operator=(const DirectSolver&) = delete;

  /// Orders the unknowns of a matrix, of which only the structure and the lower triangle are used.
  /// \return expected number of floating-point operations of a factorisation; infinity if there is no order
  double analyse(const SparseMatrix& matrix);

  /// Factorises the matrix that was analysed, with the values that it has now. \return false where it is
  /// singular or memory does not suffice
  bool factorise(const SparseMatrix& matrix);

  /// Negative eigenvalues of the last factorised matrix.
  int negativeEigenvalues() const;

  /// Solves with the last factorised matrix. \param x on entry the right side, on exit the solution
  void solve(const View<double*>& x);

private:
  struct Instance;
  std::unique_ptr<Instance> instance_;
};

} // namespace Rhegma
