#include "grid/FineNodes.hpp"

#include <algorithm>

namespace Rhegma
{

namespace
{

/// A number of a position, in the order of its coordinates, the first one slowest.
template <int D>
std::uint64_t keyOf(const std::array<int, D>& position)
{
  std::uint64_t packed = 0;
  for (int d = 0; d < D; ++d)
    packed = packed << Branches<D>::bitsPerAxis | static_cast<std::uint64_t>(position[d]);
  return packed;
}

template <int D>
std::array<int, D> positionOf(std::uint64_t packed)
{
  constexpr std::uint64_t mask = (std::uint64_t(1) << Branches<D>::bitsPerAxis) - 1;
  std::array<int, D> position;
  for (int d = D - 1; d >= 0; --d, packed >>= Branches<D>::bitsPerAxis)
    position[d] = static_cast<int>(packed & mask);
  return position;
}

} // namespace

template <int D>
FineNodes<D>::FineNodes(const LeafList<D>& leaves)
{
  KeyNumbers seen;
  std::vector<Corner> found; // of each key that was seen
  std::vector<std::array<int, corners>> number(leaves.size());
  for (int l = 0; l < leaves.size(); ++l)
    for (int k = 0; k < corners; ++k)
    {
      number[l][k] = seen.add(keyOf<D>(leaves.corner(l, k)));
      if (number[l][k] == static_cast<int>(found.size()))
        found.push_back(cornerOf(leaves, l, k));
    }
  numberRows(leaves, found);
  std::vector<Masters> rows(found.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    rows[i].fill(0);
    for (int m = 0; m < found[i].count; ++m)
      rows[i][m] = rowAt(leaves, found[i].master[m]);
  }
  masterCount.resize(leaves.size());
  master.resize(leaves.size());
  for (int l = 0; l < leaves.size(); ++l)
    for (int k = 0; k < corners; ++k)
    {
      masterCount[l][k] = found[number[l][k]].count;
      master[l][k] = rows[number[l][k]];
    }
}

/// Numbers the nodes that are not nodes of the lattice by their position.
template <int D>
void FineNodes<D>::numberRows(const LeafList<D>& leaves, const std::vector<Corner>& found)
{
  for (const Corner& corner : found)
    for (int m = 0; m < corner.count; ++m)
      if (!leaves.onLattice(corner.master[m]))
        known_.add(keyOf<D>(corner.master[m]));
  row_ = known_.keys();
  std::sort(row_.begin(), row_.end());
  rowOf_.resize(row_.size());
  for (std::size_t i = 0; i < row_.size(); ++i)
    rowOf_[known_.find(row_[i])] = leaves.grid().numNodes + static_cast<int>(i);
}

template <int D>
int FineNodes<D>::rowAt(const LeafList<D>& leaves, const Cell& position) const
{
  return leaves.onLattice(position) ? leaves.latticeNodeAt(position)
                                    : rowOf_[known_.find(keyOf<D>(position))];
}

template <int D>
typename FineNodes<D>::Corner FineNodes<D>::cornerOf(const LeafList<D>& leaves, int leaf, int k) const
{
  Corner corner;
  corner.count = 1;
  corner.master[0] = leaves.corner(leaf, k);
  Cell at; // in edges of the leaf
  bool between = false;
  for (int d = 0; d < D; ++d)
  {
    at[d] = leaves.cell[leaf][d] + ((k >> d) & 1);
    between = between || at[d] % 2 != 0;
  }
  if (!between || !hangs(leaves, leaves.level[leaf], at))
    return corner;
  const int edge = leaves.edge(leaves.level[leaf]);
  for (int d = 0; d < D; ++d)
    if (at[d] % 2 != 0)
    {
      for (int m = 0; m < corner.count; ++m)
      {
        corner.master[corner.count + m] = corner.master[m];
        corner.master[m][d] -= edge;
        corner.master[corner.count + m][d] += edge;
      }
      corner.count *= 2;
    }
  return corner;
}

/// Whether a corner of a leaf, in edges of cells of its level, lies between corners of a leaf of the level
/// above. Neighbours differ by one level at most, so no other leaf has it on its face.
template <int D>
bool FineNodes<D>::hangs(const LeafList<D>& leaves, int level, const Cell& position) const
{
  for (int side = 0; side < corners; ++side)
  {
    Cell cell;
    bool differs = true; // from those before: along an odd coordinate both sides are in one cell
    for (int d = 0; d < D; ++d)
    {
      const int upper = (side >> d) & 1;
      differs = differs && (position[d] % 2 == 0 || upper == 0);
      cell[d] = (position[d] - 1 + upper) >> 1;
    }
    if (differs && leaves.branches().isInside(level - 1, cell) &&
        !leaves.branches().isRefined(level - 1, cell))
      return true;
  }
  return false;
}

template <int D>
std::vector<typename FineNodes<D>::Cell> FineNodes<D>::positions() const
{
  std::vector<Cell> all;
  all.reserve(row_.size());
  for (const std::uint64_t packed : row_)
    all.push_back(positionOf<D>(packed));
  return all;
}

template class FineNodes<2>;
template class FineNodes<3>;

} // namespace Rhegma
