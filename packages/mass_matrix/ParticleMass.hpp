#pragma once
/// Contributions of particles to the mass matrix.

#include "mass_matrix/Fronts.hpp"
#include "mass_matrix/HashedLists.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma::mass_matrix
{

/// Weight up to which a box does not count as touching a light node: otherwise round-off would couple boxes
/// that end on nodes in one step and lump them in the next, which excites a vibration. A box that ends in a
/// free face's node reaches a thousandth of a cell beyond at this weight.
constexpr double barelyTouched = 1e-6;

/// Adds the contributions of the particles of blocks.
template <int D, ShapeKind S, bool Stored>
struct AssembleBlock
{
  static constexpr int N = nodesPerAxis<S>;
  static constexpr int reach = N - 1, span = 2 * reach + 1;
  static constexpr int numLines = D == 2 ? N : N * N; ///< of a particle's stencil
  static constexpr int packed = N == 2 ? 2 : 4;

  Connectivity<D, S, Stored> connect;
  MassSystem<D> system;
  View<int*> parent;
  View<int*> first;
  View<int * [Blocks<D>::axes]> corner;
  BorrowedView<double*> mass, volume;
  ConsistentFraction<D> fractionAt;
  View<double*>
      nodeFraction; ///< part of the cells that is a node's, in cells of the lattice; empty: each has one
  int numLattice;
  double smallest;           ///< lightest node that may be coupled, over the density [m^D times thickness]
  double consistentFraction; ///< 1 - eps

  KOKKOS_INLINE_FUNCTION void operator()(const int block) const
  {
    const Grid<D>& grid = connect.grid;
    if (!fractionAt.reaches(grid, &corner(block, 0)))
      return;
    LaneStencils<D, S> stencils;
    const int end = first(block + 1);
    for (int begin = first(block); begin < end; begin += lanes)
    {
      const int count = end - begin < lanes ? end - begin : lanes;
      double theta[lanes];
      bool any = false;
      for (int l = 0; l < count; ++l)
      {
        theta[l] = fractionAt(&connect.position(begin + l, 0));
        any = any || theta[l] > 0.0;
      }
      if (!any)
        continue;
      stencils.fill(grid, &connect.position(begin, 0),
                    S == ShapeKind::Gimp ? &connect.box(begin, 0) : nullptr, count);
      for (int l = 0; l < count; ++l)
      {
        const int p = begin + l;
        if (theta[l] == 0.0)
          continue;
        const double m = consistentFraction * theta[l] * mass(p), lightest = smallest * mass(p) / volume(p);
        if constexpr (Stored)
        {
          const int r = connect.row(p);
          if (r >= 0)
          {
            system.hashed ? addToHashedLists(r, m, lightest) : addToLists(r, m, lightest);
            continue;
          }
        }
        addToBands(stencils, l, m, lightest);
      }
    }
  }

  /// The band of a line that is `from` of the particle's stencil, for the line `to` of it.
  KOKKOS_FORCEINLINE_FUNCTION static constexpr int lineOf(int from, int to)
  {
    return D == 2 ? to - from + reach : (to / N - from / N + reach) * span + to % N - from % N + reach;
  }

  KOKKOS_FORCEINLINE_FUNCTION void addToBands(const LaneStencils<D, S>& stencils, int l, double m,
                                              double lightest) const
  {
    const Grid<D>& grid = connect.grid;
    const int outer = grid.axisOrder[0], fast = grid.axisOrder[D - 1];
    double lineWeight[numLines], along[packed] = {};
    int lineRow[numLines] = {};
    for (int k = 0; k < N; ++k)
      along[k] = coupledPart(stencils.weight[fast][k][l]);
    for (int s = 0; s < numLines; ++s)
    {
      int node = stencils.base[l];
      if constexpr (D == 2)
      {
        lineWeight[s] = coupledPart(stencils.weight[outer][s][l]);
        node += s * grid.stride[outer];
      }
      else
      {
        const int middle = grid.axisOrder[1];
        lineWeight[s] =
            coupledPart(stencils.weight[outer][s / N][l]) * coupledPart(stencils.weight[middle][s % N][l]);
        node += s / N * grid.stride[outer] + s % N * grid.stride[middle];
      }
      if (lineWeight[s] == 0.0)
        continue;
      lineRow[s] = system.rowOf(node);
      if (lineRow[s] < 0)
        return;
      for (int k = 0; k < N; ++k)
        if (lineWeight[s] * along[k] > barelyTouched && system.lumped(lineRow[s] + k) < lightest)
          return;
    }
    const Pack<packed> line = Pack<packed>::load(along);
    for (int s = 0; s < numLines; ++s)
    {
      if (lineWeight[s] == 0.0)
        continue;
      double* values = system.band.data() + static_cast<std::size_t>(lineRow[s]) * system.stride;
      for (int k = 0; k < N; ++k, values += system.stride)
      {
        // A node without weight may have no row; the next row then belongs to another node.
        if (along[k] == 0.0)
          continue;
        const double mk = m * lineWeight[s] * along[k];
        for (int t = 0; t < numLines; ++t)
        {
          double* const to = values + lineOf(s, t) * span + reach - k;
          Pack<packed> sum = Pack<packed>::load(to);
          sum.add(mk * lineWeight[t], line);
          sum.store(to);
        }
      }
    }
  }

  /// Where cells are refined, the contribution of a particle to a node that it barely touches stays lumped.
  /// The weight of a particle may be zero to round-off and its slope not, while the node has hardly any mass
  /// from others: its acceleration is arbitrary, and solves would spread it.
  KOKKOS_FORCEINLINE_FUNCTION double coupledPart(double weight) const
  {
    return system.hashed && weight <= barelyTouched ? 0.0 : weight;
  }

  /// Where cells are refined: the nodes of the stencil are masters of hanging nodes, and their full mass is
  /// that of their part of the cells.
  KOKKOS_INLINE_FUNCTION void addToHashedLists(int r, double m, double lightest) const
  {
    const StencilTable<D>& table = connect.table;
    int row[stencilCapacity<D>], n = 0;
    double weight[stencilCapacity<D>];
    for (int k = 0; k < table.count(r); ++k)
    {
      const double w = table.weight(r, k);
      if (coupledPart(w) == 0.0)
        continue;
      const int node = table.node(r, k), position = node < numLattice ? node : parent(node - numLattice);
      row[n] = system.rowOf(node);
      if (row[n] < 0 || system.lumped(row[n]) < lightest * nodeFraction(position))
        return;
      weight[n++] = w;
    }
    bool fits = true;
    for (int k = 0; k < n; ++k)
    {
      const int list = system.extraOf(row[k]);
      double* const values = &system.extra(list, 0);
      int* const columns = &system.extraColumn(list, 0);
      const double mk = m * weight[k];
      for (int l = 0; l < n; ++l)
        if (l != k)
          fits = addHashed(values, columns, system.listCapacity, row[l], mk * weight[l]) && fits;
    }
    if (!fits)
      system.overflow() = 1;
  }

  KOKKOS_INLINE_FUNCTION void addToLists(int r, double m, double lightest) const
  {
    const StencilTable<D>& table = connect.table;
    int row[stencilCapacity<D>], number[stencilCapacity<D>], at[stencilCapacity<D>][D],
        field[stencilCapacity<D>];
    double weight[stencilCapacity<D>];
    int low[D], high[D], n = 0;
    for (int k = 0; k < table.count(r); ++k)
    {
      if (table.weight(r, k) == 0.0)
        continue;
      const int node = table.node(r, k);
      row[n] = system.rowOf(node);
      if (row[n] < 0)
        continue; // a ghost's node far from the zone
      if (table.weight(r, k) > barelyTouched && system.lumped(row[n]) < lightest)
        return;
      field[n] = node < numLattice ? 0 : system.slots;
      connect.grid.nodeCoordinates(node < numLattice ? node : parent(node - numLattice), at[n]);
      number[n] = 0;
      for (int d = 0; d < D; ++d)
      {
        number[n] = number[n] * span + at[n][d];
        low[d] = n == 0 || at[n][d] < low[d] ? at[n][d] : low[d];
        high[d] = n == 0 || at[n][d] > high[d] ? at[n][d] : high[d];
      }
      weight[n++] = table.weight(r, k);
    }
    bool near = true;
    for (int d = 0; d < D; ++d)
      near = near && (n == 0 || high[d] - low[d] <= reach);
    const int centre = system.slots / 2;
    for (int k = 0; k < n; ++k)
    {
      const int list = system.extraOf(row[k]);
      double* const values = &system.extra(list, 0);
      const double mk = m * weight[k];
      for (int l = 0; l < n; ++l)
      {
        // A ghost's far node is not coupled: both rows keep that part on their diagonals.
        bool both = near;
        if (!near)
        {
          both = true;
          for (int d = 0; d < D; ++d)
            both = both && at[l][d] - at[k][d] <= reach && at[k][d] - at[l][d] <= reach;
        }
        if (both)
          values[field[l] + centre + number[l] - number[k]] += mk * weight[l];
      }
    }
  }
};

} // namespace Rhegma::mass_matrix
