#pragma once
/// Stored stencils of points and boxes in refined cells.

#include "grid/ShapeFunctions.hpp"
#include "grid/StencilTable.hpp"
#include "grid/Tree.hpp"

namespace Rhegma
{

/// Adds to the entry of a node in a row, a new one where it has none. \return false where the row is full
template <int D>
KOKKOS_INLINE_FUNCTION bool addEntry(const StencilTable<D>& table, int row, int& entries, int node,
                                     double weight, const double (&slope)[D])
{
  int k = 0;
  while (k < entries && table.node(row, k) != node)
    ++k;
  if (k == entries)
  {
    if (entries == stencilCapacity<D>)
      return false;
    table.node(row, k) = node;
    table.weight(row, k) = 0.0;
    for (int d = 0; d < D; ++d)
      table.slope(row, k, d) = 0.0;
    ++entries;
  }
  table.weight(row, k) += weight;
  for (int d = 0; d < D; ++d)
    table.slope(row, k, d) += slope[d];
  return true;
}

/// Writes the slopes that differ between components of a row whose nodes are written. \return false where the
/// row is full
template <int D>
KOKKOS_INLINE_FUNCTION bool writeGradients(const TreeSight<D>& sight, const StencilTable<D>& table, int row,
                                           const Vector<D>& x, const Vector<D>& half)
{
  constexpr double none[D] = {};
  bool fits = true;
  int entries = table.count(row);
  for (int k = 0; k < stencilCapacity<D>; ++k)
    for (int c = 0; c < D * D; ++c)
      table.gradient(row, k, c) = 0.0;
  sight.forEachGradient(x, half,
                        [&](int node, const double(&gradient)[D * D])
                        {
                          if (!addEntry(table, row, entries, node, 0.0, none))
                          {
                            fits = false;
                            return;
                          }
                          int k = 0;
                          while (table.node(row, k) != node)
                            ++k;
                          for (int c = 0; c < D * D; ++c)
                            table.gradient(row, k, c) += gradient[c];
                        });
  table.count(row) = entries;
  return fits;
}

/// Writes the unbroken stencil of a box of half widths `half` [m] around x, of a point where they are zero,
/// into a row, leaf by leaf; each node comes once. \return false where the box touches more nodes than a row
/// holds: then the row is empty
template <int D>
KOKKOS_INLINE_FUNCTION bool writeTreeStencil(const TreeSight<D>& sight, const StencilTable<D>& table, int row,
                                             const Vector<D>& x, const Vector<D>& half)
{
  int entries = 0;
  bool fits = true;
  sight.forEachNode(x, half,
                    [&](int node, double weight, const double(&slope)[D])
                    { fits = addEntry(table, row, entries, node, weight, slope) && fits; });
  table.count(row) = fits ? entries : 0;
  return fits;
}

/// Writes stencils of boxes and points in refined cells. Most boxes touch cells of one size only: their
/// stencils are tensor products, as on a lattice.
template <int D, ShapeKind S>
struct TreeStencils
{
  static constexpr int N = nodesPerAxis<S>;

  TreeSight<D> sight;
  View<int*> alike;
  View<int * [Tree<D>::nodesAround]> around;
  StencilTable<D> table;

  TreeStencils(const Grid<D>& grid, const Tree<D>& tree, const StencilTable<D>& to)
      : sight(grid, tree), alike(tree.alike), around(tree.around), table(to)
  {
  }

  /// Writes the unbroken stencil of a box of half widths `half` [m] around x, of a point for linear
  /// functions, into a row; each node comes once. \return false where the box touches more nodes than a row
  /// holds: then the row is empty
  KOKKOS_INLINE_FUNCTION bool write(int row, const Vector<D>& x, const Vector<D>& half) const
  {
    bool fits = writeSlopes(row, x, half);
    if (fits && table.hasGradients())
      fits = writeGradients(sight, table, row, x, half);
    if (!fits)
      table.count(row) = 0;
    return fits;
  }

private:
  KOKKOS_INLINE_FUNCTION bool writeSlopes(int row, const Vector<D>& x, const Vector<D>& half) const
  {
    const typename TreeSight<D>::Leaf leaf = sight.leafAt(x);
    const double perCell = static_cast<double>(1 << leaf.level); // leaves in a cell of the lattice
    const double inverse = sight.grid.inverse * perCell;
    Axes axes;
    bool narrow = true;   // at most half a cell in each direction
    unsigned touched = 1; // cells, as bits of Tree::alike
    for (int d = 0, cells = 1; d < D; ++d, cells *= 3)
    {
      const double wide = half[d] * inverse;
      AxisStencil<N>& axis = axes.of[d];
      axis = axisStencil<S>((sight.grid.inCells(x[d], d) - leaf.corner[d]) * perCell + 1.0, wide);
      const bool two = N == 3 && axis.weight[N - 1] > 0.0;
      axes.count[d] = two ? 3 : 2;
      narrow = narrow && wide <= 0.5 + 1e-12 && axis.first + axes.count[d] <= 4;
      touched = (touched | (two ? touched << cells : 0U)) << (cells * axis.first);
      for (int k = 0; k < N; ++k)
        axis.slope[k] *= inverse;
    }
    if (!narrow || !areAlike(leaf, axes, touched))
      return writeTreeStencil(sight, table, row, x, half);
    if (leaf.level == 0)
      return writeProduct(row, axes, sight.grid.stride, -1 - leaf.number, nullptr);
    int stride[D], own = 0;
    for (int d = 0; d < D; ++d)
      own += stride[d] = 1 << (2 * d);
    return writeProduct(row, axes, stride, own, &around(leaf.number, 0));
  }

  /// Stencils of the axes from the lowest of the cells around, slopes in 1/m, and how many of their nodes the
  /// box touches.
  struct Axes
  {
    AxisStencil<N> of[D];
    int count[D];
  };

  /// Whether all cells that a box touches are of the size of the leaf in which its middle lies.
  KOKKOS_INLINE_FUNCTION bool areAlike(const typename TreeSight<D>::Leaf& leaf, const Axes& axes,
                                       unsigned touched) const
  {
    if (leaf.level > 0)
      return (touched & ~static_cast<unsigned>(alike(leaf.number))) == 0;
    const int lowest = -1 - leaf.number;
    if (!sight.refined || sight.nearRefined(lowest) == 0)
      return true;
    bool all = true;
    for (int k = 0; k < Tree<D>::corners; ++k)
    {
      int bit = 0, cell = lowest;
      for (int d = D - 1; d >= 0; --d)
      {
        const int at = axes.of[d].first + ((k >> d) & 1);
        bit = 3 * bit + at;
        cell += (at - 1) * sight.grid.stride[d];
      }
      all = all && (((touched >> bit) & 1U) == 0 || sight.root(cell) < 0);
    }
    return all;
  }

  /// Writes the product of the axes. \param own number of the lowest corner of the leaf in the middle
  /// \param list nodes by that number; null where it is the node itself
  KOKKOS_FORCEINLINE_FUNCTION bool writeProduct(int row, const Axes& axes, const int (&stride)[D], int own,
                                                const int* list) const
  {
    int entries = 0, number = own;
    for (int d = 0; d < D; ++d)
      number += (axes.of[d].first - 1) * stride[d];
    int* const node = &table.node(row, 0);
    double* const weight = &table.weight(row, 0);
    double* const slope = &table.slope(row, 0, 0);
    int hanging = 0;
    for (int i = 0; i < axes.count[0]; ++i)
      for (int j = 0; j < axes.count[1]; ++j)
      {
        const double w = axes.of[0].weight[i] * axes.of[1].weight[j];
        const double s0 = axes.of[0].slope[i] * axes.of[1].weight[j];
        const double s1 = axes.of[0].weight[i] * axes.of[1].slope[j];
        const int line = number + i * stride[0] + j * stride[1];
        if constexpr (D == 2)
        {
          node[entries] = list == nullptr ? line : list[line];
          hanging |= node[entries];
          weight[entries] = w;
          slope[2 * entries] = s0;
          slope[2 * entries + 1] = s1;
          ++entries;
        }
        else
          for (int k = 0; k < axes.count[2]; ++k)
          {
            const double w2 = axes.of[2].weight[k];
            node[entries] = list == nullptr ? line + k * stride[2] : list[line + k * stride[2]];
            hanging |= node[entries];
            weight[entries] = w * w2;
            slope[3 * entries] = s0 * w2;
            slope[3 * entries + 1] = s1 * w2;
            slope[3 * entries + 2] = w * axes.of[2].slope[k];
            ++entries;
          }
      }
    table.count(row) = entries;
    return hanging >= 0 || replaceHanging(row, entries);
  }

  /// Gives the fractions of hanging nodes to their masters.
  KOKKOS_INLINE_FUNCTION bool replaceHanging(int row, int entries) const
  {
    int kept = 0, number = 0;
    int hanging[raw];
    double weight[raw], slope[raw][D];
    for (int e = 0; e < entries; ++e)
    {
      const int node = table.node(row, e);
      if (node >= 0)
      {
        table.node(row, kept) = node;
        table.weight(row, kept) = table.weight(row, e);
        for (int d = 0; d < D; ++d)
          table.slope(row, kept, d) = table.slope(row, e, d);
        ++kept;
        continue;
      }
      hanging[number] = -2 - node;
      weight[number] = table.weight(row, e);
      for (int d = 0; d < D; ++d)
        slope[number][d] = table.slope(row, e, d);
      ++number;
    }
    bool fits = true;
    for (int h = 0; h < number; ++h)
    {
      const int leaf = hanging[h] / Tree<D>::corners, corner = hanging[h] % Tree<D>::corners;
      const int masters = sight.masterCount(leaf, corner);
      const double each = 1.0 / masters;
      weight[h] *= each;
      for (int d = 0; d < D; ++d)
        slope[h][d] *= each;
      for (int m = 0; m < masters; ++m)
        fits = addEntry(table, row, kept, sight.master(leaf, corner, m), weight[h], slope[h]) && fits;
    }
    table.count(row) = fits ? kept : 0;
    return fits;
  }

  static constexpr int raw = D == 2 ? N * N : N * N * N; ///< most nodes before hanging ones are replaced
};

} // namespace Rhegma
