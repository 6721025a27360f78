#include "rigid_tools/CellsNearTool.hpp"

#include "grid/BlockCells.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::rigid_tools
{

namespace
{

/// Distance up to which particles count as near [cells]: half a cell for windows of nodes, and half of the
/// diagonal of a domain as large as a cell.
constexpr double nearIn = 1.5;
/// Motion of the tool after which cells are marked again [cells].
constexpr double slackIn = 0.5;

/// Cells along the axes, from `low` on.
template <int D>
struct CellBox
{
  int low[D];
  int count[D];
};

/// Marks the cells of a box near a tool: boxes are cut in two until they are a cell, or all near or all far.
template <int D>
class MarkCells
{
public:
  template <class HostMarks>
  MarkCells(const Grid<D>& grid, const Tool<D>& tool, const HostMarks& marks)
      : grid_(grid), tool_(tool), marks_(marks.data())
  {
  }

  void mark(const CellBox<D>& box) const
  {
    Vector<D> centre;
    double square = 0.0;
    int longest = 0;
    for (int d = 0; d < D; ++d)
    {
      centre[d] = grid_.origin[d] + grid_.spacing * (box.low[d] + 0.5 * box.count[d]);
      square += 0.25 * box.count[d] * box.count[d];
      longest = box.count[d] > box.count[longest] ? d : longest;
    }
    const double radius = grid_.spacing * std::sqrt(square);
    const double depth = tool_.shape().depth(tool_.placement().toOwn(centre));
    const double least = -(radius + (nearIn + slackIn) * grid_.spacing);
    if (depth < least)
      return;
    if (depth >= radius || box.count[longest] == 1)
      return fill(box);
    CellBox<D> lower = box, upper = box;
    lower.count[longest] = box.count[longest] / 2;
    upper.low[longest] += lower.count[longest];
    upper.count[longest] -= lower.count[longest];
    mark(lower);
    mark(upper);
  }

private:
  void fill(const CellBox<D>& box) const
  {
    int all = 1;
    for (int d = 0; d < D; ++d)
      all *= box.count[d];
    for (int k = 0; k < all; ++k)
    {
      int at[D], rest = k;
      for (int d = 0; d < D; ++d)
      {
        at[d] = box.low[d] + rest % box.count[d];
        rest /= box.count[d];
      }
      marks_[grid_.nodeIndex(at)] = 1;
    }
  }

  const Grid<D>& grid_;
  const Tool<D>& tool_;
  char* marks_;
};

template <int D>
void markCells(const State<D>& state, const Tool<D>& tool, CellsNearTool<D>& near)
{
  const Grid<D>& grid = state.mesh.grid;
  if (static_cast<int>(near.marked.extent(0)) < grid.numNodes)
    near.marked = View<char*>("rhegma::cellsNearTool", grid.numNodes);
  const auto marks = Kokkos::create_mirror_view(near.marked);
  Kokkos::deep_copy(marks, char(0));
  CellBox<D> all;
  for (int d = 0; d < D; ++d)
  {
    all.low[d] = 0;
    all.count[d] = grid.cells[d];
  }
  MarkCells<D>(grid, tool, marks).mark(all);
  Kokkos::deep_copy(near.marked, marks);
  near.placement = tool.placement();
  near.origin = grid.origin;
}

template <int D>
void markBlocks(const State<D>& state, CellsNearTool<D>& near)
{
  const Blocks<D>& blocks = state.mesh.blocks;
  const Grid<D> grid = state.mesh.grid;
  if (static_cast<int>(near.nearBlock.extent(0)) < blocks.numBlocks)
  {
    near.nearBlock = View<char*>("rhegma::blocksNearTool", 2 * blocks.numBlocks);
    near.firstOfBlock = View<int*>("rhegma::particlesNearToolInBlocks", 2 * blocks.numBlocks);
  }
  constexpr int beyond = 1; // that particles may be outside of their block
  const View<char*> marked = near.marked, nearBlock = near.nearBlock;
  const View<int * [Blocks<D>::axes]> corner = blocks.corner;
  int count = 0;
  Kokkos::parallel_reduce(
      "rhegma::blocksNearTool", Kokkos::RangePolicy<ExecSpace>(0, blocks.numBlocks),
      KOKKOS_LAMBDA(const int b, int& sum) {
        nearBlock(b) = anyCellMarked(grid, marked, corner, b, beyond) ? 1 : 0;
        sum += nearBlock(b);
      },
      count);
  near.anyNear = count > 0;
  near.sorts = state.particles.sorts;
}

/// Whether the cell of a particle is marked.
template <int D>
struct IsNear
{
  Grid<D> grid;
  BorrowedView<double* [D]> position;
  View<char*> marked;

  KOKKOS_INLINE_FUNCTION bool operator()(int p) const
  {
    int cell = 0;
    for (int d = 0; d < D; ++d)
      cell += grid.stride[d] * static_cast<int>(grid.inCells(position(p, d), d));
    return marked(cell) != 0;
  }
};

template <int D>
void listParticles(const State<D>& state, CellsNearTool<D>& near)
{
  const View<int*> first = state.mesh.blocks.first, firstOfBlock = near.firstOfBlock;
  const View<char*> nearBlock = near.nearBlock;
  const IsNear<D> isNear{state.mesh.grid, state.particles.template real<D>(fields::position), near.marked};
  Kokkos::parallel_scan(
      "rhegma::countParticlesNearTool", Kokkos::RangePolicy<ExecSpace>(0, state.mesh.blocks.numBlocks),
      KOKKOS_LAMBDA(const int b, int& at, const bool final) {
        if (final)
          firstOfBlock(b) = at;
        const int end = nearBlock(b) != 0 ? first(b + 1) : first(b);
        for (int p = first(b); p < end; ++p)
          at += isNear(p) ? 1 : 0;
      },
      near.count);
  if (static_cast<int>(near.particle.extent(0)) < near.count)
    near.particle = View<int*>("rhegma::particlesNearTool", 2 * near.count);
  const View<int*> particle = near.particle;
  Kokkos::parallel_for(
      "rhegma::listParticlesNearTool", Kokkos::RangePolicy<ExecSpace>(0, state.mesh.blocks.numBlocks),
      KOKKOS_LAMBDA(const int b) {
        const int end = nearBlock(b) != 0 ? first(b + 1) : first(b);
        int at = firstOfBlock(b);
        for (int p = first(b); p < end; ++p)
          if (isNear(p))
            particle(at++) = p;
      });
}

} // namespace

template <int D>
void listParticlesNear(const State<D>& state, const Tool<D>& tool, CellsNearTool<D>& near)
{
  const Grid<D>& grid = state.mesh.grid;
  const bool marked = near.marked.extent(0) > 0;
  const double moved = tool.distanceFrom(near.placement) + norm(grid.origin - near.origin);
  const bool again = !marked || moved > slackIn * grid.spacing;
  if (again)
    markCells(state, tool, near);
  if (again || near.sorts != state.particles.sorts)
    markBlocks(state, near);
  near.count = 0;
  if (near.anyNear)
    listParticles(state, near);
}

template void listParticlesNear(const State<2>&, const Tool<2>&, CellsNearTool<2>&);
template void listParticlesNear(const State<3>&, const Tool<3>&, CellsNearTool<3>&);

} // namespace Rhegma::rigid_tools
