#include "cracks/Visibility.hpp"

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
    // A point knows the side of one crack; nodes of another crack's neighbourhood are far enough not to be in
    // its stencil together with that crack (cracks keep three cells apart).
    return nodeSide(node) != 0 && nodeSide(node) == -side;
  }
};

void useSecondFields(const State<2>& state, const ObservedPoints<2>& points, const StencilTable<2>& table)
{
  const Blind blind{state.cracks.nodeSide};
  const View<int*> second = state.cracks.second;
  Kokkos::parallel_for(
      "rhegma::cracks::useSecondFields", Kokkos::RangePolicy<ExecSpace>(0, points.count),
      KOKKOS_LAMBDA(const int r) {
        for (int k = 0; k < table.count(r); ++k)
        {
          const int n = table.node(r, k);
          if (blind.invisible(n, points.side(r)))
            table.node(r, k) = second(n);
        }
      });
}

void breakCells(const State<2>& state, const ObservedPoints<2>& points, const StencilTable<2>& table)
{
  const Blind blind{state.cracks.nodeSide};
  Kokkos::parallel_for(
      "rhegma::cracks::breakCells", Kokkos::RangePolicy<ExecSpace>(0, points.count),
      KOKKOS_LAMBDA(const int r) {
        const int side = points.side(r);
        const int count = table.count(r);
        // Only nodes that the unbroken function reaches are around the point.
        int visible = 0;
        double hidden = 0.0, hiddenSlope[2] = {0.0, 0.0};
        for (int k = 0; k < count; ++k)
          if (!blind.invisible(table.node(r, k), side))
            visible += table.weight(r, k) != 0.0 ? 1 : 0;
          else
          {
            hidden += table.weight(r, k);
            for (int d = 0; d < 2; ++d)
              hiddenSlope[d] += table.slope(r, k, d);
          }
        if (visible == 0)
          return;
        for (int k = 0; k < count; ++k)
        {
          const bool seen = !blind.invisible(table.node(r, k), side);
          const bool around = table.weight(r, k) != 0.0;
          table.weight(r, k) = seen && around ? table.weight(r, k) + hidden / visible : 0.0;
          for (int d = 0; d < 2; ++d)
            table.slope(r, k, d) = seen && around ? table.slope(r, k, d) + hiddenSlope[d] / visible : 0.0;
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

/// From node m towards the point's side: axis and sense of the extrapolation, the axis along which the
/// crack's normal is largest where m lies.
struct Towards
{
  Grid<2> grid;
  View<double* [2]> vertex;
  View<int* [2]> simplex;
  View<int*> crackOf;

  KOKKOS_INLINE_FUNCTION int step(int m, int side) const
  {
    const Vector<2> x = grid.nodePosition(m);
    const int crack = (side > 0 ? side : -side) - 1;
    double nearest = 1e300, normal[2] = {0.0, 1.0};
    for (int s = 0; s < static_cast<int>(simplex.extent(0)); ++s)
    {
      if (crackOf(s) != crack)
        continue;
      const int a = simplex(s, 0), b = simplex(s, 1);
      const double tx = vertex(b, 0) - vertex(a, 0), ty = vertex(b, 1) - vertex(a, 1);
      double at = ((x[0] - vertex(a, 0)) * tx + (x[1] - vertex(a, 1)) * ty) / (tx * tx + ty * ty);
      at = at < 0.0 ? 0.0 : (at > 1.0 ? 1.0 : at);
      const double dx = x[0] - vertex(a, 0) - at * tx, dy = x[1] - vertex(a, 1) - at * ty;
      if (dx * dx + dy * dy < nearest)
      {
        nearest = dx * dx + dy * dy;
        normal[0] = -ty;
        normal[1] = tx;
      }
    }
    const int axis = std::abs(normal[0]) > std::abs(normal[1]) ? 0 : 1;
    const bool positive = (normal[axis] > 0.0) == (side > 0);
    return positive ? grid.stride[axis] : -grid.stride[axis];
  }
};

void extrapolate(const State<2>& state, const ObservedPoints<2>& points, const StencilTable<2>& table)
{
  const Blind blind{state.cracks.nodeSide};
  const Towards towards{state.grid, state.cracks.vertex, state.cracks.simplex, state.cracks.crackOf};
  Kokkos::parallel_for(
      "rhegma::cracks::extrapolate", Kokkos::RangePolicy<ExecSpace>(0, points.count),
      KOKKOS_LAMBDA(const int r) {
        const int side = points.side(r);
        const int unbroken = table.count(r);
        bool sees = false;
        for (int k = 0; k < unbroken; ++k)
          sees = sees || !blind.invisible(table.node(r, k), side);
        if (!sees)
          return;
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
          if (!blind.invisible(node[k], side))
          {
            addEntry(table, r, count, node[k], weight[k], slope[k]);
            continue;
          }
          const int step = towards.step(node[k], side);
          int steps = 1; // to the nearest visible node
          while (steps < 3 && blind.invisible(node[k] + steps * step, side))
            ++steps;
          const double near = steps + 1.0, far = -double(steps);
          const double nearSlope[2] = {near * slope[k][0], near * slope[k][1]};
          const double farSlope[2] = {far * slope[k][0], far * slope[k][1]};
          addEntry(table, r, count, node[k] + steps * step, near * weight[k], nearSlope);
          addEntry(table, r, count, node[k] + (steps + 1) * step, far * weight[k], farSlope);
        }
        table.count(r) = count;
      });
}

} // namespace

void editStencils(const State<2>& state, Formulation formulation, const ObservedPoints<2>& points,
                  const StencilTable<2>& table)
{
  if (formulation == Formulation::DualField)
    useSecondFields(state, points, table);
  else if (formulation == Formulation::BrokenCell)
    breakCells(state, points, table);
  else
    extrapolate(state, points, table);
}

} // namespace Rhegma::cracks
