#pragma once
/// Direct solution of sparse systems, by MUMPS where the library was built with it.

#include "solver/SparseMatrix.hpp"

#include <memory>
#include <string>

namespace Rhegma
{

/// Factorises a matrix, definite or not, as L D L^T if it is symmetric and as L U if it is not, by the
/// multifrontal method (Amestoy, Duff, L'Excellent and Koster, SIAM J. Matrix Anal. Appl. 23 (2001) 15).
/// Ranks factorise a matrix together; right sides and solutions pass through the first one. All calls that
/// take a matrix or a right side, and the destructor, are collective over the matrix' ranks.
class DirectSolver
{
public:
  /// Whether the library was built with MUMPS; without it no factorisation succeeds.
  static bool available();

  explicit DirectSolver(bool symmetric = true);
  ~DirectSolver();
  DirectSolver(const DirectSolver&) = delete;
  DirectSolver& operator=(const DirectSolver&) = delete;

  /// Orders the unknowns of a matrix, of which the structure is used, and of a symmetric one only
  /// the lower triangle.
  /// \return expected number of floating-point operations of a factorisation; infinity if there is no order
  double analyse(const SparseMatrix& matrix);

  /// Factorises the matrix that was analysed, with the values that it has now. \return false where it is
  /// singular or memory does not suffice
  bool factorise(const SparseMatrix& matrix);

  /// Why the last factorisation failed, where memory did not suffice; else empty.
  std::string failure() const;

  /// Negative eigenvalues of the last factorised matrix; 0 where it is not symmetric.
  int negativeEigenvalues() const;

  /// Solves with the last factorised matrix. \param x on entry the right side of this rank's rows, on exit
  /// the solution
  void solve(const View<double*>& x);

private:
  struct Instance;
  bool symmetric_;
  std::unique_ptr<Instance> instance_;
};

} // namespace Rhegma
