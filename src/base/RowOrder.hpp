#pragma once
/// Rows of tables in another order.

#include "base/Types.hpp"

#include <string>

namespace Rhegma
{

/// A table whose row i is row order(i) of another, and zero where that has no such row (order(i) = -1).
template <class Data>
View<Data> inOrder(const View<Data>& old, const View<int*>& order)
{
  const int rows = static_cast<int>(order.extent(0)), known = static_cast<int>(old.extent(0));
  const auto how = Kokkos::view_alloc(old.label().empty() ? std::string("rhegma::inOrder") : old.label(),
                                      Kokkos::WithoutInitializing);
  View<Data> fresh;
  if constexpr (View<Data>::rank_dynamic == 2)
    fresh = View<Data>(how, rows, old.extent(1));
  else
    fresh = View<Data>(how, rows);
  const int columns = View<Data>::rank == 2 ? static_cast<int>(old.extent(1)) : 1;
  const auto* const from = old.data();
  auto* const to = fresh.data();
  Kokkos::parallel_for(
      "rhegma::inOrder", Kokkos::RangePolicy<ExecSpace>(0, rows), KOKKOS_LAMBDA(const int i) {
        const int row = order(i);
        for (int c = 0; c < columns; ++c)
          to[i * columns + c] = row >= 0 && row < known ? from[row * columns + c] : 0;
      });
  return fresh;
}

} // namespace Rhegma
