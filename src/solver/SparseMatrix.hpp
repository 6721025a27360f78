#pragma once
/// A sparse matrix, by rows.

#include "base/Types.hpp"
#include "parallel/Ranks.hpp"

namespace Rhegma
{

/// Square, with ascending columns in each row and an entry on each diagonal. Of a matrix on several ranks,
/// the rows of this one: column k is row k of this rank or, beyond its rows, one of another rank.
struct SparseMatrix
{
  View<std::size_t*> first; ///< of each row in `column` and `value`; one more at the end
  View<int*> column;
  View<double*> value;
  Ranks ranks = {};             ///< one by default
  View<long long*> number = {}; ///< of each column among the unknowns of all ranks, where those of a rank are
                                ///< consecutive and ranks ascend; empty with one rank

  int rows() const { return first.extent(0) == 0 ? 0 : static_cast<int>(first.extent(0)) - 1; }

  /// Number of a column among the unknowns of all ranks.
  long long numberOf(int k) const { return number.extent(0) == 0 ? k : number(k); }

  /// y = A x \param x of all columns
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
