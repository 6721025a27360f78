#include "grid/Blocks.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <string>

namespace Rhegma
{

namespace
{

/// Sort key of a particle: colour, block, cell inside the block.
template <int D>
struct BlockLayout
{
  Grid<D> grid;
  int across[2]; ///< blocks along the cut axes

  explicit BlockLayout(const Grid<D>& lattice) : grid(lattice)
  {
    for (int a = 0; a < 2; ++a)
      across[a] = lattice.cells[lattice.axisOrder[a]] / Blocks<D>::edge + 1;
  }

  std::int64_t block(const int (&at)[2]) const
  {
    const int colour = 2 * (at[0] % 2) + at[1] % 2;
    return (std::int64_t(colour) * across[0] + at[0]) * across[1] + at[1];
  }

  /// Block of the cell with this lowest node.
  std::int64_t blockOf(int node) const
  {
    int at[D];
    grid.nodeCoordinates(node, at);
    const int cut[2] = {at[grid.axisOrder[0]] / Blocks<D>::edge, at[grid.axisOrder[1]] / Blocks<D>::edge};
    return block(cut);
  }

  /// Blocks are less than this.
  std::int64_t count() const { return std::int64_t(Blocks<D>::colours) * across[0] * across[1]; }

  int colourOf(std::int64_t key) const { return static_cast<int>(key / across[1] / across[0]); }
};

/// Cells of a block that hold particles, in their order, and how many particles these are.
struct BlockRun
{
  std::int64_t key;
  int begin, end, particles;
};

/// The cells that hold particles, by block and then by their number. \param number of particles in each cell
/// \param cells out: these cells \return the blocks
template <int D>
std::vector<BlockRun> occupiedBlocks(const BlockLayout<D>& layout, const std::vector<int>& number,
                                     std::vector<int>& cells)
{
  std::vector<std::int64_t> keys;
  std::vector<int> occupied, first(layout.count() + 1, 0);
  for (int n = 0; n < static_cast<int>(number.size()); ++n)
    if (number[n] > 0)
    {
      occupied.push_back(n);
      keys.push_back(layout.blockOf(n));
      ++first[keys.back() + 1];
    }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<BlockRun> runs;
  for (std::int64_t key = 0; key < layout.count(); ++key)
    if (first[key + 1] > first[key])
      runs.push_back({key, first[key], first[key + 1], 0});
  cells.resize(occupied.size());
  for (std::size_t i = 0; i < occupied.size(); ++i)
    cells[first[keys[i]]++] = occupied[i];
  for (BlockRun& run : runs)
    for (int i = run.begin; i < run.end; ++i)
      run.particles += number[cells[i]];
  return runs;
}

/// The blocks of each colour with the most particles first, so that the threads finish at the same time.
template <int D>
void sortLargestFirst(const BlockLayout<D>& layout, std::vector<BlockRun>& runs)
{
  std::stable_sort(runs.begin(), runs.end(),
                   [&](const BlockRun& a, const BlockRun& b)
                   {
                     const int of[2] = {layout.colourOf(a.key), layout.colourOf(b.key)};
                     return of[0] != of[1] ? of[0] < of[1] : a.particles > b.particles;
                   });
}

template <class T>
View<T*> toDevice(const std::string& label, const std::vector<T>& list)
{
  View<T*> view(label, list.size());
  const auto host = Kokkos::create_mirror_view(view);
  std::copy(list.begin(), list.end(), host.data());
  Kokkos::deep_copy(view, host);
  return view;
}

/// The cell of each particle, by its lowest node, and how many particles are in each cell.
template <int D, class Positions>
void findCells(const Grid<D>& grid, const Positions& position, std::vector<int>& cell,
               std::vector<int>& number)
{
  for (std::size_t p = 0; p < cell.size(); ++p)
  {
    int at[D];
    for (int d = 0; d < D; ++d)
      at[d] = std::clamp(static_cast<int>(grid.inCells(position(p, d), d)), 0, grid.cells[d] - 1);
    cell[p] = grid.nodeIndex(at);
    ++number[cell[p]];
  }
}

/// Extends the marks by `below` and `above` nodes along every axis.
template <int D>
std::vector<char> dilate(const Grid<D>& grid, std::vector<char> marked, int below, int above)
{
  for (int axis = 0; axis < D; ++axis)
  {
    // Nodes next to each other along the axis are `stride` apart; all with the same slower coordinates are
    // one piece of memory.
    std::vector<char> wider(marked.size(), 0);
    const int stride = grid.stride[axis], length = grid.cells[axis] + 1, piece = stride * length;
    for (int start = 0; start < grid.numNodes; start += piece)
      for (int by = -below; by <= above; ++by)
        if (std::abs(by) < length)
        {
          const int count = piece - std::abs(by) * stride;
          const char* const from = marked.data() + start + std::max(0, -by) * stride;
          char* const to = wider.data() + start + std::max(0, by) * stride;
          for (int i = 0; i < count; ++i)
            to[i] |= from[i];
        }
    marked.swap(wider);
  }
  return marked;
}

/// The nodes of the widest stencil from any of some cells: GIMP reaches two beyond a cell on each side,
/// ghosts of a crack at 45 degrees to the grid three.
template <int D>
View<int*> reachableNodes(const Grid<D>& grid, const std::vector<char>& from)
{
  constexpr int reach = 3;
  const std::vector<char> marked = dilate(grid, from, reach, 1 + reach);
  std::vector<int> list;
  for (int n = 0; n < grid.numNodes; ++n)
    if (marked[n])
      list.push_back(n);
  return toDevice("rhegma::activeNodes", list);
}

template <int D>
void makeBundles(const std::vector<int>& first, Blocks<D>& blocks)
{
  std::vector<int> begin, block;
  for (int b = 0; b < blocks.numBlocks; ++b)
    for (int p = first[b]; p < first[b + 1]; p += lanes)
    {
      begin.push_back(p);
      block.push_back(b);
    }
  blocks.numBundles = static_cast<int>(block.size());
  begin.push_back(first.back());
  blocks.bundleFirst = toDevice("rhegma::bundleFirst", begin);
  blocks.bundleBlock = toDevice("rhegma::bundleBlock", block);
}

} // namespace

template <int D>
void sortParticles(const Grid<D>& grid, FieldTable& particles, Blocks<D>& blocks, View<int*>& activeNodes)
{
  const int n = particles.size();
  const BlockLayout<D> layout(grid);
  const auto position = onHost(particles.real<D>(fields::position));

  std::vector<int> cell(n), order(n), number(grid.numNodes, 0);
  std::vector<char> occupied(grid.numNodes, 0);
  findCells(grid, position, cell, number);
  for (int node = 0; node < grid.numNodes; ++node)
    occupied[node] = number[node] > 0 ? 1 : 0;
  std::vector<int> cells;
  std::vector<BlockRun> runs = occupiedBlocks(layout, number, cells);
  sortLargestFirst(layout, runs);
  std::vector<int> first{0}, next(grid.numNodes);
  std::vector<std::int64_t> keys;
  int to = 0;
  for (const BlockRun& run : runs)
  {
    keys.push_back(run.key);
    for (int i = run.begin; i < run.end; ++i)
    {
      next[cells[i]] = to;
      to += number[cells[i]];
    }
    first.push_back(to);
  }
  bool inOrder = true;
  for (int p = 0; p < n; ++p)
  {
    inOrder = inOrder && next[cell[p]] == p;
    order[next[cell[p]]++] = p;
  }
  blocks.numBlocks = static_cast<int>(keys.size());

  blocks.first = toDevice("rhegma::blockFirst", first);
  blocks.corner = View<int * [Blocks<D>::axes]>("rhegma::blockCorner", keys.size());
  const auto hostCorner = Kokkos::create_mirror_view(blocks.corner);
  std::fill(blocks.colourStart, blocks.colourStart + Blocks<D>::colours + 1, 0);
  for (int b = 0; b < blocks.numBlocks; ++b)
  {
    const int at0 = static_cast<int>(keys[b] / layout.across[1] % layout.across[0]);
    const int at1 = static_cast<int>(keys[b] % layout.across[1]);
    hostCorner(b, 0) = at0 * Blocks<D>::edge;
    hostCorner(b, 1) = at1 * Blocks<D>::edge;
    ++blocks.colourStart[2 * (at0 % 2) + at1 % 2 + 1];
  }
  for (int c = 0; c < Blocks<D>::colours; ++c)
    blocks.colourStart[c + 1] += blocks.colourStart[c];
  Kokkos::deep_copy(blocks.corner, hostCorner);
  makeBundles(first, blocks);
  blocks.strays = View<int[2]>("rhegma::strays");

  if (!inOrder)
    particles.reorder(toDevice("rhegma::particleOrder", order));

  const std::vector<char> nearby = dilate(grid, occupied, 1, 1);
  blocks.nearby = toDevice("rhegma::nearbyCells", nearby);
  activeNodes = reachableNodes(grid, nearby);
}

template void sortParticles(const Grid<2>&, FieldTable&, Blocks<2>&, View<int*>&);
template void sortParticles(const Grid<3>&, FieldTable&, Blocks<3>&, View<int*>&);

} // namespace Rhegma
