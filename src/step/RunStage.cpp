#include "step/RunStage.hpp"

#include "base/Numbers.hpp"
#include "base/RunError.hpp"
#include "state/EnergySums.hpp"

#include <sstream>

namespace Rhegma
{

template <int D>
void stopRun(const State<D>& state)
{
  std::ostringstream reason;
  reason << "the run stopped at t = " << readableTime(state.clock.time) << ", step " << state.clock.step
         << ": " << state.failure;
  throw RunError(reason.str());
}

template <int D>
void runStage(Plan<D>& plan, State<D>& state, Stage stage)
{
  plan.run(stage, state);
  if (!state.failure.empty() && !state.ranks.many())
    stopRun(state);
}

template <int D>
void agree(State<D>& state)
{
  if (!state.ranks.many())
    return;
  double most[] = {state.clock.fastestSpeed, state.particles.sorted ? 0.0 : 1.0,
                   state.failure.empty() ? 0.0 : 1.0};
  state.ranks.max(most, 3);
  state.clock.fastestSpeed = most[0];
  state.particles.sorted = most[1] == 0.0;
  if (most[2] == 0.0)
    return;
  state.failure = state.ranks.firstText(state.failure);
  sumEnergyBalance(state);
  stopRun(state);
}

template void stopRun(const State<2>&);
template void stopRun(const State<3>&);
template void agree(State<2>&);
template void agree(State<3>&);
template void runStage(Plan<2>&, State<2>&, Stage);
template void runStage(Plan<3>&, State<3>&, Stage);

} // namespace Rhegma
