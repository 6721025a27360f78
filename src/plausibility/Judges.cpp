#include "plausibility/Judges.hpp"

namespace Rhegma
{

Messages firstTen(Messages messages)
{
  constexpr std::size_t most = 10;
  if (messages.size() <= most)
    return messages;
  const std::size_t more = messages.size() - most;
  const std::string kind = messages[most].substr(0, messages[most].find(" > "));
  messages.resize(most);
  messages.push_back(kind + ": " + std::to_string(more) + " more warnings like the last");
  return messages;
}

template <int D>
void judgeScene(const Teuchos::ParameterList& scene, double step, State<D>& state)
{
  JudgedScene<D> judged{scene, state, measureBodies(state), {}, step};
  if (state.method.mechanics)
    judged.loads = estimateLoads(scene, state, judged.bodies);
  Messages all;
  for (const auto judge :
       {judgeNumbers<D>, judgeTimes<D>, judgeThickness<D>, judgeNeighbours<D>, judgeLoads<D>})
    for (const std::string& message : firstTen(judge(judged)))
      all.push_back(message);
  state.warnings.insert(state.warnings.end(), all.begin(), all.end());
}

template void judgeScene(const Teuchos::ParameterList&, double, State<2>&);
template void judgeScene(const Teuchos::ParameterList&, double, State<3>&);

} // namespace Rhegma
