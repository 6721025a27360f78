#pragma once
/// How far nodes of a front are from where it ends.

#include "state/CrackSet.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace Rhegma
{

/// Distance of each node of a front from the nearest end of its line, along the front; infinite in 2D and on
/// closed lines [m].
/// \param front of a crack \param counts whether the end at a node counts
template <int D, class Counts>
std::vector<double> distancesFromEnds(const CrackFront<D>& front, const Counts& counts)
{
  const std::size_t count = front.nodes.size();
  std::vector<double> from(count, std::numeric_limits<double>::infinity());
  if (D == 2)
    return from;
  const auto joined = [&](std::size_t k) { return front.nodes[k].facet >= 0; };
  const auto next = [&](std::size_t k) { return k + 1 < count ? k + 1 : 0; };
  for (std::size_t k = 0; k < count; ++k)
    if (joined(k > 0 ? k - 1 : count - 1) != joined(k) && counts(front.nodes[k]))
      from[k] = 0.0;
  const auto piece = [&](std::size_t k)
  { return norm(front.nodes[next(k)].position - front.nodes[k].position); };
  for (std::size_t k = 0; k < count; ++k)
    if (joined(k))
      from[next(k)] = std::min(from[next(k)], from[k] + piece(k));
  for (std::size_t k = count; k-- > 0;)
    if (joined(k))
      from[k] = std::min(from[k], from[next(k)] + piece(k));
  return from;
}

} // namespace Rhegma
