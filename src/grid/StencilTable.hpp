#pragma once
/// Stored stencils for the few particles and points whose nodes differ from those of their cell.

#include "base/Types.hpp"
#include "grid/Grid.hpp"
#include "grid/ShapeFunctions.hpp"

namespace Rhegma
{

/// Largest number of nodes of a stored stencil.
template <int D>
constexpr int stencilCapacity = D == 2 ? 16 : 64;

/// One row a point: node, weight and slope [1/m] of each entry.
template <int D>
struct StencilTable
{
  View<int*> count;
  View<int * [stencilCapacity<D>]> node;
  View<double * [stencilCapacity<D>]> weight;
  View<double * [stencilCapacity<D>][D]> slope;

  int size() const { return static_cast<int>(count.extent(0)); }

  /// Allocates at least this many rows; values are lost when the table grows.
  void reserve(int rows)
  {
    if (size() >= rows)
      return;
    const int capacity = rows + rows / 4 + 16;
    count = View<int*>("rhegma::stencilCount", capacity);
    node = View<int * [stencilCapacity<D>]>("rhegma::stencilNode", capacity);
    weight = View<double * [stencilCapacity<D>]>("rhegma::stencilWeight", capacity);
    slope = View<double * [stencilCapacity<D>][D]>("rhegma::stencilSlope", capacity);
  }
};

/// Writes the unbroken stencil of a point or of a box into a row. \param half half widths of the box [m]
template <int D, ShapeKind S>
KOKKOS_INLINE_FUNCTION void writeStencil(const Grid<D>& grid, const StencilTable<D>& table, int row,
                                         const Vector<D>& x, const Vector<D>& half)
{
  constexpr int N = nodesPerAxis<S>;
  AxisStencil<N> axis[D];
  for (int d = 0; d < D; ++d)
    axis[d] = axisStencil<S>(grid.inCells(x[d], d), half[d] * grid.inverse);
  int entries = 0;
  const int all = D == 2 ? N * N : N * N * N;
  for (int e = 0; e < all; ++e)
  {
    int k[3] = {e % N, (e / N) % N, e / (N * N)};
    double w = 1.0;
    int n = 0;
    for (int d = 0; d < D; ++d)
    {
      w *= axis[d].weight[k[d]];
      n += (axis[d].first + k[d]) * grid.stride[d];
    }
    table.node(row, entries) = n;
    table.weight(row, entries) = w;
    for (int d = 0; d < D; ++d)
    {
      double g = axis[d].slope[k[d]] * grid.inverse;
      for (int o = 0; o < D; ++o)
        g *= o == d ? 1.0 : axis[o].weight[k[o]];
      table.slope(row, entries, d) = g;
    }
    ++entries;
  }
  table.count(row) = entries;
}

} // namespace Rhegma
