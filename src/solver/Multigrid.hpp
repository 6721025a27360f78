#pragma once
/// Algebraic multigrid on this rank, by MueLu where Trilinos has it.

#include "solver/SparseMatrix.hpp"

#include <memory>
#include <vector>

namespace Rhegma
{

/// Smoothed aggregation (Vanek, Mandel and Brezina, Computing 56 (1996) 179) as a preconditioner of conjugate
/// gradients. Nodes are aggregated along the couplings of the matrix, so that nodes on both sides of a crack
/// stay apart. On several ranks each has a multigrid of the couplings among its own rows (block Jacobi), so
/// that the number of iterations grows with the ranks, and no message is sent.
class Multigrid
{
public:
  /// Whether the Trilinos that the library was built with has MueLu; without it there is no instance.
  static bool available();

  /// \param matrix symmetric, positive definite; its arrays are shared, not copied, unless rows are weak or
  /// coupled with other ranks
  /// \param perNode unknowns of a node, next to each other
  /// \param rigidMotions vectors of this rank's rows whose energy is zero but for supports, which coarse
  /// levels represent
  Multigrid(const SparseMatrix& matrix, int perNode, const std::vector<std::vector<double>>& rigidMotions);
  ~Multigrid();
  Multigrid(const Multigrid&) = delete;
  Multigrid& operator=(const Multigrid&) = delete;

  /// y = one cycle applied to x.
  void apply(const BorrowedView<const double*>& x, const BorrowedView<double*>& y) const;

private:
  struct Hierarchy;
  std::unique_ptr<Hierarchy> hierarchy_;
};

} // namespace Rhegma
