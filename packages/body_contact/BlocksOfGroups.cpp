/// Which blocks of cells have several groups of bodies in or next to them.

#include "body_contact/SharedNodes.hpp"

namespace Rhegma::body_contact
{

namespace
{

/// Lowest and highest group in each block of the lattice, particles or not.
using GroupRange = View<int** [2]>;

constexpr int noGroup = 1 << 30;

/// \return blocks of the lattice along each axis that is cut
template <int D>
GroupRange groupsOfBlocks(const State<D>& state)
{
  const Grid<D>& grid = state.mesh.grid;
  const Blocks<D> blocks = state.mesh.blocks;
  GroupRange range("rhegma::groupsOfBlocks", grid.cells[grid.axisOrder[0]] / Blocks<D>::edge + 1,
                   grid.cells[grid.axisOrder[1]] / Blocks<D>::edge + 1);
  Kokkos::parallel_for(
      "rhegma::clearGroupsOfBlocks", Kokkos::RangePolicy<ExecSpace>(0, range.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        for (int j = 0; j < static_cast<int>(range.extent(1)); ++j)
        {
          range(i, j, 0) = noGroup;
          range(i, j, 1) = -1;
        }
      });
  const auto bodyGroup = state.particles.integer(fields::bodyGroup);
  Kokkos::parallel_for(
      "rhegma::groupsOfBlocks", Kokkos::RangePolicy<ExecSpace>(0, blocks.numBlocks),
      KOKKOS_LAMBDA(const int b) {
        int lowest = noGroup, highest = -1;
        for (int p = blocks.first(b); p < blocks.first(b + 1); ++p)
        {
          const int group = bodyGroup(p);
          lowest = group < lowest ? group : lowest;
          highest = group > highest ? group : highest;
        }
        const int i = blocks.corner(b, 0) / Blocks<D>::edge, j = blocks.corner(b, 1) / Blocks<D>::edge;
        range(i, j, 0) = lowest;
        range(i, j, 1) = highest;
      });
  return range;
}

/// Marks the blocks that have more than one group in them and their neighbours: a particle is at most a cell
/// outside of its block and touches nodes at most three cells from its own.
template <int D>
int markNearBlocks(const Blocks<D>& blocks, const GroupRange& range, const View<char*>& nearBlock)
{
  int count = 0;
  Kokkos::parallel_reduce(
      "rhegma::markNearBlocks", Kokkos::RangePolicy<ExecSpace>(0, blocks.numBlocks),
      KOKKOS_LAMBDA(const int b, int& sum) {
        const int i = blocks.corner(b, 0) / Blocks<D>::edge, j = blocks.corner(b, 1) / Blocks<D>::edge;
        int lowest = noGroup, highest = -1;
        for (int k = -1; k <= 1; ++k)
          for (int l = -1; l <= 1; ++l)
          {
            const int at = i + k, next = j + l;
            if (at < 0 || next < 0 || at >= static_cast<int>(range.extent(0)) ||
                next >= static_cast<int>(range.extent(1)))
              continue;
            lowest = range(at, next, 0) < lowest ? range(at, next, 0) : lowest;
            highest = range(at, next, 1) > highest ? range(at, next, 1) : highest;
          }
        nearBlock(b) = lowest < highest ? 1 : 0;
        sum += nearBlock(b);
      },
      count);
  return count;
}

} // namespace

template <int D>
bool areApart(const State<D>& state, SharedNodes<D>& shared)
{
  if (shared.sorts == state.particles.sorts)
    return !shared.anyNear;
  shared.sorts = state.particles.sorts;
  const Blocks<D>& blocks = state.mesh.blocks;
  shared.nearBlock = View<char*>("rhegma::blocksNearGroups", blocks.numBlocks);
  shared.anyNear = markNearBlocks(blocks, groupsOfBlocks(state), shared.nearBlock) > 0;
  return !shared.anyNear;
}

template bool areApart(const State<2>&, SharedNodes<2>&);
template bool areApart(const State<3>&, SharedNodes<3>&);

} // namespace Rhegma::body_contact
