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
    for (const Cell& at : branches_.cells(l))
    {
      const int number = static_cast<int>(branchCell_.size());
      branchAt_[l][branches_.key(at)] = number;
      branchCell_.push_back(at);
      branchLevel_.push_back(l);
      if (l == 0)
        root[lowestNode(at)] = number;
    }
}

template <int D>
void LeafList<D>::listLeaves()
{
  child.resize(branchCell_.size());
  leafAt_.resize(depth() + 1);
  for (std::size_t b = 0; b < child.size(); ++b)
    for (int k = 0; k < corners; ++k)
    {
      const int below = branchLevel_[b] + 1;
      Cell part;
      for (int d = 0; d < D; ++d)
        part[d] = 2 * branchCell_[b][d] + ((k >> d) & 1);
      const auto found = branchAt_[below].find(branches_.key(part));
      if (found != branchAt_[below].end())
      {
        child[b][k] = found->second;
        continue;
      }
      child[b][k] = -1 - size();
      leafAt_[below][branches_.key(part)] = size();
      cell.push_back(part);
      level.push_back(below);
    }
}

template <int D>
int LeafList<D>::leafAt(int ofLevel, const Cell& at) const
{
  if (ofLevel > depth() || !branches_.isInside(ofLevel, at))
    return -1;
  const auto found = leafAt_[ofLevel].find(branches_.key(at));
  return found == leafAt_[ofLevel].end() ? -1 : found->second;
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
