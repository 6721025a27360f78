/// What fronts have done: the part of CrackGrowth that reports and remembers.

#include "archive/Archive.hpp"
#include "cracks/CrackGrowth.hpp"

#include <algorithm>

namespace Rhegma::cracks
{

namespace
{

/// What helps a front that faces next to it have stopped.
constexpr const char* stopAdvice =
    "; cells can't resolve faces that are closer: use smaller cells (Domain > Cell Size)";

} // namespace

/// Keeps an event of a front, and reports the first of its kind.
template <int D>
void CrackGrowth<D>::report(State<D>& state, int front, Event event, FrontEvent<D> what)
{
  FrontEvent<D>& kept = event == Event::Stopped ? stops_[front] : arrivals_[front];
  const bool first = !kept.happened();
  if (!first && event == Event::Stopped)
    return;
  what.time = state.clock.time;
  kept = what;
  if (first)
    state.warnings.push_back(frontName(state.cracks, state.cracks.fronts[front]) + ": " + kept.asText() +
                             (event == Event::Stopped ? stopAdvice : ""));
}

template <int D>
const FrontEvent<D>* CrackGrowth<D>::stopOf(const CrackSet<D>& set, int front) const
{
  const CrackFront<D>& f = set.fronts[front];
  const bool runs = std::any_of(f.nodes.begin(), f.nodes.end(),
                                [](const FrontNode<D>& n) { return !n.stopped && n.speed > 0.0; });
  const std::size_t row = front;
  return row < stops_.size() && stops_[row].happened() && !f.ended && !runs ? &stops_[row] : nullptr;
}

template <int D>
std::vector<double> CrackGrowth<D>::toughnessAlong(const CrackSet<D>& set, int front) const
{
  const std::vector<FrontNode<D>>& nodes = set.fronts[front].nodes;
  const std::size_t f = front;
  const double last = f < lastToughness_.size() ? lastToughness_[f] : 0.0;
  std::vector<double> along(std::max<std::size_t>(1, nodes.size()), last);
  if (f >= marks_.size())
    return along;
  const std::vector<FrontMark>& marks = marks_[f];
  for (std::size_t k = 0; k < marks.size(); ++k)
  {
    double shortest = 1e300;
    for (std::size_t other = 0; other < marks.size(); ++other)
    {
      const double distance = norm(nodes[other].position - nodes[k].position);
      if (marks[other].toughness > 0.0 && (other == k || distance < shortest))
      {
        shortest = other == k ? -1.0 : distance;
        along[k] = marks[other].toughness;
      }
    }
  }
  return along;
}

template <int D>
void CrackGrowth<D>::serialize(const CrackSet<D>& set, Archive& archive)
{
  std::vector<int> landed;
  std::vector<double> toughness;
  for (const std::vector<FrontMark>& marks : marks_)
    for (const FrontMark& mark : marks)
    {
      landed.push_back(mark.landed ? 1 : 0);
      toughness.push_back(mark.toughness);
    }
  archive("landed", landed);
  archive("node_toughness", toughness);
  archive("last_toughness", lastToughness_);
  stops_.resize(set.fronts.size());
  arrivals_.resize(set.fronts.size());
  for (std::size_t f = 0; f < set.fronts.size(); ++f)
    for (auto* events : {&stops_, &arrivals_})
    {
      const Archive::Group group(archive, (events == &stops_ ? "stop " : "arrival ") + std::to_string(f));
      (*events)[f].serialize(archive);
    }
  if (!archive.loads())
    return;
  marks_.assign(set.fronts.size(), {});
  std::size_t row = 0;
  for (std::size_t f = 0; f < set.fronts.size(); ++f)
    for (std::size_t k = 0; k < set.fronts[f].nodes.size(); ++k)
      if (!set.fronts[f].ended && row < landed.size())
      {
        const FrontMark mark{toughness[row], landed[row] != 0};
        marks_[f].push_back(mark);
        ++row;
      }
}

template void CrackGrowth<2>::report(State<2>&, int, Event, FrontEvent<2>);
template void CrackGrowth<3>::report(State<3>&, int, Event, FrontEvent<3>);
template const FrontEvent<2>* CrackGrowth<2>::stopOf(const CrackSet<2>&, int) const;
template const FrontEvent<3>* CrackGrowth<3>::stopOf(const CrackSet<3>&, int) const;
template std::vector<double> CrackGrowth<2>::toughnessAlong(const CrackSet<2>&, int) const;
template std::vector<double> CrackGrowth<3>::toughnessAlong(const CrackSet<3>&, int) const;
template void CrackGrowth<2>::serialize(const CrackSet<2>&, Archive&);
template void CrackGrowth<3>::serialize(const CrackSet<3>&, Archive&);

} // namespace Rhegma::cracks
