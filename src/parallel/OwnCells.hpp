#pragma once
/// The cells that this rank owns.

#include "grid/Grid.hpp"

namespace Rhegma
{

/// The cells that a rank owns, for kernels: each position, also outside of the domain, belongs to exactly one
/// rank.
template <int D>
struct OwnCells
{
  Grid<D> lattice;         ///< of the whole domain
  View<int* [2][D]> boxes; ///< first cells, and those beyond the last, of the ranks up to this one
  int rank = 0;

  /// Whether a position lies in a cell of this rank; one outside of the domain in the cell nearest to it.
  KOKKOS_INLINE_FUNCTION bool hold(const Vector<D>& x) const
  {
    if (boxes.extent(0) == 0)
      return true;
    // A cell in several boxes belongs to the first of their ranks.
    for (int r = 0; r < rank; ++r)
      if (boxHolds(r, x))
        return false;
    return boxHolds(rank, x);
  }

private:
  KOKKOS_INLINE_FUNCTION bool boxHolds(int r, const Vector<D>& x) const
  {
    bool in = true;
    for (int d = 0; d < D; ++d)
    {
      const int last = lattice.cells[d] - gridMargin - 1;
      const int at = static_cast<int>(std::floor(lattice.inCells(x[d], d)));
      const int cell = at < gridMargin ? gridMargin : (at > last ? last : at);
      in = in && cell >= boxes(r, 0, d) && cell < boxes(r, 1, d);
    }
    return in;
  }
};

} // namespace Rhegma
