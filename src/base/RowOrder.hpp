#pragma once
/// Rows of tables in another order.

#include "base/Types.hpp"

#include <string>

namespace Rhegma
{

/// Row i of `to` = row order(i) of `from`, and zero where that has no such row. \param columns of both;
/// \tparam Width the same, or 0 where it is not known to the compiler
template <int Width, class T>
void copyRows(const T* from, T* to, const View<int*>& order, int known, int columns)
{
  const int rows = static_cast<int>(order.extent(0));
  Kokkos::parallel_for(
      "rhegma::inOrder", Kokkos::RangePolicy<ExecSpace>(0, rows), KOKKOS_LAMBDA(const int i) {
        const int width = Width > 0 ? Width : columns, row = order(i);
        if (row < 0 || row >= known)
          for (int c = 0; c < width; ++c)
            to[i * width + c] = 0;
        else
          for (int c = 0; c < width; ++c)
            to[i * width + c] = from[row * width + c];
      });
}

/// The same, for tables of any width.
template <class T>
void copyRows(const T* from, T* to, const View<int*>& order, int known, int columns)
{
  if (columns == 1)
    copyRows<1>(from, to, order, known, columns);
  else if (columns == 2)
    copyRows<2>(from, to, order, known, columns);
  else if (columns == 3)
    copyRows<3>(from, to, order, known, columns);
  else if (columns == 4)
    copyRows<4>(from, to, order, known, columns);
  else if (columns == 5)
    copyRows<5>(from, to, order, known, columns);
  else if (columns == 6)
    copyRows<6>(from, to, order, known, columns);
  else if (columns == 9)
    copyRows<9>(from, to, order, known, columns);
  else
    copyRows<0>(from, to, order, known, columns);
}

/// A table whose row i is row order(i) of another, and zero where that has no such row.
/// \param known rows of the other that have values \param spare rows without values after the last
template <class Data>
View<Data> inOrder(const View<Data>& old, const View<int*>& order, int known, int spare)
{
  const int rows = static_cast<int>(order.extent(0));
  const auto how = Kokkos::view_alloc(old.label().empty() ? std::string("rhegma::inOrder") : old.label(),
                                      Kokkos::WithoutInitializing);
  View<Data> fresh;
  if constexpr (View<Data>::rank_dynamic == 2)
    fresh = View<Data>(how, rows + spare, old.extent(1));
  else
    fresh = View<Data>(how, rows + spare);
  copyRows(old.data(), fresh.data(), order, known,
           View<Data>::rank == 2 ? static_cast<int>(old.extent(1)) : 1);
  return fresh;
}

/// The same of a table all of whose rows have values, without spare rows.
template <class Data>
View<Data> inOrder(const View<Data>& old, const View<int*>& order)
{
  return inOrder(old, order, static_cast<int>(old.extent(0)), 0);
}

} // namespace Rhegma
