#include "grid/LeafList.hpp"

#include <cmath>

namespace Rhegma
{

template <int D>
LeafList<D>::LeafList(const Branches<D>& branches) : branches_(branches)
{
  numberBranches();
  listLeaves();
}

/// The children of branches are branches, numbered level by level, or leaves.
template <int D>
void LeafList<D>::numberBranches()
{
  root.assign(grid().numNodes, -1);
  branchAt_.resize(depth() + 1);
  for (int l = 0; l < depth(); ++l)
  {
    firstBranch_.push_back(static_cast<int>(branchCell_.size()));
    for (const Cell& at : branches_.cells(l))
    {
      const int number = firstBranch_[l] + branchAt_[l].add(branches_.key(at));
      branchCell_.push_back(at);
      branchLevel_.push_back(l);
      if (l == 0)
        root[lowestNode(at)] = number;
    }
  }
  firstBranch_.push_back(static_cast<int>(branchCell_.size()));
}

template <int D>
void LeafList<D>::listLeaves()
{
  child.resize(branchCell_.size());
  leafAt_.resize(depth() + 1);
  firstLeaf_.assign(depth() + 1, 0); // children of one level of branches are leaves of one level
  for (std::size_t b = 0; b < child.size(); ++b)
    for (int k = 0; k < corners; ++k)
    {
      const int below = branchLevel_[b] + 1;
      if (leafAt_[below].size() == 0)
        firstLeaf_[below] = size();
      Cell part;
      for (int d = 0; d < D; ++d)
        part[d] = 2 * branchCell_[b][d] + ((k >> d) & 1);
      const std::uint64_t key = branches_.key(part);
      if (const int found = branchAt_[below].find(key); found >= 0)
      {
        child[b][k] = firstBranch_[below] + found;
        continue;
      }
      child[b][k] = -1 - size();
      leafAt_[below].add(key);
      cell.push_back(part);
      level.push_back(below);
    }
}

template <int D>
int LeafList<D>::leafAt(int ofLevel, const Cell& at) const
{
  if (ofLevel > depth() || !branches_.isInside(ofLevel, at))
    return -1;
  const int found = leafAt_[ofLevel].find(branches_.key(at));
  return found < 0 ? -1 : firstLeaf_[ofLevel] + found;
}

template <int D>
typename LeafList<D>::Cell LeafList<D>::corner(int leaf, int k) const
{
  Cell fine;
  for (int d = 0; d < D; ++d)
    fine[d] = (cell[leaf][d] + ((k >> d) & 1)) * edge(level[leaf]);
  return fine;
}

template <int D>
bool LeafList<D>::onLattice(const Cell& fine) const
{
  bool on = true;
  for (int d = 0; d < D; ++d)
    on = on && fine[d] % edge(0) == 0;
  return on;
}

template <int D>
int LeafList<D>::latticeNodeAt(const Cell& fine) const
{
  Cell at;
  for (int d = 0; d < D; ++d)
    at[d] = fine[d] / edge(0);
  return lowestNode(at);
}

template <int D>
int LeafList<D>::lowestNode(const Cell& lattice) const
{
  int at[D];
  for (int d = 0; d < D; ++d)
    at[d] = lattice[d];
  return grid().nodeIndex(at);
}

template <int D>
std::array<double, D> LeafList<D>::position(const Cell& fine) const
{
  std::array<double, D> x;
  for (int d = 0; d < D; ++d)
    x[d] = grid().whole[d] +
           (grid().before[d] + std::ldexp(static_cast<double>(fine[d]), -depth())) * grid().spacing;
  return x;
}

template class LeafList<2>;
template class LeafList<3>;

} // namespace Rhegma
