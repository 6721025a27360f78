#pragma once
/// The lattice of cells and nodes.

#include "base/Types.hpp"

namespace Rhegma
{

/// Layers of cells added around the domain, so that no stencil of a particle inside it leaves the lattice.
constexpr int gridMargin = 4;

/// A box of equal cells: a whole lattice, or a part of one. The nodes of a part have the same positions as in
/// the whole, to the last digit. Nodes are numbered with the longest axis slowest, so that blocks of cells
/// along it are contiguous.
template <int D>
struct Grid
{
  Vector<D> origin; ///< position of node 0, outside of the domain by the margin [m]
  Vector<D> lower;  ///< lower corner of the domain [m]
  Vector<D> upper;  ///< upper corner of the domain [m]
  double spacing;   ///< edge of a cell [m]
  double inverse;   ///< 1 / spacing [1/m]
  int cells[D];     ///< cells along each axis, margins included
  int stride[D];    ///< distance in the numbering between neighbours along each axis
  int axisOrder[D]; ///< axes from slowest to fastest
  int numNodes;
  Vector<D> whole; ///< position of node 0 of the whole lattice [m]
  int before[D]{}; ///< nodes of the whole lattice along each axis before node 0

  /// Coordinates of a position in cells from node 0.
  KOKKOS_INLINE_FUNCTION double inCells(double x, int axis) const { return (x - origin[axis]) * inverse; }

  KOKKOS_INLINE_FUNCTION int nodeIndex(const int (&at)[D]) const
  {
    int n = 0;
    for (int d = 0; d < D; ++d)
      n += at[d] * stride[d];
    return n;
  }

  KOKKOS_INLINE_FUNCTION void nodeCoordinates(int node, int (&at)[D]) const
  {
    for (int k = 0; k < D; ++k)
    {
      const int axis = axisOrder[k];
      at[axis] = node / stride[axis];
      node -= at[axis] * stride[axis];
    }
  }

  KOKKOS_INLINE_FUNCTION Vector<D> nodePosition(int node) const
  {
    int at[D];
    nodeCoordinates(node, at);
    return positionOf(at);
  }

  /// Position of the node with these coordinates.
  KOKKOS_INLINE_FUNCTION Vector<D> positionOf(const int (&at)[D]) const
  {
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = whole[d] + (before[d] + at[d]) * spacing;
    return x;
  }

  /// Moves the cells and the domain. \param by displacement [m]
  void translate(const Vector<D>& by)
  {
    origin = origin + by;
    lower = lower + by;
    upper = upper + by;
    whole = whole + by;
  }

  KOKKOS_INLINE_FUNCTION bool inside(const Vector<D>& x) const
  {
    bool in = true;
    for (int d = 0; d < D; ++d)
      in = in && x[d] >= lower[d] && x[d] <= upper[d];
    return in;
  }
};

/// Numbers the nodes of a lattice whose cells along each axis are known.
template <int D>
void numberNodes(Grid<D>& grid);

/// The lattice over a domain. The upper corner need not be a whole number of cells away: the last cell
/// reaches beyond.
template <int D>
Grid<D> makeGrid(const Vector<D>& lower, const Vector<D>& upper, double spacing);

} // namespace Rhegma
