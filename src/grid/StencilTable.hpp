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

  /// What a radial displacement of each node adds to the hoop strain [1/m]; empty unless the scene is
  /// axisymmetric.
  View<double * [stencilCapacity<D>]> hoop;

  KOKKOS_INLINE_FUNCTION bool hasHoop() const { return D == 2 && hoop.extent(0) > 0; }
  KOKKOS_INLINE_FUNCTION bool hasGradients() const { return gradient.extent(0) > 0; }
  int size() const { return static_cast<int>(count.extent(0)); }

  /// Allocates at least this many rows; values are lost when the table grows. \param gradients whether slopes
  /// differ between components
  /// \param around whether the scene is axisymmetric
  void reserve(int rows, bool gradients = false, bool around = false)
  {
    if (size() >= rows && (hasGradients() || !gradients) && (hasHoop() || !around))
      return;
    const int capacity = rows + rows / 4 + 16;
    count = View<int*>("rhegma::stencilCount", capacity);
    node = View<int * [stencilCapacity<D>]>("rhegma::stencilNode", capacity);
    weight = View<double * [stencilCapacity<D>]>("rhegma::stencilWeight", capacity);
    slope = View<double * [stencilCapacity<D>][D]>("rhegma::stencilSlope", capacity);
    if (gradients)
      gradient = View<double * [stencilCapacity<D>][D * D]>("rhegma::stencilGradient", capacity);
    if (around)
      hoop = View<double * [stencilCapacity<D>]>("rhegma::stencilHoop", capacity);
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

/// Weights and slopes along the radius as averages in which each part of the box counts with its radius, so
/// that nodal forces of a uniform stress are those of the exact integrals over the rings. The average over
/// the overlap with a cell is known exactly, for functions are linear there. Source: Nairn and Guilkey, Int.
/// J. Numer. Meth. Engng. 101 (2015) 127. \param axis plain averages \param at, half coordinate and half
/// width in cells, from the node before the axis stencil's numbers \param radius of the box's centre in cells
KOKKOS_INLINE_FUNCTION AxisStencil<3> weightedByRadius(const AxisStencil<3>& axis, double at, double half,
                                                       double radius)
{
  const double begin = at - half - axis.first, whole = begin + 2.0 * half;
  const double end = whole > 1.0 ? 1.0 : whole; // of the overlap with the first cell
  const double length[2] = {end - begin, whole - end};
  AxisStencil<3> result{axis.first, {}, {}};
  for (int k = 0; k < 2; ++k)
  {
    const double middle = k == 0 ? 0.5 * (begin + end) : 0.5 * length[1]; // from the cell's first node
    const double there = radius + (k == 0 ? middle : 1.0 + middle) - (begin + half);
    const double part = length[k] / (2.0 * half * radius); // times a radius: the fraction of the ring
    const double upper = part * (middle * there + length[k] * length[k] / 12.0);
    result.weight[k] += part * there - upper;
    result.weight[k + 1] += upper;
    result.slope[k] -= part * there;
    result.slope[k + 1] += part * there;
  }
  return result;
}

/// The plain averages of linear functions at a point.
KOKKOS_INLINE_FUNCTION AxisStencil<2> weightedByRadius(const AxisStencil<2>& axis, double, double, double)
{
  return axis;
}

/// Writes the unbroken stencil of a point or of a box into a row, with hoop strains if the table has them.
/// \param half half widths of the box [m]
template <int D, ShapeKind S>
KOKKOS_INLINE_FUNCTION void writeStencil(const Grid<D>& grid, const StencilTable<D>& table, int row,
                                         const Vector<D>& x, const Vector<D>& half)
{
  constexpr int N = nodesPerAxis<S>;
  AxisStencil<N> axis[D];
  for (int d = 0; d < D; ++d)
    axis[d] = axisStencil<S>(grid.inCells(x[d], d), half[d] * grid.inverse);
  const AxisStencil<N> plain = axis[0];
  if (table.hasHoop())
    axis[0] = weightedByRadius(plain, grid.inCells(x[0], 0), half[0] * grid.inverse, x[0] * grid.inverse);
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
    if (table.hasHoop())
      table.hoop(row, entries) = plain.weight[k[0]] * axis[D - 1].weight[k[D - 1]] / x[0];
    ++entries;
  }
  table.count(row) = entries;
}

} // namespace Rhegma
