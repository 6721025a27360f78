#include "energy_release/FrontRegion.hpp"

#include <algorithm>

namespace Rhegma::energy_release
{

Region<3> regionAround(const FrontLine& line, double room)
{
  Region<3> box{line.nodes[0].position, line.nodes[0].position};
  for (const FrontNode<3>& s : line.nodes)
    for (int d = 0; d < 3; ++d)
    {
      box.lower[d] = std::min(box.lower[d], s.position[d]);
      box.upper[d] = std::max(box.upper[d], s.position[d]);
    }
  for (int d = 0; d < 3; ++d)
  {
    box.lower[d] -= room;
    box.upper[d] += room;
  }
  return box;
}

template <int D>
double reachOfStencils(const State<D>& state)
{
  // Ghosts of a crack, and boxes of coarse cells in fine ones, reach further than the nodes of equal cells.
  constexpr double equal = 2.0, other = 4.0;
  return state.cracks.dualField && !state.mesh.tree.refined() ? equal : other;
}

template <int D>
Region<D> nodesOf(const State<D>& state, const Region<D>& box)
{
  return box.widened(reachOfStencils(state) * state.mesh.grid.spacing);
}

template double reachOfStencils(const State<2>&);
template double reachOfStencils(const State<3>&);
template Region<2> nodesOf(const State<2>&, const Region<2>&);
template Region<3> nodesOf(const State<3>&, const Region<3>&);

} // namespace Rhegma::energy_release
