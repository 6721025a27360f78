#pragma once
/// Values of the columns of a matrix on several ranks.

#include "solver/SparseMatrix.hpp"

#include <memory>

namespace Rhegma
{

/// Brings values of unknowns of other ranks to the rows that are coupled with them.
class ColumnValues
{
public:
  /// \param matrix of which the columns count. Collective.
  explicit ColumnValues(const SparseMatrix& matrix);
  ~ColumnValues();
  ColumnValues(const ColumnValues&) = delete;
  ColumnValues& operator=(const ColumnValues&) = delete;

  /// Values of all columns from those of this rank's rows; these themselves with one rank. Valid until the
  /// next call. Collective.
  BorrowedView<const double*> of(const BorrowedView<const double*>& own) const;

private:
  struct Exchange;
  std::unique_ptr<Exchange> exchange_; ///< null with one rank
};

} // namespace Rhegma
