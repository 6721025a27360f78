#pragma once
/// Values of front nodes without what differs from one node to the next.

#include "state/CrackSet.hpp"

#include <cstddef>
#include <vector>

namespace Rhegma::propagation
{

/// Values of the nodes of a front, smoothed along it over those that advance with a node: a hat two nodes
/// wide, twice.
template <int D>
std::vector<double> smoothedAlong(const CrackFront<D>& front, std::vector<double> value)
{
  const std::size_t count = front.nodes.size();
  for (int round = 0; round < 2 && count > 1; ++round)
  {
    std::vector<double> mean = value;
    for (std::size_t k = 0; k < count; ++k)
    {
      double sum = 2.0 * value[k], weight = 2.0;
      const std::size_t last = k > 0 ? k - 1 : count - 1, next = k + 1 < count ? k + 1 : 0;
      if (front.nodes[last].facet >= 0 && front.nodes[last].advances)
      {
        sum += value[last];
        weight += 1.0;
      }
      if (front.nodes[k].facet >= 0 && front.nodes[next].advances)
      {
        sum += value[next];
        weight += 1.0;
      }
      mean[k] = sum / weight;
    }
    value = mean;
  }
  return value;
}

} // namespace Rhegma::propagation
