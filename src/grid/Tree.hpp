#pragma once
/// Refined cells: a tree in each refined cell of the lattice.

#include "grid/Grid.hpp"
#include "grid/StencilTable.hpp"

#include <string>

namespace Rhegma
{

/// Levels below the lattice that a tree can have: cells down to 1/256 of the lattice's.
constexpr int deepestLevel = 8;

/// Leaves and nodes of the refined part of a lattice. A cell that is refined is a branch with 2^D children,
/// each a branch or a leaf; cells of the lattice that are not refined have no entry here. Neighbours, over
/// corners too, differ by one level at most, so that a hanging node lies midway between two (on a face in 3D
/// four) nodes that hang nowhere: its masters. Only those have values. Rows of nodal arrays 0 ..
/// grid.numNodes - 1 are the lattice's nodes, the next numFine ones the nodes of refined cells that are no
/// nodes of the lattice, ordered by their position, so that their numbers do not depend on earlier trees.
template <int D>
struct Tree
{
  static constexpr int corners = 1 << D;
  static constexpr int mastersPerCorner = 1 << (D - 1);
  static constexpr int nodesAround = 1 << (2 * D);

  int deepest = 0;    ///< level of the smallest leaves; 0: nothing is refined
  int numFine = 0;    ///< nodes next to the lattice's
  int generation = 0; ///< incremented with every change

  View<int*> root;         ///< branch of each cell of the lattice, by its lowest node; -1 where it is a leaf
  View<char*> nearRefined; ///< not 0 for refined cells and those next to them
  View<int* [corners]> child;       ///< of each branch: another branch, or -1 - leaf
  View<int* [corners]> masterCount; ///< of each corner of a leaf
  View<int* [corners][mastersPerCorner]> master;
  /// Which of the 3^D cells of its size around each leaf, itself in the middle, are leaves: one bit each, the
  /// first axis fastest.
  View<int*> alike;
  /// The 4^D corners of these cells, the first axis fastest: a row of nodal arrays, or -2 - (corners leaf +
  /// k) where it hangs and is corner k of that leaf, or -1 where it is a corner of no leaf among them.
  View<int* [nodesAround]> around;
  View<double* [D]> finePosition; ///< of the nodes next to the lattice's [m]
  /// Those of them that are corners of leaves in a refined cell of the lattice, whose branch b is:
  /// fineIn(fineBegin(b)) .. fineIn(fineBegin(b + 1) - 1). A node on a face between two such cells is in one
  /// of them.
  View<int*> fineBegin, fineIn;
  View<int*> leafLevel;
  View<double* [D]> leafCorner; ///< lowest corner of each leaf [m]
  /// Volume of each node: integral of its shape function over the uncut cells, in cells of the lattice; of
  /// all rows. Empty where nothing is refined.
  View<double*> nodeVolume;
  /// Level of the smallest leaf around each row of nodal arrays. Empty where nothing is refined.
  View<int*> nodeLevel;

  bool refined() const { return deepest > 0; }
};

/// Positions of nodes.
template <int D>
struct NodePositions
{
  Grid<D> grid;
  View<double* [D]> fine;

  KOKKOS_INLINE_FUNCTION Vector<D> operator()(int node) const
  {
    if (node < grid.numNodes)
      return grid.nodePosition(node);
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = fine(node - grid.numNodes, d);
    return x;
  }
};

/// Leaves that a box touches, and shape functions on them.
template <int D>
struct TreeSight
{
  Grid<D> grid;
  bool refined;
  View<int*> root;
  View<char*> nearRefined;
  View<int * [Tree<D>::corners]> child, masterCount;
  View<int * [Tree<D>::corners][Tree<D>::mastersPerCorner]> master;

  TreeSight() = default;
  TreeSight(const Grid<D>& lattice, const Tree<D>& tree)
      : grid(lattice),
        refined(tree.refined()),
        root(tree.root),
        nearRefined(tree.nearRefined),
        child(tree.child),
        masterCount(tree.masterCount),
        master(tree.master)
  {
  }

  /// A leaf: lowest corner and edge in cells of the lattice from node 0, level, and its number or, where it
  /// is a cell of the lattice, -1 - its lowest node.
  struct Leaf
  {
    double corner[D];
    double edge;
    int level;
    int number;
  };

  /// Calls visit(leaf) for every leaf that the box low .. high overlaps (coordinates in cells); for a point,
  /// low = high, for the one in which it lies.
  template <class Visit>
  KOKKOS_INLINE_FUNCTION void forEachLeaf(const double (&low)[D], const double (&high)[D],
                                          const Visit& visit) const
  {
    int first[D], count[D], all = 1;
    for (int d = 0; d < D; ++d)
    {
      first[d] = static_cast<int>(low[d]);
      int last = static_cast<int>(high[d]);
      last = last > first[d] && !(high[d] > last) ? last - 1 : last;
      count[d] = last - first[d] + 1;
      all *= count[d];
    }
    for (int k = 0; k < all; ++k)
    {
      int at[D], rest = k;
      Leaf cell;
      for (int d = 0; d < D; ++d)
      {
        at[d] = first[d] + rest % count[d];
        rest /= count[d];
        cell.corner[d] = at[d];
      }
      cell.edge = 1.0;
      cell.level = 0;
      const int lowest = grid.nodeIndex(at);
      const int branch = refined ? root(lowest) : -1;
      cell.number = -1 - lowest;
      if (branch < 0)
        visit(cell);
      else
        descend(branch, cell, low, high, visit);
    }
  }

  /// The leaf in which a position lies.
  KOKKOS_INLINE_FUNCTION Leaf leafAt(const Vector<D>& x) const
  {
    Leaf cell;
    int at[D], part[D]; // lattice cell, and in the smallest cells from there
    constexpr int parts = 1 << deepestLevel;
    for (int d = 0; d < D; ++d)
    {
      const double from = grid.inCells(x[d], d);
      at[d] = static_cast<int>(from);
      part[d] = static_cast<int>((from - at[d]) * parts);
      cell.corner[d] = at[d];
    }
    cell.edge = 1.0;
    cell.level = 0;
    const int lowest = grid.nodeIndex(at);
    cell.number = -1 - lowest;
    int branch = refined ? root(lowest) : -1;
    if (branch < 0)
      return cell;
    while (branch >= 0)
    {
      ++cell.level;
      int which = 0;
      for (int d = 0; d < D; ++d)
        which |= ((part[d] >> (deepestLevel - cell.level)) & 1) << d;
      branch = child(branch, which);
    }
    cell.number = -1 - branch;
    cell.edge = 1.0 / (1 << cell.level);
    for (int d = 0; d < D; ++d)
      cell.corner[d] += (part[d] >> (deepestLevel - cell.level)) * cell.edge;
    return cell;
  }

  /// Edge of the leaf in which a position lies [m].
  KOKKOS_INLINE_FUNCTION double spacingAt(const Vector<D>& x) const
  {
    return refined ? leafAt(x).edge * grid.spacing : grid.spacing;
  }

  /// Calls add(node, weight, slope) for the nodes of a box of half widths `half` [m] around x, slope in 1/m;
  /// a node may come several times. The average over each leaf that the box touches is the function's value
  /// and slope at the middle of the overlap, because a multilinear function averages to those there; a
  /// hanging node's weight goes to its masters. Weights sum to one, slopes to zero.
  template <class Add>
  KOKKOS_INLINE_FUNCTION void forEachNode(const Vector<D>& x, const Vector<D>& half, const Add& add) const
  {
    forEachOverlap(x, half,
                   [&](const Leaf& leaf, double fraction, const double(&at)[D])
                   { addCorners(leaf, fraction, at, add); });
  }

  /// Calls add(node, gradient) with slopes that differ between the components of a displacement, as
  /// componentSlopes() has them; a node may come several times.
  template <class Add>
  KOKKOS_INLINE_FUNCTION void forEachGradient(const Vector<D>& x, const Vector<D>& half, const Add& add) const
  {
    forEachOverlap(x, half,
                   [&](const Leaf& leaf, double fraction, const double(&at)[D])
                   { addGradients(leaf, fraction, at, add); });
  }

  /// Calls visit(leaf, fraction, at) for the leaves that a box touches: the fraction of the box in it, and
  /// the middle of the overlap in edges of the leaf from its lowest corner.
  template <class Visit>
  KOKKOS_INLINE_FUNCTION void forEachOverlap(const Vector<D>& x, const Vector<D>& half,
                                             const Visit& visit) const
  {
    double low[D], high[D];
    for (int d = 0; d < D; ++d)
    {
      low[d] = grid.inCells(x[d] - half[d], d);
      high[d] = half[d] > 0.0 ? grid.inCells(x[d] + half[d], d) : low[d];
    }
    forEachLeaf(low, high,
                [&](const Leaf& leaf)
                {
                  double fraction = 1.0, at[D];
                  for (int d = 0; d < D; ++d)
                  {
                    const double begin = low[d] > leaf.corner[d] ? low[d] : leaf.corner[d];
                    const double end =
                        high[d] < leaf.corner[d] + leaf.edge ? high[d] : leaf.corner[d] + leaf.edge;
                    if (high[d] > low[d])
                      fraction *= (end - begin) / (high[d] - low[d]);
                    at[d] = (0.5 * (begin + end) - leaf.corner[d]) / leaf.edge;
                  }
                  visit(leaf, fraction, at);
                });
  }

private:
  template <class Add>
  KOKKOS_INLINE_FUNCTION void addGradients(const Leaf& leaf, double fraction, const double (&at)[D],
                                           const Add& add) const
  {
    AxisStencil<2> axis[D];
    for (int d = 0; d < D; ++d)
      axis[d] = {0, {1.0 - at[d], at[d]}, {-1.0, 1.0}};
    for (int corner = 0; corner < Tree<D>::corners; ++corner)
    {
      int k[D];
      for (int d = 0; d < D; ++d)
        k[d] = (corner >> d) & 1;
      const int masters = leaf.level == 0 ? 1 : masterCount(leaf.number, corner);
      double gradient[D * D];
      componentSlopes<D, 2>(axis, k, fraction * grid.inverse / (leaf.edge * masters), gradient);
      for (int m = 0; m < masters; ++m)
        add(cornerNode(leaf, corner, m), gradient);
    }
  }

  /// The m-th node on which corner k of a leaf depends.
  KOKKOS_INLINE_FUNCTION int cornerNode(const Leaf& leaf, int k, int m) const
  {
    if (leaf.level > 0)
      return master(leaf.number, k, m);
    int node = -1 - leaf.number;
    for (int d = 0; d < D; ++d)
      node += ((k >> d) & 1) * grid.stride[d];
    return node;
  }

  template <class Visit>
  KOKKOS_INLINE_FUNCTION void descend(int branch, const Leaf& top, const double (&low)[D],
                                      const double (&high)[D], const Visit& visit) const
  {
    constexpr int capacity = deepestLevel * (Tree<D>::corners - 1) + 1;
    int waiting[capacity];
    Leaf cell[capacity];
    int size = 1;
    waiting[0] = branch;
    cell[0] = top;
    while (size > 0)
    {
      --size;
      const int of = waiting[size];
      const Leaf parent = cell[size];
      for (int k = 0; k < Tree<D>::corners; ++k)
      {
        Leaf part;
        part.edge = 0.5 * parent.edge;
        part.level = parent.level + 1;
        bool touches = true;
        for (int d = 0; d < D; ++d)
        {
          const double middle = parent.corner[d] + part.edge;
          const bool upper = ((k >> d) & 1) != 0;
          part.corner[d] = upper ? middle : parent.corner[d];
          touches = touches && (upper ? high[d] > middle || low[d] >= middle : low[d] < middle);
        }
        if (!touches)
          continue;
        const int next = child(of, k);
        part.number = -1 - next;
        if (next < 0)
          visit(part);
        else
        {
          waiting[size] = next;
          cell[size++] = part;
        }
      }
    }
  }

  template <class Add>
  KOKKOS_INLINE_FUNCTION void addCorners(const Leaf& leaf, double fraction, const double (&at)[D],
                                         const Add& add) const
  {
    for (int k = 0; k < Tree<D>::corners; ++k)
    {
      double weight = fraction, slope[D];
      for (int d = 0; d < D; ++d)
      {
        const bool upper = ((k >> d) & 1) != 0;
        weight *= upper ? at[d] : 1.0 - at[d];
        slope[d] = (upper ? fraction : -fraction) * grid.inverse / leaf.edge;
        for (int o = 0; o < D; ++o)
          if (o != d)
            slope[d] *= ((k >> o) & 1) != 0 ? at[o] : 1.0 - at[o];
      }
      if (leaf.level == 0)
      {
        int node = -1 - leaf.number;
        for (int d = 0; d < D; ++d)
          node += ((k >> d) & 1) * grid.stride[d];
        add(node, weight, slope);
        continue;
      }
      const int masters = masterCount(leaf.number, k);
      const double each = 1.0 / masters;
      weight *= each;
      for (int d = 0; d < D; ++d)
        slope[d] *= each;
      for (int m = 0; m < masters; ++m)
        add(master(leaf.number, k, m), weight, slope);
    }
  }
};

} // namespace Rhegma
