#pragma once
/// The sparse matrix of an equilibrium, from the stiffness of its rows.

#include "equilibrium/Particles.hpp"
#include "equilibrium/RowOwners.hpp"
#include "solver/ColumnValues.hpp"

#include <memory>

namespace Rhegma::equilibrium
{

/// The matrix of the unknowns of one graph. On several ranks each has the rows that it owns.
template <int D>
class SystemMatrix
{
public:
  /// \param graph of the rows that this rank knows \param owners of them, which must outlive this
  SystemMatrix(const RowGraph& graph, const RowOwners& owners);

  /// Finds the columns of all rows. Before that only `own` and `graph` can be called. Collective.
  void build();
  bool isBuilt() const { return columns_ != nullptr; }

  /// Takes the values of a stiffness. Rows and columns of unknowns that are held are those of the diagonal
  /// alone. \param stiffness complete for the rows that this rank owns \param held whether each unknown is
  void fill(const StiffnessBlocks& stiffness, const View<char*>& held);

  /// Right side of the unknowns of this rank: forces, less those by the change of held unknowns; zero where
  /// held. \param stiffness, held as in `fill` \param right forces on all unknowns \param change of held
  /// unknowns \param b gets the right side, by rows of the matrix
  void moveHeldToRight(const StiffnessBlocks& stiffness, const View<char*>& held, const Values& right,
                       const Values& change, const Values& b) const;

  /// y = A x \param x, y of this rank's rows. Collective.
  void multiply(const BorrowedView<const double*>& x, const BorrowedView<double*>& y) const
  {
    matrix_.multiply(columns_->of(x), y);
  }

  const RowGraph& graph() const { return graph_; }
  const SparseMatrix& sparse() const { return matrix_; }
  /// Unknowns of this rank.
  int rows() const { return D * static_cast<int>(own_.extent(0)); }
  /// Unknown, among those of the graph, of a row of the matrix.
  int unknownOf(int row) const { return D * own_(row / D) + row % D; }

private:
  RowGraph graph_;
  const RowOwners& owners_;
  View<int*> own_;        ///< rows of this rank, which are those of the matrix, one after another
  View<int*> entryBegin_; ///< of each of them in `entry_`; one more at the end
  View<int*> entry_;      ///< of the graph, in the order of the matrix
  SparseMatrix matrix_;
  std::unique_ptr<ColumnValues> columns_;
};

} // namespace Rhegma::equilibrium
