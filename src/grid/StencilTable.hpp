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
  /// Slope along axis j for component i of a displacement at D j + i [1/m]; empty unless they differ between
  /// components (ShearStrain).
  View<double * [stencilCapacity<D>][D * D]> gradient;

  KOKKOS_INLINE_FUNCTION bool hasGradients() const { return gradient.extent(0) > 0; }
  int size() const { return static_cast<int>(count.extent(0)); }

  /// Allocates at least this many rows; values are lost when the table grows. \param gradients whether slopes
  /// differ between components
  void reserve(int rows, bool gradients = false)
  {
    if (size() >= rows && (hasGradients() || !gradients))
      return;
    const int capacity = rows + rows / 4 + 16;
    count = View<int*>("rhegma::stencilCount", capacity);
    node = View<int * [stencilCapacity<D>]>("rhegma::stencilNode", capacity);
    weight = View<double * [stencilCapacity<D>]>("rhegma::stencilWeight", capacity);
    slope = View<double * [stencilCapacity<D>][D]>("rhegma::stencilSlope", capacity);
    if (gradients)
      gradient = View<double * [stencilCapacity<D>][D * D]>("rhegma::stencilGradient", capacity);
  }
};

/// Slopes of one node along axis j for component i of a displacement: a product over the axes, of the slope
/// along j, the value at the centre of the cell along i, if i is another axis, and the values where the
/// point is along the rest. So the shear strain of a cell is constant in its plane: a cell that bends, whose
/// shear strain at its centre is zero, has none. Source: Doherty, Wilson and Taylor, Stress analysis of
/// axisymmetric solids utilizing higher-order quadrilateral finite elements, report 69-3, University of
/// California, Berkeley (1969). \param k number of the node along each axis \param inverse of the cell [1/m]
/// \param gradient out: D j + i [1/m]
template <int D, int N>
KOKKOS_INLINE_FUNCTION void componentSlopes(const AxisStencil<N> (&axis)[D], const int (&k)[D],
                                            double inverse, double* gradient)
{
  for (int j = 0; j < D; ++j)
    for (int i = 0; i < D; ++i)
    {
      double g = inverse;
      for (int d = 0; d < D; ++d)
        g *= d == j   ? axis[d].slope[k[d]]
             : d == i ? centreWeight<N>(axis[d].slope[0], axis[d].slope[N - 1], k[d])
                      : axis[d].weight[k[d]];
      gradient[D * j + i] = g;
    }
}

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
    int k[D];
    for (int d = 0, rest = e; d < D; ++d, rest /= N)
      k[d] = rest % N;
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
    if (table.hasGradients())
      componentSlopes<D, N>(axis, k, grid.inverse, &table.gradient(row, entries, 0));
    ++entries;
  }
  table.count(row) = entries;
}

} // namespace Rhegma
