#pragma once
/// The multigrid of an earlier system as a preconditioner of one with other rows.

#include "equilibrium/Particles.hpp"
#include "solver/Multigrid.hpp"

namespace Rhegma::equilibrium
{

/// Where the unknowns of a system are in an earlier one: particles that have moved in a load step see some
/// more nodes. The multigrid of the earlier system is applied to the unknowns of both, the diagonal to
/// others, which leaves the preconditioner symmetric and positive definite.
struct EarlierRows
{
  View<int*> unknown; ///< of the earlier system, or -1
  Values in, out;     ///< values of the unknowns of the earlier system
  bool used = false;  ///< on all ranks or none; not where the multigrid is of this system

  /// Collective. \param now nodes of the rows of this rank, ascending \param earlier the same of the earlier
  /// system \param perNode unknowns of a row \return nothing where too many rows are new
  static EarlierRows match(const Ranks& ranks, const std::vector<int>& now, const std::vector<int>& earlier,
                           int perNode);

  bool any() const { return used; }

  /// y = one cycle for x, by the multigrid of the earlier system and the diagonal of this one.
  void apply(const Multigrid& multigrid, const View<double*>& diagonal, const BorrowedView<const double*>& x,
             const BorrowedView<double*>& y) const;
};

/// y = x / diagonal
void divideByDiagonal(const View<double*>& diagonal, const BorrowedView<const double*>& x,
                      const BorrowedView<double*>& y);

} // namespace Rhegma::equilibrium
