/// What fronts have done: the part of CrackGrowth that reports and remembers.

#include "archive/Archive.hpp"
#include "cracks/CrackGrowth.hpp"

#include <algorithm>

namespace Rhegma::cracks
{

/// Keeps what a front reached, and reports the first.
template <int D>
void CrackGrowth<D>::recordArrival(State<D>& state, int front, const std::string& what,
                                   const Vector<D>& position)
{
  CrackFront<D>& own = state.cracks.fronts[front];
  const bool first = !own.arrival.happened();
  own.arrival = {what, state.clock.time, position};
  if (first)
    state.warnings.push_back(frontName(state.cracks, own) + ": " + own.arrival.asText());
}

template <int D>
std::vector<double> CrackGrowth<D>::toughnessAlong(const CrackSet<D>& set, int front) const
{
  const std::vector<FrontNode<D>>& nodes = set.fronts[front].nodes;
  const std::size_t f = front;
  const double last = f < lastToughness_.size() ? lastToughness_[f] : 0.0;
  std::vector<double> along(std::max<std::size_t>(1, nodes.size()), last);
  if (f >= toughness_.size())
    return along;
  const std::vector<double>& made = toughness_[f];
  for (std::size_t k = 0; k < made.size(); ++k)
  {
    double shortest = 1e300;
    for (std::size_t other = 0; other < made.size(); ++other)
    {
      const double distance = norm(nodes[other].position - nodes[k].position);
      if (made[other] > 0.0 && (other == k || distance < shortest))
      {
        shortest = other == k ? -1.0 : distance;
        along[k] = made[other];
      }
    }
  }
  return along;
}

template <int D>
void CrackGrowth<D>::serialize(const CrackSet<D>& set, Archive& archive)
{
  std::vector<double> all;
  for (const std::vector<double>& made : toughness_)
    all.insert(all.end(), made.begin(), made.end());
  archive("node_toughness", all);
  archive("last_toughness", lastToughness_);
  if (!archive.loads())
    return;
  toughness_.assign(set.fronts.size(), {});
  std::size_t row = 0;
  for (std::size_t f = 0; f < set.fronts.size(); ++f)
    for (std::size_t k = 0; k < set.fronts[f].nodes.size(); ++k)
      if (!set.fronts[f].ended && row < all.size())
        toughness_[f].push_back(all[row++]);
}

template void CrackGrowth<2>::recordArrival(State<2>&, int, const std::string&, const Vector<2>&);
template void CrackGrowth<3>::recordArrival(State<3>&, int, const std::string&, const Vector<3>&);
template std::vector<double> CrackGrowth<2>::toughnessAlong(const CrackSet<2>&, int) const;
template std::vector<double> CrackGrowth<3>::toughnessAlong(const CrackSet<3>&, int) const;
template void CrackGrowth<2>::serialize(const CrackSet<2>&, Archive&);
template void CrackGrowth<3>::serialize(const CrackSet<3>&, Archive&);

} // namespace Rhegma::cracks
