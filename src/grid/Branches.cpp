#include "grid/Branches.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma
{

namespace
{

template <int D>
std::array<int, D> halved(const std::array<int, D>& cell)
{
  std::array<int, D> half;
  for (int d = 0; d < D; ++d)
    half[d] = cell[d] >> 1;
  return half;
}

} // namespace

template <int D>
std::uint64_t Branches<D>::key(const Cell& cell) const
{
  std::uint64_t packed = 0;
  for (int k = 0; k < D; ++k) // the slowest axis of the lattice first
    packed = packed << bitsPerAxis | static_cast<std::uint64_t>(cell[grid_.axisOrder[k]]);
  return packed;
}

template <int D>
typename Branches<D>::Cell Branches<D>::cellOf(std::uint64_t packed) const
{
  Cell cell;
  for (int k = D - 1; k >= 0; --k)
  {
    cell[grid_.axisOrder[k]] = static_cast<int>(packed & ((std::uint64_t(1) << bitsPerAxis) - 1));
    packed >>= bitsPerAxis;
  }
  return cell;
}

template <int D>
bool Branches<D>::isInside(int level, const Cell& cell) const
{
  bool inside = true;
  for (int d = 0; d < D; ++d)
    inside = inside && cell[d] >= 0 && cell[d] < grid_.cells[d] << level;
  return inside;
}

template <int D>
bool Branches<D>::isRefined(int level, const Cell& cell) const
{
  return level < depth() && levels_[level].find(key(cell)) >= 0;
}

template <int D>
void Branches<D>::refine(int level, const Cell& cell)
{
  if (depth() <= level)
    levels_.resize(level + 1);
  Cell at = cell;
  for (int l = level; l >= 0; --l)
  {
    const int before = levels_[l].size();
    if (levels_[l].add(key(at)) < before)
      return;
    at = halved<D>(at);
  }
}

template <int D>
void Branches<D>::balance()
{
  for (int level = depth() - 1; level > 0; --level)
    for (const Cell& cell : cells(level))
    {
      Cell at;
      int around = 1;
      for (int d = 0; d < D; ++d)
        around *= 3;
      for (int k = 0; k < around; ++k)
      {
        int rest = k;
        for (int d = 0; d < D; ++d, rest /= 3)
          at[d] = cell[d] + rest % 3 - 1;
        if (isInside(level, at))
          refine(level - 1, halved<D>(at));
      }
    }
}

template <int D>
std::vector<typename Branches<D>::Cell> Branches<D>::cells(int level) const
{
  std::vector<std::uint64_t> keys = levels_[level].keys();
  std::sort(keys.begin(), keys.end());
  std::vector<Cell> all;
  all.reserve(keys.size());
  for (const std::uint64_t packed : keys)
    all.push_back(cellOf(packed));
  return all;
}

template <int D>
Branches<D> Branches<D>::within(const Grid<D>& window) const
{
  Branches part(window);
  part.levels_.resize(levels_.size());
  for (int level = 0; level < depth(); ++level)
    for (const std::uint64_t packed : levels_[level].keys())
    {
      Cell cell = cellOf(packed);
      for (int d = 0; d < D; ++d)
        cell[d] -= (window.before[d] - grid_.before[d]) << level;
      if (part.isInside(level, cell))
        part.levels_[level].add(part.key(cell));
    }
  return part;
}

template <int D>
bool Branches<D>::operator==(const Branches& other) const
{
  bool same = depth() == other.depth();
  for (int level = 0; same && level < depth(); ++level)
    same = levels_[level].sameKeys(other.levels_[level]);
  return same;
}

template <int D>
std::vector<LeafName<D>> leafNames(const Grid<D>& grid, const Tree<D>& tree)
{
  const auto level = onHost(tree.leafLevel);
  const auto corner = onHost(tree.leafCorner);
  std::vector<LeafName<D>> leaves;
  for (std::size_t l = 0; l < level.extent(0); ++l)
  {
    LeafName<D> leaf;
    leaf.level = level(l);
    for (int d = 0; d < D; ++d)
      leaf.cell[d] = static_cast<int>(std::lround(std::ldexp(grid.inCells(corner(l, d), d), leaf.level)));
    leaves.push_back(leaf);
  }
  return leaves;
}

template <int D>
Branches<D> branchesOf(const Grid<D>& grid, const std::vector<LeafName<D>>& leaves)
{
  Branches<D> branches(grid);
  for (const LeafName<D>& leaf : leaves)
    branches.refine(leaf.level - 1, halved<D>(leaf.cell));
  return branches;
}

template std::vector<LeafName<2>> leafNames(const Grid<2>&, const Tree<2>&);
template std::vector<LeafName<3>> leafNames(const Grid<3>&, const Tree<3>&);
template Branches<2> branchesOf(const Grid<2>&, const std::vector<LeafName<2>>&);
template Branches<3> branchesOf(const Grid<3>&, const std::vector<LeafName<3>>&);
template class Branches<2>;
template class Branches<3>;

} // namespace Rhegma
