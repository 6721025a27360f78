#include "state/NodeNames.hpp"

#include <cmath>

namespace Rhegma
{

template <int D>
NodeNames<D>::NodeNames(const State<D>& state) : NodeNames(state.mesh.grid, state.mesh.tree.finePlace)
{
}

template <int D>
NodeNames<D>::NodeNames(const Grid<D>& grid, const View<double* [D]>& finePlace) : grid_(grid)
{
  const auto place = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, finePlace);
  const double unit = std::ldexp(grid_.spacing, -deepestLevel);
  for (int k = 0; k < static_cast<int>(place.extent(0)); ++k)
  {
    Name name;
    for (int d = 0; d < D; ++d)
      name[d] = static_cast<int>(std::lround((place(k, d) - grid_.whole[d]) / unit));
    fine_.push_back(name);
    numbers_[name] = grid_.numNodes + k;
  }
}

template <int D>
typename NodeNames<D>::Name NodeNames<D>::of(int node) const
{
  if (node >= grid_.numNodes)
    return fine_[node - grid_.numNodes];
  int at[D];
  grid_.nodeCoordinates(node, at);
  Name name;
  for (int d = 0; d < D; ++d)
    name[d] = (grid_.before[d] + at[d]) << deepestLevel;
  return name;
}

template <int D>
void NodeNames<D>::append(int node, std::vector<int>& list) const
{
  const Name name = of(node);
  list.insert(list.end(), name.begin(), name.end());
}

template <int D>
int NodeNames<D>::find(const std::vector<int>& list, std::size_t begin) const
{
  Name name;
  int at[D];
  bool ofLattice = true;
  for (int d = 0; d < D; ++d)
  {
    name[d] = list[begin + d];
    const int whole = name[d] >> deepestLevel;
    ofLattice = ofLattice && whole << deepestLevel == name[d];
    at[d] = whole - grid_.before[d];
    if (at[d] < 0 || at[d] > grid_.cells[d])
      return -1;
  }
  if (ofLattice)
    return grid_.nodeIndex(at);
  const auto found = numbers_.find(name);
  return found == numbers_.end() ? -1 : found->second;
}

template class NodeNames<2>;
template class NodeNames<3>;

} // namespace Rhegma
