#pragma once
/// Algebraic multigrid, by MueLu where Trilinos has it, else by hypre.

#include "solver/SparseMatrix.hpp"

#include <memory>
#include <vector>

namespace Rhegma
{

/// A preconditioner of conjugate gradients: smoothed aggregation by MueLu (Vanek, Mandel and Brezina,
/// Computing 56 (1996) 179), or BoomerAMG of hypre with interpolated rotations (Baker, Kolev and Yang, Numer.
/// Linear Algebra Appl. 17 (2010) 495). Nodes are aggregated along the couplings of the matrix, so that nodes
/// on both sides of a crack stay apart. Aggregates of MueLu do not cross ranks; its small levels are on fewer
/// ranks, the coarsest on one. Errors must be met on all ranks or none: callers ask all of them afterwards.
class Multigrid
{
public:
  using Vectors = std::vector<std::vector<double>>;

  /// Whether the library was built with MueLu or hypre; without them there is no instance.
  static bool available();
  static const char* name();

  /// Collective. \param matrix symmetric, positive definite; its arrays are shared, not copied, unless rows
  /// are weak
  /// \param perNode unknowns of a node, next to each other
  /// \param rigidMotions vectors of this rank's rows whose energy is zero but for supports, which coarse
  /// levels represent \param coordinates of this rank's nodes along each axis; needed with several ranks
  Multigrid(const SparseMatrix& matrix, int perNode, const Vectors& rigidMotions,
            const Vectors& coordinates = {});
  ~Multigrid();
  Multigrid(const Multigrid&) = delete;
  Multigrid& operator=(const Multigrid&) = delete;

  /// y = one cycle applied to x. Collective.
  void apply(const BorrowedView<const double*>& x, const BorrowedView<double*>& y) const;

private:
  struct Hierarchy;
  std::unique_ptr<Hierarchy> hierarchy_;
};

} // namespace Rhegma
