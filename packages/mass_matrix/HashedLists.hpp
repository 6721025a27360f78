#pragma once
/// Lists of single entries that find their columns by hashing, where cells are refined.

#include "mass_matrix/MassSystem.hpp"

namespace Rhegma::mass_matrix
{

/// Largest used fraction of a list: fuller lists take long to search.
constexpr double fullestList = 0.7;

/// Adds to the entry of a column in a list of `capacity` positions, a power of two; free positions have the
/// column -1. \return false where the list is full
KOKKOS_INLINE_FUNCTION bool addHashed(double* values, int* columns, int capacity, int column, double value)
{
  const unsigned mask = static_cast<unsigned>(capacity) - 1U;
  // Knuth, The Art of Computer Programming 3, section 6.4: multiplicative hashing and linear probing.
  unsigned at = (static_cast<unsigned>(column) * 2654435769U) >> 16U;
  for (int tries = 0; tries < capacity; ++tries, ++at)
  {
    const unsigned k = at & mask;
    if (columns[k] != column)
    {
      if (columns[k] >= 0)
        continue;
      columns[k] = column;
      values[k] = 0.0;
    }
    values[k] += value;
    return true;
  }
  return false;
}

/// Moves the entries of a list to its front. \return their number
KOKKOS_INLINE_FUNCTION int packHashed(double* values, int* columns, int capacity)
{
  int kept = 0;
  for (int k = 0; k < capacity; ++k)
    if (columns[k] >= 0)
    {
      values[kept] = values[k];
      columns[kept++] = columns[k];
    }
  return kept;
}

} // namespace Rhegma::mass_matrix
