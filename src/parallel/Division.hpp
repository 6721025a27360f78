#pragma once
/// The cells of each rank.

#include "grid/Grid.hpp"
#include "parallel/Ranks.hpp"

#include <vector>

namespace Rhegma
{

/// Cells low .. high - 1 of a lattice along each axis; may be empty.
template <int D>
struct CellBox
{
  int low[D], high[D];

  bool holds(const int (&cell)[D]) const
  {
    bool in = true;
    for (int d = 0; d < D; ++d)
      in = in && cell[d] >= low[d] && cell[d] < high[d];
    return in;
  }
};

/// A box of cells for each rank; together they are the cells of the domain. Where cuts fall on the first or
/// last positions, boxes overlap: a cell belongs to the first box that contains it.
template <int D>
struct Division
{
  Grid<D> lattice; ///< of the whole domain
  std::vector<CellBox<D>> boxes;
  int margin = gridMargin; ///< cells around its box that a rank has, too, as far as the lattice reaches

  /// The cell of the domain that is nearest to a position.
  void cellAt(const Vector<D>& x, int (&cell)[D]) const;
  /// The rank that owns a cell of the domain.
  int ownerOf(const int (&cell)[D]) const;
  /// The cells that a rank has: its box and the margin around it, which its particles can reach.
  CellBox<D> windowCells(int rank) const;
  /// The part of the lattice with these cells.
  Grid<D> window(int rank) const;
};

/// Divides a domain so that each rank gets about the same fraction of the cost, by multijagged cuts (M.
/// Deveci, S. Rajamanickam, K. D. Devine, U. V. Catalyurek, IEEE Trans. Parallel Distrib. Syst. 27, 2016) as
/// Zoltan2 makes them. Collective. \param positions of this rank \param costs of these positions; empty: all
/// equal
template <int D>
Division<D> divide(const Ranks& ranks, const Grid<D>& lattice, const std::vector<Vector<D>>& positions,
                   const std::vector<double>& costs = {});

} // namespace Rhegma
