#pragma once
/// A sparse matrix of this rank, by rows.

#include "base/Types.hpp"

namespace Rhegma
{

/// Square, with ascending columns in each row and an entry on each diagonal.
struct SparseMatrix
{
  View<std::size_t*> first; ///< of each row in `column` and `value`; one more at the end
  View<int*> column;
  View<double*> value;

  int rows() const { return first.extent(0) == 0 ? 0 : static_cast<int>(first.extent(0)) - 1; }

  /// y = A x
  void multiply(const BorrowedView<const double*>& x, const BorrowedView<double*>& y) const
  {
    const auto firsts = first;
    const auto columns = column;
    const auto values = value;
    Kokkos::parallel_for(
        "rhegma::SparseMatrix::multiply", Kokkos::RangePolicy<ExecSpace>(0, rows()),
        KOKKOS_LAMBDA(const int r) {
          double sum = 0.0;
          for (std::size_t k = firsts(r); k < firsts(r + 1); ++k)
            sum += values(k) * x(columns(k));
          y(r) = sum;
        });
  }
};

} // namespace Rhegma
