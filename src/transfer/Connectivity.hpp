#pragma once
/// The nodes of a particle, and their fields: the common policy of all transfers.

#include "grid/Grid.hpp"
#include "grid/ShapeFunctions.hpp"
#include "grid/StencilTable.hpp"
#include "transfer/LaneStencils.hpp"

namespace Rhegma
{

/// Slopes of a node's function along axis j for component i of a displacement.
template <int D, ShearStrain H>
struct ComponentSlopes
{
  const double* of;
  double hoop = 0.0; ///< what a radial displacement adds to the hoop strain of axisymmetric scenes [1/m]

  KOKKOS_FORCEINLINE_FUNCTION double operator()(int i, int j) const
  {
    return H == ShearStrain::AtCellCentres ? of[D * j + i] : of[j];
  }
  static constexpr int size = H == ShearStrain::AtCellCentres ? D * D : D; ///< numbers read
};

/// Visits the nodes of a particle. Particles with a row in the table use the stored nodes; all others, and
/// all particles when Stored is false, use the nodes of their cell. H says where the slopes of transfers of
/// strain and internal forces are taken; stored stencils then have them (StencilTable::gradient).
template <int D, ShapeKind S, bool Stored, ShearStrain H = ShearStrain::AtParticles>
struct Connectivity
{
  Grid<D> grid;
  BorrowedView<double* [D]> position;
  BorrowedView<double* [D]> box; ///< half widths [m]; empty for linear functions
  View<int*> row;                ///< row in the table, or -1
  StencilTable<D> table;

  static constexpr ShapeKind shape = S;
  static constexpr ShearStrain shear = H;

  /// Calls visit(p, stencil) for the particles begin .. end - 1; a stencil has the operations of
  /// TensorStencil.
  template <class Visit>
  KOKKOS_INLINE_FUNCTION void forEachParticle(int begin, int end, const Visit& visit) const
  {
    LaneStencils<D, S> stencils;
    for (int first = begin; first < end; first += lanes)
    {
      const int count = end - first < lanes ? end - first : lanes;
      if (!Stored || !allStored(first, count))
        stencils.fill(grid, &position(first, 0), S == ShapeKind::Gimp ? &box(first, 0) : nullptr, count);
      for (int l = 0; l < count; ++l)
      {
        if constexpr (Stored)
        {
          const int r = row(first + l);
          if (r >= 0)
          {
            visit(first + l, TableStencil<D, H>{table, r});
            continue;
          }
        }
        visit(first + l, TensorStencil<D, S, H>{stencils, grid.stride, l, grid.spacing});
      }
    }
  }

  /// Usually the first particle decides.
  KOKKOS_INLINE_FUNCTION bool allStored(int first, int count) const
  {
    for (int p = first; p < first + count; ++p)
      if (row(p) < 0)
        return false;
    return true;
  }

  using Slopes = ComponentSlopes<D, H>;

  /// Calls visit(node, weight, slopes) for each node, slopes(i, j) along axis j for component i in 1/m: what
  /// strains a particle, and what its stress exerts on the node.
  template <class Visit>
  KOKKOS_INLINE_FUNCTION void visitStraining(int p, const Visit& straining) const
  {
    if constexpr (H == ShearStrain::AtParticles && Stored && D == 2)
      if (table.hasHoop())
        return visitWithHoop(p, straining);
    if constexpr (H == ShearStrain::AtParticles)
      visit(p, [&](int node, double weight, const double* slope) { straining(node, weight, Slopes{slope}); });
    else
    {
      if constexpr (Stored)
      {
        const int r = row(p);
        if (r >= 0)
        {
          const int count = table.count(r);
          for (int k = 0; k < count; ++k)
            straining(table.node(r, k), table.weight(r, k), Slopes{&table.gradient(r, k, 0)});
          return;
        }
      }
      visitComponents(p, straining);
    }
  }

  /// Calls visit(node, weight, slope) for each node, slope in 1/m.
  template <class Visit>
  KOKKOS_INLINE_FUNCTION void visit(int p, Visit&& visit) const
  {
    if constexpr (Stored)
    {
      const int r = row(p);
      if (r >= 0)
      {
        const int count = table.count(r);
        for (int k = 0; k < count; ++k)
          visit(table.node(r, k), table.weight(r, k), &table.slope(r, k, 0));
        return;
      }
    }
    constexpr int N = nodesPerAxis<S>;
    AxisStencil<N> axis[D];
    int base = 0;
    for (int d = 0; d < D; ++d)
    {
      double half = 0.0;
      if constexpr (S == ShapeKind::Gimp)
        half = box(p, d) * grid.inverse;
      axis[d] = axisStencil<S>(grid.inCells(position(p, d), d), half);
      for (int k = 0; k < N; ++k)
        axis[d].slope[k] *= grid.inverse;
      base += axis[d].first * grid.stride[d];
    }
    if constexpr (D == 2)
    {
      for (int i = 0; i < N; ++i)
        for (int j = 0; j < N; ++j)
        {
          const double slope[2] = {axis[0].slope[i] * axis[1].weight[j],
                                   axis[0].weight[i] * axis[1].slope[j]};
          visit(base + i * grid.stride[0] + j * grid.stride[1], axis[0].weight[i] * axis[1].weight[j], slope);
        }
    }
    else
    {
      for (int i = 0; i < N; ++i)
        for (int j = 0; j < N; ++j)
        {
          const double across = axis[0].weight[i] * axis[1].weight[j];
          const double slope0 = axis[0].slope[i] * axis[1].weight[j];
          const double slope1 = axis[0].weight[i] * axis[1].slope[j];
          const int line = base + i * grid.stride[0] + j * grid.stride[1];
          for (int k = 0; k < N; ++k)
          {
            const double slope[3] = {slope0 * axis[2].weight[k], slope1 * axis[2].weight[k],
                                     across * axis[2].slope[k]};
            visit(line + k * grid.stride[2], across * axis[2].weight[k], slope);
          }
        }
    }
  }

private:
  /// In axisymmetric scenes all stencils are stored.
  template <class Visit>
  KOKKOS_INLINE_FUNCTION void visitWithHoop(int p, const Visit& straining) const
  {
    const int r = row(p), count = table.count(r);
    for (int k = 0; k < count; ++k)
      straining(table.node(r, k), table.weight(r, k), Slopes{&table.slope(r, k, 0), table.hoop(r, k)});
  }

  template <class Visit>
  KOKKOS_INLINE_FUNCTION void visitComponents(int p, const Visit& straining) const
  {
    constexpr int N = nodesPerAxis<S>;
    AxisStencil<N> axis[D];
    for (int d = 0; d < D; ++d)
    {
      double half = 0.0;
      if constexpr (S == ShapeKind::Gimp)
        half = box(p, d) * grid.inverse;
      axis[d] = axisStencil<S>(grid.inCells(position(p, d), d), half);
    }
    constexpr int all = D == 2 ? N * N : N * N * N;
    for (int e = 0; e < all; ++e)
    {
      int k[D], node = 0;
      double weight = 1.0, gradient[D * D];
      for (int d = D - 1, rest = e; d >= 0; --d, rest /= N)
      {
        k[d] = rest % N;
        node += (axis[d].first + k[d]) * grid.stride[d];
        weight *= axis[d].weight[k[d]];
      }
      componentSlopes<D, N>(axis, k, grid.inverse, gradient);
      straining(node, weight, Slopes{gradient});
    }
  }
};

} // namespace Rhegma
