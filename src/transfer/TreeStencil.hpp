#pragma once
/// Stored stencils of points and boxes in refined cells.

#include "grid/Tree.hpp"
#include "transfer/StencilTable.hpp"

namespace Rhegma
{

/// Writes the unbroken stencil of a box of half widths `half` [m] around x, of a point where they are zero,
/// into a row; each node comes once. \return false where the box touches more nodes than a row holds: then
/// the row is empty
template <int D>
KOKKOS_INLINE_FUNCTION bool writeTreeStencil(const TreeSight<D>& sight, const StencilTable<D>& table, int row,
                                             const Vector<D>& x, const Vector<D>& half)
{
  int entries = 0;
  bool fits = true;
  sight.forEachNode(x, half,
                    [&](int node, double weight, const double(&slope)[D])
                    {
                      int k = 0;
                      while (k < entries && table.node(row, k) != node)
                        ++k;
                      if (k == entries)
                      {
                        if (entries == stencilCapacity<D>)
                        {
                          fits = false;
                          return;
                        }
                        table.node(row, k) = node;
                        table.weight(row, k) = 0.0;
                        for (int d = 0; d < D; ++d)
                          table.slope(row, k, d) = 0.0;
                        ++entries;
                      }
                      table.weight(row, k) += weight;
                      for (int d = 0; d < D; ++d)
                        table.slope(row, k, d) += slope[d];
                    });
  table.count(row) = fits ? entries : 0;
  return fits;
}

} // namespace Rhegma
