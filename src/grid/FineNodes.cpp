#include "grid/FineNodes.hpp"

namespace Rhegma
{

namespace
{

/// The smallest cell, a leaf or a cell of the lattice, in which a finest cell lies.
template <int D>
int levelAround(const Branches<D>& branches, const std::array<int, D>& finest, std::array<int, D>& cell)
{
  for (int level = 0;; ++level)
  {
    for (int d = 0; d < D; ++d)
      cell[d] = finest[d] >> (branches.depth() - level);
    if (!branches.isRefined(level, cell))
      return level;
  }
}

} // namespace

template <int D>
FineNodes<D>::FineNodes(const LeafList<D>& leaves)
{
  std::map<Cell, std::vector<Cell>> mastersAt;
  for (int l = 0; l < leaves.size(); ++l)
    for (int k = 0; k < corners; ++k)
    {
      const Cell position = leaves.corner(l, k);
      if (mastersAt.count(position) == 0)
        mastersAt[position] = mastersOf(leaves, position);
    }
  for (const auto& entry : mastersAt)
    for (const Cell& position : entry.second)
      if (!leaves.onLattice(position))
        row_[position] = 0;
  int next = leaves.grid().numNodes;
  for (auto& entry : row_)
    entry.second = next++;
  masterCount.resize(leaves.size());
  master.resize(leaves.size());
  for (int l = 0; l < leaves.size(); ++l)
    for (int k = 0; k < corners; ++k)
    {
      const std::vector<Cell>& masters = mastersAt[leaves.corner(l, k)];
      masterCount[l][k] = static_cast<int>(masters.size());
      master[l][k].fill(0);
      for (std::size_t m = 0; m < masters.size(); ++m)
        master[l][k][m] =
            leaves.onLattice(masters[m]) ? leaves.latticeNodeAt(masters[m]) : row_.at(masters[m]);
    }
}

/// The corners, in finest cells, between which a position of the finest lattice hangs; itself alone where it
/// hangs nowhere.
template <int D>
std::vector<typename FineNodes<D>::Cell> FineNodes<D>::mastersOf(const LeafList<D>& leaves,
                                                                 const Cell& position) const
{
  const Grid<D>& grid = leaves.grid();
  for (int k = 0; k < corners; ++k)
  {
    // The cell on one of the sides of the position.
    Cell inside;
    bool exists = true;
    for (int d = 0; d < D; ++d)
    {
      inside[d] = position[d] - 1 + ((k >> d) & 1);
      exists = exists && inside[d] >= 0 && inside[d] < grid.cells[d] << leaves.depth();
    }
    if (!exists)
      continue;
    Cell cell;
    const int size = leaves.edge(levelAround<D>(leaves.branches(), inside, cell));
    bool hangs = false;
    for (int d = 0; d < D; ++d)
      hangs = hangs || position[d] % size != 0;
    if (!hangs)
      continue;
    std::vector<Cell> masters{position};
    for (int d = 0; d < D; ++d)
      if (position[d] % size != 0)
      {
        const std::size_t count = masters.size();
        for (std::size_t m = 0; m < count; ++m)
        {
          masters.push_back(masters[m]);
          masters[m][d] = cell[d] * size;
          masters.back()[d] = (cell[d] + 1) * size;
        }
      }
    return masters;
  }
  return {position};
}

template <int D>
std::vector<typename FineNodes<D>::Cell> FineNodes<D>::positions() const
{
  std::vector<Cell> all;
  all.reserve(row_.size());
  for (const auto& entry : row_)
    all.push_back(entry.first);
  return all;
}

template class FineNodes<2>;
template class FineNodes<3>;

} // namespace Rhegma
