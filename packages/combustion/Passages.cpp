#include "combustion/Passages.hpp"

#include "combustion/GasExchange.hpp"

#include <algorithm>

namespace Rhegma::combustion
{

namespace
{

template <int D>
Burning<D>* gasOf(BurnState<D>& burn, int crack)
{
  const auto found = std::find_if(burn.cracks.begin(), burn.cracks.end(),
                                  [&](const Burning<D>& b) { return b.crack == crack; });
  return found == burn.cracks.end() ? nullptr : &*found;
}

/// Why no gas passes between two cracks; empty where it does.
template <int D>
std::string whyApart(const Burning<D>* one, const Burning<D>* two)
{
  if (one == nullptr || two == nullptr)
    return "one of them has no gas (Combustion)";
  if (one->flows || two->flows)
    return "gas passes from one crack to another only with Gas Model = Uniform";
  if (!mixes(one->gas.law(), two->gas.law()))
    return "their gases differ (Gas Constant, Heat Capacity Ratio or Covolume)";
  return "";
}

template <int D>
void report(State<D>& state, BurnState<D>& burn, Meeting& meeting)
{
  const Burning<D>*one = gasOf(burn, meeting.crack), *two = gasOf(burn, meeting.other);
  const std::string why = whyApart(one, two);
  if (meeting.reported || (one == nullptr && two == nullptr) || why.empty())
    return;
  meeting.reported = true;
  state.warnings.push_back("Combustion: the crack " + state.cracks.cracks[meeting.crack].name + " has met " +
                           state.cracks.cracks[meeting.other].name +
                           ", but no gas flows from one to the other or out of their junction: " + why);
}

} // namespace

template <int D>
void updateMeetings(State<D>& state, BurnState<D>& burn)
{
  const std::vector<CrackFront<D>>& fronts = state.cracks.fronts;
  const auto ended = static_cast<int>(
      std::count_if(fronts.begin(), fronts.end(), [](const CrackFront<D>& front) { return front.ended; }));
  if (ended == burn.endedFronts)
    return;
  burn.endedFronts = ended;
  for (const Meeting& found : findMeetings(state.cracks, state.mesh.smallestSpacing()))
    if (std::none_of(burn.meetings.begin(), burn.meetings.end(),
                     [&](const Meeting& known)
                     { return known.crack == found.crack && known.end == found.end; }))
      burn.meetings.push_back(found);
  for (Meeting& meeting : burn.meetings)
    report(state, burn, meeting);
}

template <int D>
void letGasesPass(const State<D>& state, BurnState<D>& burn)
{
  for (const Meeting& meeting : burn.meetings)
  {
    Burning<D>*one = gasOf(burn, meeting.crack), *two = gasOf(burn, meeting.other);
    if (!whyApart(one, two).empty())
      continue;
    double area = joinedAreas(state, meeting.crack)[meeting.end];
    if (meeting.otherEnd >= 0)
      area = std::min(area, joinedAreas(state, meeting.other)[meeting.otherEnd]);
    const bool out = one->gas.pressure(one->volume) > two->gas.pressure(two->volume);
    exchange(one->gas, one->volume, two->gas, two->volume, area * (out ? one : two)->passageCoefficient,
             state.clock.dt);
  }
}

template void updateMeetings(State<2>&, BurnState<2>&);
template void updateMeetings(State<3>&, BurnState<3>&);
template void letGasesPass(const State<2>&, BurnState<2>&);
template void letGasesPass(const State<3>&, BurnState<3>&);

} // namespace Rhegma::combustion
