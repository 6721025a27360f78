#include "grid/NodeIdentities.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma
{

template <int D>
NodeIdentities<D>::NodeIdentities(const Grid<D>& grid, const View<double* [D]>& finePosition) : grid_(grid)
{
  const auto fine = onHost(finePosition);
  const int count = static_cast<int>(fine.extent(0));
  const double unit = std::ldexp(grid_.spacing, -deepestLevel);
  fine_.resize(count);
  sorted_.resize(count);
  for (int k = 0; k < count; ++k)
  {
    for (int d = 0; d < D; ++d)
      fine_[k][d] = static_cast<int>(std::lround((fine(k, d) - grid_.whole[d]) / unit));
    sorted_[k] = {fine_[k], grid_.numNodes + k};
  }
  std::sort(sorted_.begin(), sorted_.end());
}

template <int D>
typename NodeIdentities<D>::Identity NodeIdentities<D>::of(int node) const
{
  if (node >= grid_.numNodes)
    return fine_[node - grid_.numNodes];
  int at[D];
  grid_.nodeCoordinates(node, at);
  Identity identity;
  for (int d = 0; d < D; ++d)
    identity[d] = (grid_.before[d] + at[d]) << deepestLevel;
  return identity;
}

template <int D>
int NodeIdentities<D>::find(const Identity& identity) const
{
  if (!isWithin(grid_, identity))
    return -1;
  if (isOfLattice(identity))
  {
    int at[D];
    for (int d = 0; d < D; ++d)
      at[d] = (identity[d] >> deepestLevel) - grid_.before[d];
    return grid_.nodeIndex(at);
  }
  const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), std::make_pair(identity, 0));
  return found != sorted_.end() && found->first == identity ? found->second : -1;
}

template <int D>
Vector<D> NodeIdentities<D>::position(const Identity& identity) const
{
  Vector<D> x;
  for (int d = 0; d < D; ++d)
    x[d] = grid_.whole[d] + std::ldexp(grid_.spacing, -deepestLevel) * identity[d];
  return x;
}

template <int D>
bool NodeIdentities<D>::isWithin(const Grid<D>& part, const Identity& identity)
{
  bool within = true;
  for (int d = 0; d < D; ++d)
  {
    const int at = (identity[d] >> deepestLevel) - part.before[d];
    within = within && at >= 0 && at <= part.cells[d];
  }
  return within;
}

template <int D>
bool NodeIdentities<D>::isOfLattice(const Identity& identity)
{
  return std::all_of(identity.begin(), identity.end(), [](int n) { return n % (1 << deepestLevel) == 0; });
}

template class NodeIdentities<2>;
template class NodeIdentities<3>;

} // namespace Rhegma
