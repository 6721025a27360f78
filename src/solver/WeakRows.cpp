#include "solver/WeakRows.hpp"

#include "solver/ColumnValues.hpp"

#include <algorithm>

namespace Rhegma
{

namespace
{

/// Fraction of the largest diagonal entry below which a row is weak. Rows between it and one belong to cells
/// that an edge cuts, and need the coarse levels: with 1e-4, blocks anywhere in their cells take two to three
/// times the iterations.
constexpr double weakDiagonal = 1e-11;

} // namespace

View<double*> withoutWeakRows(const SparseMatrix& matrix)
{
  const int n = matrix.rows();
  const View<double*> own("rhegma::Multigrid::diagonal", n);
  double largest = 0.0;
  for (int r = 0; r < n; ++r)
    for (std::size_t k = matrix.first(r); k < matrix.first(r + 1); ++k)
      if (matrix.column(k) == r)
        largest = std::max(largest, own(r) = matrix.value(k));
  const double least = weakDiagonal * matrix.ranks.max(largest);
  const ColumnValues columns(matrix);
  const BorrowedView<const double*> diagonal =
      columns.of(BorrowedView<const double*>(own.data(), own.extent(0)));
  const auto weak = [&](int column) { return diagonal(column) < least; };
  bool any = false;
  for (std::size_t k = 0; k < diagonal.extent(0); ++k)
    any = any || weak(static_cast<int>(k));
  if (!any)
    return matrix.value;
  View<double*> value("rhegma::Multigrid::value", matrix.value.extent(0));
  for (int r = 0; r < n; ++r)
    for (std::size_t k = matrix.first(r); k < matrix.first(r + 1); ++k)
      value(k) = matrix.column(k) != r && (weak(r) || weak(matrix.column(k))) ? 0.0 : matrix.value(k);
  return value;
}

} // namespace Rhegma
