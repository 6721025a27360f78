#include "cracks/Visibility.hpp"

#include "cracks/Junctions.hpp"

#include "base/SmallLoops.hpp"
#include "grid/Tree.hpp"

namespace Rhegma::cracks
{

namespace
{

/// Which nodes a point on a side can't see.
struct Blind
{
  View<int*> nodeSide;
  KOKKOS_INLINE_FUNCTION bool invisible(int node, int side) const
  {
    // A point has a side of one crack. Cracks are three cells apart, except where they join, so that its
    // stencil has no nodes next to another one.
    return nodeSide(node) != 0 && nodeSide(node) == -side;
  }
};

template <int D>
void useEnrichedFields(const State<D>& state, const ObservedPoints<D>& points, const StencilTable<D>& table)
{
  const Blind blind{state.cracks.nodeSide};
  const View<int*> second = state.cracks.enrichedField;
  // Particles next to two joined cracks have a side of each.
  BorrowedView<int*> otherSideOf;
  const bool joined = state.particles.has(otherSide) && points.side.data() == state.stored.points.side.data();
  if (joined)
    otherSideOf = state.particles.integer(otherSide);
  const View<int*> particle = state.stored.particle;
  parallelForSmall(
      "rhegma::cracks::useEnrichedFields", points.count, KOKKOS_LAMBDA(const int r) {
        const int side = points.side(r), count = side != 0 ? table.count(r) : 0;
        const int other = joined ? otherSideOf(particle(r)) : 0;
        for (int k = 0; k < count; ++k)
        {
          const int n = table.node(r, k);
          if (blind.invisible(n, side) || (other != 0 && blind.invisible(n, other)))
            table.node(r, k) = second(n);
        }
      });
}

/// The cell in which a point lies, a leaf where cells are refined.
struct CellAround
{
  const TreeSight<2>& sight;
  TreeSight<2>::Leaf leaf;

  KOKKOS_INLINE_FUNCTION CellAround(const TreeSight<2>& s, const Vector<2>& x) : sight(s), leaf(s.leafAt(x))
  {
  }

  /// Whether a node is one of its corners, or one of those between which a hanging corner lies.
  KOKKOS_INLINE_FUNCTION bool hasCorner(int node) const
  {
    for (int k = 0; k < Tree<2>::corners; ++k)
    {
      if (leaf.level == 0)
      {
        if (node == -1 - leaf.number + (k & 1) * sight.grid.stride[0] + (k >> 1) * sight.grid.stride[1])
          return true;
        continue;
      }
      for (int m = 0; m < sight.masterCount(leaf.number, k); ++m)
        if (node == sight.master(leaf.number, k, m))
          return true;
    }
    return false;
  }
};

void breakCells(const State<2>& state, const ObservedPoints<2>& points, const StencilTable<2>& table)
{
  const Blind blind{state.cracks.nodeSide};
  const TreeSight<2> sight(state.mesh.grid, state.mesh.tree);
  Kokkos::parallel_for(
      "rhegma::cracks::breakCells", Kokkos::RangePolicy<ExecSpace>(0, points.count),
      KOKKOS_LAMBDA(const int r) {
        const int side = points.side(r);
        const int count = table.count(r);
        if (count == 0) // on another rank
          return;
        const CellAround cell(sight, {points.position(r, 0), points.position(r, 1)});
        int corners = 0, others = 0;
        double hidden = 0.0, hiddenSlope[2] = {0.0, 0.0}, hiddenHoop = 0.0;
        for (int k = 0; k < count; ++k)
          if (!blind.invisible(table.node(r, k), side))
            ++(cell.hasCorner(table.node(r, k)) ? corners : others);
          else
          {
            hidden += table.weight(r, k);
            for (int d = 0; d < 2; ++d)
              hiddenSlope[d] += table.slope(r, k, d);
            hiddenHoop += table.hasHoop() ? table.hoop(r, k) : 0.0;
          }
        const int visible = corners > 0 ? corners : others;
        if (visible == 0)
          return;
        for (int k = 0; k < count; ++k)
        {
          const bool seen = !blind.invisible(table.node(r, k), side);
          const bool receives = seen && (corners == 0 || cell.hasCorner(table.node(r, k)));
          table.weight(r, k) = (seen ? table.weight(r, k) : 0.0) + (receives ? hidden / visible : 0.0);
          for (int d = 0; d < 2; ++d)
            table.slope(r, k, d) =
                (seen ? table.slope(r, k, d) : 0.0) + (receives ? hiddenSlope[d] / visible : 0.0);
          if (table.hasHoop())
            table.hoop(r, k) = (seen ? table.hoop(r, k) : 0.0) + (receives ? hiddenHoop / visible : 0.0);
        }
      });
}

/// Adds an entry to a row, or to the entry of the same node.
KOKKOS_INLINE_FUNCTION void addEntry(const StencilTable<2>& table, int r, int& count, int node, double weight,
                                     const double* slope)
{
  int k = 0;
  while (k < count && table.node(r, k) != node)
    ++k;
  if (k == count)
  {
    table.node(r, k) = node;
    table.weight(r, k) = 0.0;
    table.slope(r, k, 0) = table.slope(r, k, 1) = 0.0;
    ++count;
  }
  table.weight(r, k) += weight;
  for (int d = 0; d < 2; ++d)
    table.slope(r, k, d) += slope[d];
}

void extrapolate(const State<2>& state, const Ghosts& ghosts, const ObservedPoints<2>& points,
                 const StencilTable<2>& table)
{
  const Blind blind{state.cracks.nodeSide};
  Kokkos::parallel_for(
      "rhegma::cracks::extrapolate", Kokkos::RangePolicy<ExecSpace>(0, points.count),
      KOKKOS_LAMBDA(const int r) {
        const int side = points.side(r);
        const int unbroken = table.count(r);
        int node[stencilCapacity<2>];
        double weight[stencilCapacity<2>], slope[stencilCapacity<2>][2];
        for (int k = 0; k < unbroken; ++k)
        {
          node[k] = table.node(r, k);
          weight[k] = table.weight(r, k);
          slope[k][0] = table.slope(r, k, 0);
          slope[k][1] = table.slope(r, k, 1);
        }
        int count = 0;
        for (int k = 0; k < unbroken; ++k)
        {
          const int step = blind.invisible(node[k], side) ? static_cast<int>(ghosts.step(node[k])) : 0;
          if (step == 0)
          {
            addEntry(table, r, count, node[k], weight[k], slope[k]);
            continue;
          }
          const int steps = ghosts.distance(node[k]);
          const double far = -steps * ghosts.linear(node[k]), near = 1.0 - far;
          const double nearSlope[2] = {near * slope[k][0], near * slope[k][1]};
          const double farSlope[2] = {far * slope[k][0], far * slope[k][1]};
          addEntry(table, r, count, node[k] + steps * step, near * weight[k], nearSlope);
          addEntry(table, r, count, node[k] + (steps + 1) * step, far * weight[k], farSlope);
        }
        table.count(r) = count;
      });
}

} // namespace

template <int D>
void editStencils(const State<D>& state, Formulation formulation, const Ghosts& ghosts,
                  const ObservedPoints<D>& points, const StencilTable<D>& table)
{
  if (formulation == Formulation::DualField)
    useEnrichedFields(state, points, table);
  if constexpr (D == 2) // other formulations are 2D only
  {
    if (formulation == Formulation::BrokenCell)
      breakCells(state, points, table);
    else if (formulation == Formulation::CorrectedBrokenCell)
      extrapolate(state, ghosts, points, table);
  }
}

template void editStencils(const State<2>&, Formulation, const Ghosts&, const ObservedPoints<2>&,
                           const StencilTable<2>&);
template void editStencils(const State<3>&, Formulation, const Ghosts&, const ObservedPoints<3>&,
                           const StencilTable<3>&);

} // namespace Rhegma::cracks
