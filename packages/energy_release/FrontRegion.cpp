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

} // namespace Rhegma::energy_release
