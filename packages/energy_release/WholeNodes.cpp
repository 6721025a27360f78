#include "energy_release/WholeNodes.hpp"

#include "grid/FineNodes.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::energy_release
{

WholeNodes::WholeNodes(const State<2>& state) : here_(state.mesh.grid), whole_(wholeLattice(state))
{
  const auto positions = onHost(state.mesh.tree.finePosition);
  const int count = state.mesh.tree.numFine;
  if (!state.mesh.subdomain)
  {
    for (int k = 0; k < count; ++k)
    {
      finePosition_.push_back({{positions(k, 0), positions(k, 1)}});
      fine_.push_back(here_.numNodes + k);
    }
    return;
  }
  if (!state.mesh.tree.refined())
    return;
  const LeafList<2> leaves(state.mesh.subdomain->refined);
  const std::vector<std::array<int, 2>> all = FineNodes<2>(leaves).positions();
  for (const std::array<int, 2>& at : all)
    finePosition_.push_back({{leaves.position(at)[0], leaves.position(at)[1]}});
  const double unit = std::ldexp(whole_.spacing, -leaves.depth());
  for (int k = 0; k < count; ++k)
  {
    std::array<int, 2> at;
    for (int d = 0; d < 2; ++d)
      at[d] = static_cast<int>(std::lround((positions(k, d) - whole_.whole[d]) / unit));
    const auto found = std::lower_bound(all.begin(), all.end(), at);
    // At the boundary of the lattice of a rank there may be a hanging node.
    const bool exists = found != all.end() && *found == at;
    fine_.push_back(exists ? whole_.numNodes + static_cast<int>(found - all.begin()) : -1);
  }
}

int WholeNodes::operator()(int node) const
{
  if (node >= here_.numNodes)
    return fine_[node - here_.numNodes];
  int at[2];
  here_.nodeCoordinates(node, at);
  for (int d = 0; d < 2; ++d)
    at[d] += here_.before[d] - whole_.before[d];
  return whole_.nodeIndex(at);
}

Vector<2> WholeNodes::positionOf(int number) const
{
  return number < whole_.numNodes ? whole_.nodePosition(number) : finePosition_[number - whole_.numNodes];
}

} // namespace Rhegma::energy_release
