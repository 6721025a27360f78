#include "plausibility/Judges.hpp"

#include "base/Counted.hpp"
#include "base/NonNumbers.hpp"

#include <algorithm>

namespace Rhegma
{

namespace
{

/// Whether a message prints a number that is none.
bool printsNonNumber(const std::string& message) { return findNonNumber(message) != std::string::npos; }

/// The path with which a message starts.
std::string placeOf(const std::string& message)
{
  return message.substr(0, std::min(message.find(':'), message.find(" is ")));
}

void addFirstTen(const Messages& found, Messages& all)
{
  for (const std::string& message : firstTen(found))
    all.push_back(message);
}

} // namespace

Messages firstTen(Messages messages)
{
  constexpr std::size_t most = 10;
  if (messages.size() <= most)
    return messages;
  const std::size_t more = messages.size() - most;
  const std::string kind = messages[most].substr(0, messages[most].find(" > "));
  messages.resize(most);
  messages.push_back(kind + ": " + counted(static_cast<long>(more), "more warning") + " like the last");
  return messages;
}

Messages withoutNonNumbers(const Messages& messages)
{
  Messages kept;
  std::copy_if(messages.begin(), messages.end(), std::back_inserter(kept),
               [](const std::string& message) { return !printsNonNumber(message); });
  for (const std::string& message : messages)
  {
    const std::string place = placeOf(message);
    if (printsNonNumber(message) &&
        std::none_of(kept.begin(), kept.end(),
                     [&](const std::string& other) { return placeOf(other) == place; }))
      kept.push_back(place + ": its numbers are implausible, because results computed from them are not "
                             "finite; check exponents and units (SI)");
  }
  return kept;
}

template <int D>
void judgeScene(const Teuchos::ParameterList& scene, double step, bool driven,
                const std::map<std::string, std::string>& pressures, State<D>& state)
{
  JudgedScene<D> judged{scene, state, measureBodies(state), {}, step, driven};
  if (state.method.mechanics)
  {
    judged.loads = estimateLoads(scene, state, judged.bodies);
    const double end = scene.sublist("Time").get<double>("Final Time");
    const std::vector<LoadEstimate> inCracks = estimatePressures(pressures, end, judged.bodies);
    judged.loads.insert(judged.loads.end(), inCracks.begin(), inCracks.end());
  }
  judgeWithoutParticles(scene, state);
  Messages all;
  for (const auto judge : {judgeQuantities<D>, judgeTimes<D>, judgeNeighbours<D>, judgeMeetings<D>,
                           judgePieces<D>, judgeLoads<D>, judgeCancelling<D>, judgeMotion<D>, judgeMirrors<D>,
                           judgeHeld<D>, judgeGrips<D>, judgeShutCracks<D>, judgeFirstSteps<D>,
                           judgeFlight<D>, judgeSevered<D>, judgeCarried<D>, judgePic<D>, judgeBores<D>})
    addFirstTen(judge(judged), all);
  state.warnings.insert(state.warnings.end(), all.begin(), all.end());
  state.warnings = withoutNonNumbers(state.warnings);
}

template <int D>
void judgeWithoutParticles(const Teuchos::ParameterList& scene, State<D>& state)
{
  addFirstTen(judgeNumbers(scene), state.warnings);
  addFirstTen(judgeFiles<D>(scene), state.warnings);
  addFirstTen(judgeThickness(scene, state), state.warnings);
}

template void judgeScene(const Teuchos::ParameterList&, double, bool,
                         const std::map<std::string, std::string>&, State<2>&);
template void judgeScene(const Teuchos::ParameterList&, double, bool,
                         const std::map<std::string, std::string>&, State<3>&);
template void judgeWithoutParticles(const Teuchos::ParameterList&, State<2>&);
template void judgeWithoutParticles(const Teuchos::ParameterList&, State<3>&);

} // namespace Rhegma
