#pragma once
/// Stencils of a few particles at once, and what transfers do with one of them.

#include "base/Pack.hpp"
#include "grid/Blocks.hpp"
#include "grid/Grid.hpp"
#include "grid/ShapeFunctions.hpp"
#include "grid/StencilTable.hpp"

namespace Rhegma
{

/// Weights and slopes along each axis of the particles in the lanes.
template <int D, ShapeKind S>
struct LaneStencils
{
  static constexpr int N = nodesPerAxis<S>;
  double weight[D][N][lanes];
  double slope[D][N][lanes]; ///< [1/m]
  int base[lanes];           ///< node with the smallest coordinates

  /// Fills lanes 0 .. count - 1 from positions [m] and half widths of the boxes [m] (rows of D numbers; the
  /// latter not read by linear functions).
  KOKKOS_INLINE_FUNCTION void fill(const Grid<D>& grid, const double* position, const double* box, int count)
  {
    for (int l = 0; l < count; ++l)
      base[l] = 0;
    for (int d = 0; d < D; ++d)
    {
      const double origin = grid.origin[d], inverse = grid.inverse;
      const int stride = grid.stride[d];
      for (int l = 0; l < count; ++l)
      {
        double half = 0.0;
        if constexpr (S == ShapeKind::Gimp)
          half = box[l * D + d] * inverse;
        const AxisStencil<N> axis = axisStencil<S>((position[l * D + d] - origin) * inverse, half);
        base[l] += axis.first * stride;
        for (int k = 0; k < N; ++k)
        {
          weight[d][k][l] = axis.weight[k];
          slope[d][k][l] = axis.slope[k] * inverse;
        }
      }
    }
  }
};

/// The stencil in one lane: a tensor product, of which sums over the inner axes are formed once. With H
/// AtCellCentres, slopes differ between the components of a row (componentSlopes): so do the weights of
/// their products, of which there is one register a node of an axis.
template <int D, ShapeKind S, ShearStrain H = ShearStrain::AtParticles>
struct TensorStencil
{
  static constexpr int N = nodesPerAxis<S>;
  static constexpr int components = D == 2 ? 2 : 4; ///< width of a register of components
  static constexpr bool mayHaveHoop = false;        ///< stencils of axisymmetric scenes are stored
  const LaneStencils<D, S>& all;
  const int (&stride)[D];
  int lane;
  double spacing; ///< [m]; not read with H AtParticles

  KOKKOS_FORCEINLINE_FUNCTION double weight(int d, int k) const { return all.weight[d][k][lane]; }
  KOKKOS_FORCEINLINE_FUNCTION double slope(int d, int k) const { return all.slope[d][k][lane]; }

  /// The first node of line i (2D) or of line i, j (3D).
  KOKKOS_FORCEINLINE_FUNCTION int line(int i, int j = 0) const
  {
    return all.base[lane] + i * stride[0] + (D == 2 ? 0 : j * stride[1]);
  }

  /// sum N row, of W columns; rows are Width long and start at the first of these columns.
  template <int Width, int W>
  KOKKOS_FORCEINLINE_FUNCTION Pack<W> value(const double* rows) const
  {
    Pack<W> sum = Pack<W>::zero();
    for (int i = 0; i < N; ++i)
    {
      Pack<W> plane = Pack<W>::zero();
      if constexpr (D == 2)
        for (int j = 0; j < N; ++j)
          plane.add(weight(1, j), Pack<W>::load(rows + Width * (line(i) + j * stride[1])));
      else
        for (int j = 0; j < N; ++j)
        {
          Pack<W> along = Pack<W>::zero();
          for (int k = 0; k < N; ++k)
            along.add(weight(2, k), Pack<W>::load(rows + Width * (line(i, j) + k * stride[2])));
          plane.add(weight(1, j), along);
        }
      sum.add(weight(0, i), plane);
    }
    return sum;
  }

  /// sum N row, and result[d] = sum dN/dx_d row.
  template <int Width, int W>
  KOKKOS_FORCEINLINE_FUNCTION Pack<W> valueAndGradient(const double* rows, Pack<W> (&result)[D]) const
  {
    Pack<W> sum = Pack<W>::zero();
    for (int d = 0; d < D; ++d)
      result[d] = Pack<W>::zero();
    if constexpr (H == ShearStrain::AtCellCentres)
    {
      addComponentGradients<Width>(rows, sum, result);
      return sum;
    }
    for (int i = 0; i < N; ++i)
    {
      // Sums over the inner axes: weights only, slopes along axis 1, slopes along axis 2.
      Pack<W> flat = Pack<W>::zero(), slope1 = Pack<W>::zero();
      if constexpr (D == 2)
        for (int j = 0; j < N; ++j)
        {
          const Pack<W> row = Pack<W>::load(rows + Width * (line(i) + j * stride[1]));
          flat.add(weight(1, j), row);
          slope1.add(slope(1, j), row);
        }
      else
      {
        Pack<W> slope2 = Pack<W>::zero();
        for (int j = 0; j < N; ++j)
        {
          Pack<W> along = Pack<W>::zero(), steep = Pack<W>::zero();
          for (int k = 0; k < N; ++k)
          {
            const Pack<W> row = Pack<W>::load(rows + Width * (line(i, j) + k * stride[2]));
            along.add(weight(2, k), row);
            steep.add(slope(2, k), row);
          }
          flat.add(weight(1, j), along);
          slope1.add(slope(1, j), along);
          slope2.add(weight(1, j), steep);
        }
        result[2].add(weight(0, i), slope2);
      }
      sum.add(weight(0, i), flat);
      result[0].add(slope(0, i), flat);
      result[1].add(weight(0, i), slope1);
    }
    return sum;
  }

  /// row += N a.
  template <int Width, int W>
  KOKKOS_FORCEINLINE_FUNCTION void addValue(double* rows, const Pack<W>& a) const
  {
    for (int i = 0; i < N; ++i)
    {
      const Pack<W> plane = weight(0, i) * a;
      if constexpr (D == 2)
        for (int j = 0; j < N; ++j)
          addTo(rows + Width * (line(i) + j * stride[1]), weight(1, j), plane);
      else
        for (int j = 0; j < N; ++j)
        {
          const Pack<W> along = weight(1, j) * plane;
          for (int k = 0; k < N; ++k)
            addTo(rows + Width * (line(i, j) + k * stride[2]), weight(2, k), along);
        }
    }
  }

  /// row += sum_d dN/dx_d b[d].
  template <int Width, int W>
  KOKKOS_FORCEINLINE_FUNCTION void addFlux(double* rows, const Pack<W> (&b)[D]) const
  {
    if constexpr (H == ShearStrain::AtCellCentres)
    {
      addComponentFlux<Width>(rows, b);
      return;
    }
    for (int i = 0; i < N; ++i)
    {
      const Pack<W> b0 = slope(0, i) * b[0], b1 = weight(0, i) * b[1];
      if constexpr (D == 2)
        for (int j = 0; j < N; ++j)
          addTo(rows + Width * (line(i) + j * stride[1]), weight(1, j), b0, slope(1, j), b1);
      else
      {
        const Pack<W> b2 = weight(0, i) * b[2];
        for (int j = 0; j < N; ++j)
        {
          Pack<W> flat = weight(1, j) * b0;
          flat.add(slope(1, j), b1);
          const Pack<W> steep = weight(1, j) * b2;
          for (int k = 0; k < N; ++k)
            addTo(rows + Width * (line(i, j) + k * stride[2]), weight(2, k), flat, slope(2, k), steep);
        }
      }
    }
  }

private:
  /// Weight of node k of axis d in slopes along other axes, of each component: at the centre of the cell for
  /// component d.
  KOKKOS_FORCEINLINE_FUNCTION Pack<components> spread(int d, int k) const
  {
    const double w = weight(d, k);
    const double c = centreWeight<N>(spacing * slope(d, 0), spacing * slope(d, N - 1), k);
    if constexpr (D == 2)
      return pack(d == 0 ? c : w, d == 1 ? c : w);
    else
      return pack(d == 0 ? c : w, d == 1 ? c : w, d == 2 ? c : w, w);
  }

  template <int Width>
  KOKKOS_FORCEINLINE_FUNCTION void addComponentGradients(const double* rows, Pack<components>& sum,
                                                         Pack<components> (&result)[D]) const
  {
    using Row = Pack<components>;
    Row spread1[N], spread2[N];
    for (int k = 0; k < N; ++k)
    {
      spread1[k] = spread(1, k);
      spread2[k] = spread(D - 1, k);
    }
    for (int i = 0; i < N; ++i)
    {
      // Sums over the inner axes: of values, of weights that spread slopes, of slopes along axes 1 and 2.
      Row value = Row::zero(), flat = Row::zero(), slope1 = Row::zero(), slope2 = Row::zero();
      if constexpr (D == 2)
        for (int j = 0; j < N; ++j)
        {
          const Row row = Row::load(rows + Width * (line(i) + j * stride[1]));
          value.add(weight(1, j), row);
          flat.add(spread1[j], row);
          slope1.add(slope(1, j), row);
        }
      else
        for (int j = 0; j < N; ++j)
        {
          Row along = Row::zero(), spreadAlong = Row::zero(), steep = Row::zero();
          for (int k = 0; k < N; ++k)
          {
            const Row row = Row::load(rows + Width * (line(i, j) + k * stride[2]));
            along.add(weight(2, k), row);
            spreadAlong.add(spread2[k], row);
            steep.add(slope(2, k), row);
          }
          value.add(weight(1, j), along);
          flat.add(spread1[j], spreadAlong);
          slope1.add(slope(1, j), spreadAlong);
          slope2.add(spread1[j], steep);
        }
      const Row spread0 = spread(0, i);
      sum.add(weight(0, i), value);
      result[0].add(slope(0, i), flat);
      result[1].add(spread0, slope1);
      if constexpr (D == 3)
        result[2].add(spread0, slope2);
    }
  }

  template <int Width>
  KOKKOS_FORCEINLINE_FUNCTION void addComponentFlux(double* rows, const Pack<components> (&b)[D]) const
  {
    using Row = Pack<components>;
    Row spread1[N], spread2[N];
    for (int k = 0; k < N; ++k)
    {
      spread1[k] = spread(1, k);
      spread2[k] = spread(D - 1, k);
    }
    for (int i = 0; i < N; ++i)
    {
      const Row b0 = slope(0, i) * b[0], b1 = spread(0, i) * b[1];
      for (int j = 0; j < N; ++j)
      {
        Row flat = spread1[j] * b0;
        flat.add(slope(1, j), b1);
        if constexpr (D == 2)
          addTo(rows + Width * (line(i) + j * stride[1]), 1.0, flat);
        else
        {
          const Row steep = spread1[j] * (spread(0, i) * b[2]);
          for (int k = 0; k < N; ++k)
            addTo(rows + Width * (line(i, j) + k * stride[2]), slope(2, k), steep, 1.0, spread2[k] * flat);
        }
      }
    }
  }

  template <int W>
  KOKKOS_FORCEINLINE_FUNCTION static void addTo(double* row, double s, const Pack<W>& a)
  {
    Pack<W> sum = Pack<W>::load(row);
    sum.add(s, a);
    sum.store(row);
  }
  template <int W>
  KOKKOS_FORCEINLINE_FUNCTION static void addTo(double* row, double s, const Pack<W>& a, double t,
                                                const Pack<W>& b)
  {
    Pack<W> sum = Pack<W>::load(row);
    sum.add(s, a);
    sum.add(t, b);
    sum.store(row);
  }
};

/// A stencil of the table, with the same operations.
template <int D, ShearStrain H = ShearStrain::AtParticles>
struct TableStencil
{
  static constexpr int components = D == 2 ? 2 : 4;
  static constexpr bool mayHaveHoop = D == 2;
  const StencilTable<D>& table;
  int row;

  KOKKOS_FORCEINLINE_FUNCTION bool hasHoop() const { return table.hasHoop(); }

  /// Sum of the rows with their hoop strains: of velocities, the first number is the rate of the hoop strain,
  /// and all times the particle's radius are the velocity of its centre.
  template <int Width, int W>
  KOKKOS_INLINE_FUNCTION Pack<W> hoopValue(const double* rows) const
  {
    Pack<W> sum = Pack<W>::zero();
    const int count = table.count(row);
    for (int k = 0; k < count; ++k)
      sum.add(table.hoop(row, k), Pack<W>::load(rows + Width * table.node(row, k)));
    return sum;
  }

  /// Adds a hoop stress times volume to the radial number of the rows.
  template <int Width>
  KOKKOS_INLINE_FUNCTION void addHoop(double* rows, double value) const
  {
    const int count = table.count(row);
    for (int k = 0; k < count; ++k)
      rows[Width * table.node(row, k)] += table.hoop(row, k) * value;
  }

  template <int Width, int W>
  KOKKOS_FORCEINLINE_FUNCTION Pack<W> value(const double* rows) const
  {
    Pack<W> sum = Pack<W>::zero();
    const int count = table.count(row);
    for (int k = 0; k < count; ++k)
      sum.add(table.weight(row, k), Pack<W>::load(rows + Width * table.node(row, k)));
    return sum;
  }

  template <int Width, int W>
  KOKKOS_FORCEINLINE_FUNCTION Pack<W> valueAndGradient(const double* rows, Pack<W> (&result)[D]) const
  {
    Pack<W> sum = Pack<W>::zero();
    for (int d = 0; d < D; ++d)
      result[d] = Pack<W>::zero();
    const int count = table.count(row);
    for (int k = 0; k < count; ++k)
    {
      const Pack<W> at = Pack<W>::load(rows + Width * table.node(row, k));
      sum.add(table.weight(row, k), at);
      for (int d = 0; d < D; ++d)
        if constexpr (H == ShearStrain::AtCellCentres)
          result[d].add(gradient(k, d), at);
        else
          result[d].add(table.slope(row, k, d), at);
    }
    return sum;
  }

  template <int Width, int W>
  KOKKOS_INLINE_FUNCTION void addValue(double* rows, const Pack<W>& a) const
  {
    const int count = table.count(row);
    for (int k = 0; k < count; ++k)
    {
      double* const to = rows + Width * table.node(row, k);
      Pack<W> sum = Pack<W>::load(to);
      sum.add(table.weight(row, k), a);
      sum.store(to);
    }
  }

  template <int Width, int W>
  KOKKOS_INLINE_FUNCTION void addFlux(double* rows, const Pack<W> (&b)[D]) const
  {
    const int count = table.count(row);
    for (int k = 0; k < count; ++k)
    {
      double* const to = rows + Width * table.node(row, k);
      Pack<W> sum = Pack<W>::load(to);
      for (int d = 0; d < D; ++d)
        if constexpr (H == ShearStrain::AtCellCentres)
          sum.add(gradient(k, d), b[d]);
        else
          sum.add(table.slope(row, k, d), b[d]);
      sum.store(to);
    }
  }

private:
  /// Slopes along axis d of each component.
  KOKKOS_FORCEINLINE_FUNCTION Pack<components> gradient(int k, int d) const
  {
    const double* const of = &table.gradient(row, k, D * d);
    if constexpr (D == 2)
      return pack(of[0], of[1]);
    else
      return pack(of[0], of[1], of[2], 0.0);
  }
};

} // namespace Rhegma
