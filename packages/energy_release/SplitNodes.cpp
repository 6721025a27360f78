#include "energy_release/SplitNodes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace Rhegma::energy_release
{

std::vector<int> ownNodesAround(const State<2>& state, const Vector<2>& centre, double radius)
{
  const Grid<2>& grid = state.mesh.grid;
  const auto foreign = onHost(state.mesh.nodes.foreign);
  int first[2], last[2];
  for (int d = 0; d < 2; ++d)
  {
    first[d] = std::max(0, static_cast<int>(std::floor(grid.inCells(centre[d] - radius, d))));
    last[d] = std::min(grid.cells[d], static_cast<int>(std::ceil(grid.inCells(centre[d] + radius, d))));
  }
  std::vector<int> nodes;
  for (int i = first[0]; i <= last[0]; ++i)
    for (int j = first[1]; j <= last[1]; ++j)
    {
      const int at[2] = {i, j}, n = grid.nodeIndex(at);
      if (foreign(n) == 0)
        nodes.push_back(n);
    }
  const auto positions = onHost(state.mesh.tree.finePosition);
  for (int k = 0; k < state.mesh.tree.numFine; ++k)
    if (foreign(grid.numNodes + k) == 0 && std::fabs(positions(k, 0) - centre[0]) <= radius &&
        std::fabs(positions(k, 1) - centre[1]) <= radius)
      nodes.push_back(grid.numNodes + k);
  return nodes;
}

SplitNodes::SplitNodes(const State<2>& state, const CrackFront<2>& front, double radius)
    : side_(onHost(state.cracks.nodeSide)),
      many_(static_cast<bool>(state.mesh.subdomain)),
      positions_(state),
      front_(front)
{
  if (!many_ || side_.extent(0) == 0)
    return;
  std::vector<double> nodes;
  for (const int n : ownNodesAround(state, front.position, radius))
    if (std::abs(side_(n)) == front.crack + 1)
      nodes.push_back(positions_(n));
  for (const double n : state.ranks.gatherOnAll(nodes))
    split_.insert(static_cast<int>(n));
}

bool SplitNodes::operator()(int node) const
{
  if (many_ && side_.extent(0) > 0)
    return split_.count(node) > 0;
  if (node < static_cast<int>(side_.extent(0)))
    return side_(node) == front_.crack + 1 || side_(node) == -front_.crack - 1;
  return dot(positions_.positionOf(node) - front_.position, front_.direction) < 0.0;
}

} // namespace Rhegma::energy_release
