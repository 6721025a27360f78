#include "step/EquilibriumSteps.hpp"

#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "base/StopRequest.hpp"
#include "plan/LoadOverStep.hpp"
#include "state/EnergySums.hpp"
#include "state/Subdomain.hpp"
#include "step/RunStage.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <sstream>
#include <utility>

namespace Rhegma
{

namespace
{

/// Length of a step that adds no load, in fractions of the run.
constexpr double shortStep = 1e-9;

/// Equilibrium at the new positions of the particles moves them again, where they move through the cells, and
/// what the ghost penalty held in the last step is let go, so that equilibrium does not depend on the steps.
/// A dynamic run starts at rest: the solution is repeated until the forces that the last motion left out of
/// balance are this fraction of all, or until a repetition no longer reduces them by `leastGain`. Large
/// plastic strain needs a few of them.
constexpr double forcesAtRest = 1e-6, leastGain = 0.8;
constexpr int mostRounds = 12;

/// Forces out of balance, as a fraction of all, that are left after a load step: G is then within 0.1 % of
/// that in equilibrium (test_steps_within_a_run.py). They are no larger than the displacement of the step in
/// cells, by which the functions of the nodes change at the particles: 0.4 of it in an edge crack.
constexpr double enoughForG = 1e-3;

/// Energy of the ghost penalty, as a fraction of the work of the loads and the strain energy, that is no
/// longer a small correction.
constexpr double noticeablePenalty = 0.02;

/// Warns where nodes are held by the ghost penalty rather than by material. \param stabilised energy of the
/// penalty [J] \param largest of the strain energy and the work of the loads together, during the run [J]
template <int D>
void warnOfPenalty(double stabilised, double largest, State<D>& state)
{
  if (!(stabilised > noticeablePenalty * largest))
    return;
  state.warnings.push_back("Time > Analysis: the ghost penalty, which holds nodes with hardly any material "
                           "to their neighbours, took " +
                           formatShort(stabilised) + " J, " + formatShort(100.0 * stabilised / largest) +
                           " % of the largest strain energy and work of the loads: supports, loads or "
                           "thermal strain act on such nodes, and "
                           "displacements and energies are wrong; let boxes of supports reach half a cell "
                           "into the bodies, or use smaller "
                           "cells");
}

template <int D>
void runStages(Plan<D>& plan, State<D>& state, std::initializer_list<Stage> stages)
{
  for (const Stage stage : stages)
  {
    runStage(plan, state, stage);
    agree(state); // a stage that failed on one rank ends the run on all before the next one communicates
  }
}

/// The stage between steps, after which the nodes are those of the cells.
template <int D>
void runBetweenSteps(Plan<D>& plan, State<D>& state)
{
  runStage(plan, state, Stage::BetweenSteps);
  agree(state);
  moveNodalFields(state);
}

template <int D>
void stopIfFailed(const State<D>& state)
{
  if (!state.failure.empty())
    stopRun(state);
}

} // namespace

template <int D>
LoadSteps<D>::LoadSteps(const Teuchos::ParameterList& scene) : largest(largestLoadStep(scene)), next(largest)
{
}

template <int D>
void EquilibriumSteps<D>::start(const Teuchos::ParameterList& scene)
{
  steps_ = LoadSteps<D>(scene);
  const auto solver = scene.sublist("Time").get<std::string>("Linear Solver");
  last_->solverChoice = solver == "Direct"      ? equilibrium::SolverChoice::Direct
                        : solver == "Iterative" ? equilibrium::SolverChoice::Iterative
                                                : equilibrium::SolverChoice::Automatic;
}

template <int D>
void EquilibriumSteps<D>::inspect(const Teuchos::ParameterList& scene, Plan<D>& plan, State<D>& state)
{
  for (const std::string& name : sublistNames(scene.sublist("Bodies")))
    for (const char* const motion : {"Velocity", "Angular Velocity"})
      for (const double v : scene.sublist("Bodies").sublist(name).get<Teuchos::Array<double>>(motion))
        if (v != 0.0)
          throw std::invalid_argument("Bodies > " + name + " > " + motion +
                                      ": an equilibrium analysis has no initial velocity; write Time > "
                                      "Analysis = Dynamic or leave it out");
  state.clock.dt = steps_.next;
  plan.run(Stage::BetweenSteps, state);
  moveNodalFields(state);
  plan.run(Stage::Scatter, state);
  if (state.failure.empty())
    equilibrium::inspect(scene, state, *last_);
}

template <int D>
void EquilibriumSteps<D>::warnOfShortSteps(State<D>& state)
{
  constexpr double part = 1.0 / 64.0; // six halvings: a load step takes as long as all of a usual run
  if (warnedOfShortSteps_ || !(steps_.next <= part * steps_.largest))
    return;
  warnedOfShortSteps_ = true;
  state.warnings.push_back(
      "load steps have become as short as 1/" + formatReal(std::round(steps_.largest / steps_.next)) +
      " of Time > Final Time over Load Steps at t = " + readableTime(state.clock.time) +
      ", as longer ones have no equilibrium: at this length each load step takes that many solutions. A body "
      "that "
      "softens or comes to its limit load does so; see its fields here, or give more Load Steps");
}

template <int D>
void EquilibriumSteps<D>::solve(Plan<D>& plan, State<D>& state, double left)
{
  last_->bentMotion = 0.0;
  for (double dt = steps_.next;; dt = last_->shorter * std::min(dt, left))
  {
    state.clock.dt = dt >= left ? left : 2.0 * dt > left ? 0.5 * left : dt;
    runStages(plan, state, {Stage::Scatter, Stage::BeforeSolve, Stage::Solve});
    if (last_->converged)
    {
      const bool grows = last_->iterations <= LoadSteps<D>::easy && !(last_->bentMotion > 0.0);
      steps_.next = std::min(grows ? std::max(2.0 * dt, steps_.next) : dt, steps_.largest);
      warnOfShortSteps(state);
      return;
    }
    if (!last_->unsolvable.empty())
    {
      state.failure = "a linear system of " + std::to_string(last_->unknowns) +
                      " unknowns can't be solved: " + last_->unsolvable +
                      "; use larger cells away from the cracks, or a machine with more memory";
      stopRun(state);
    }
    if (dt <= LoadSteps<D>::smallest * steps_.largest)
    {
      std::ostringstream why;
      why << "no equilibrium is found for an increment of " << formatReal(LoadSteps<D>::smallest)
          << " of a load step: the residual stays at "
          << formatReal(last_->residuals.empty() ? 1.0 : last_->residuals.back())
          << " of the forces; the load may exceed what the bodies can bear, or the cells may be too coarse "
             "for the strain, or, where strains are below 1e-9, rounding hides a load that is too small: "
             "check its unit";
      if (!last_->reason.empty())
        why << "; " << last_->reason;
      state.failure = why.str();
      stopRun(state);
    }
  }
}

template <int D>
void EquilibriumSteps<D>::trySolve(Plan<D>& plan, State<D>& state, bool onlyLoads)
{
  const auto factor = state.clock.factor;
  struct Restore // also after an exception: nothing has moved
  {
    decltype(last_)& last;
    decltype(state.clock.factor)& current;
    decltype(state.clock.factor) before;
    ~Restore()
    {
      last->trial = last->onlyLoads = false;
      current = before;
    }
  } const restore{last_, state.clock.factor, factor};
  last_->trial = true;
  last_->onlyLoads = onlyLoads;
  state.clock.dt = std::min(steps_.next, state.clock.finalTime - state.clock.time);
  state.clock.factor = {factor.end, factor.end + 0.01};
  runBetweenSteps(plan, state);
  runStages(plan, state, {Stage::Scatter, Stage::BeforeSolve, Stage::Solve});
}

template <int D>
EquilibriumCalls EquilibriumSteps<D>::calls(Plan<D>& plan, State<D>& state)
{
  return {[&] { runBetweenSteps(plan, state); },
          [&] {
            runStages(plan, state, {Stage::Scatter, Stage::BeforeSolve, Stage::Solve});
          },
          [&] {
            runStages(plan, state,
                      {Stage::AfterSolve, Stage::Gather, Stage::AfterProjection, Stage::OnParticles});
          },
          [&] { return settleWhereNeeded(plan, state); }};
}

template <int D>
void EquilibriumSteps<D>::withoutNewLoads(State<D>& state, const std::function<void()>& solve)
{
  const double end = state.clock.time, dt = state.clock.dt;
  state.clock.dt = shortStep * state.clock.finalTime;
  state.clock.time = end - state.clock.dt;
  state.clock.factor.begin = state.clock.factor.end;
  last_->inPlace = true;
  solve();
  last_->inPlace = false;
  state.clock.time = end;
  state.clock.dt = dt;
}

template <int D>
bool EquilibriumSteps<D>::settleWhereNeeded(Plan<D>& plan, State<D>& state)
{
  if (last_->motion <= enoughForG)
    return false;
  const EquilibriumCalls stages = calls(plan, state);
  state.clock.factor.begin = state.clock.factor.end;
  const bool wasInPlace = std::exchange(last_->inPlace, true);
  last_->enough = enoughForG;
  stages.between();
  stages.solve();
  const bool moves = last_->converged && last_->iterations > 0;
  if (moves)
    stages.accept();
  else if (!last_->converged && !warnedOfSettling_)
  {
    warnedOfSettling_ = true;
    state.warnings.push_back(
        "Time > Analysis: at t = " + readableTime(state.clock.time) +
        " equilibrium could not be restored after a load step moved the particles, and " +
        formatShort(100.0 * (last_->residuals.empty() ? 1.0 : last_->residuals.front())) +
        " % of the forces do not balance; G and growth are those of this state: use more Time "
        "> Load Steps, or smaller cells");
  }
  last_->inPlace = wasInPlace;
  last_->enough = 0.0;
  return moves;
}

template <int D>
void EquilibriumSteps<D>::settleInPlace(const EquilibriumCalls& calls, State<D>& state)
{
  const int rounds = state.method.analysis == Analysis::Preload ? mostRounds : 1;
  double before = std::numeric_limits<double>::infinity();
  for (int k = 0; k < rounds; ++k)
  {
    withoutNewLoads(state,
                    [&]
                    {
                      calls.between();
                      calls.solve();
                      if (last_->converged)
                        calls.accept();
                    });
    if (!last_->converged)
    {
      state.warnings.push_back("Time > Analysis: equilibrium could not be restored after the last load step "
                               "moved the particles; stress and G are those before this motion");
      return;
    }
    const double outOfBalance = last_->residuals.front();
    if (outOfBalance <= forcesAtRest || outOfBalance > leastGain * before)
      return;
    before = outOfBalance;
  }
}

template <int D>
void EquilibriumSteps<D>::take(Plan<D>& plan, State<D>& state, double until)
{
  const double from = state.clock.time;
  const long step = state.clock.step;
  try
  {
    takeWhole(plan, state, until);
  }
  catch (const StopRequested&)
  {
    last_->inPlace = false;
    last_->enough = 0.0;
    state.clock.time = from;
    state.clock.step = step;
    state.failure = "within the load step from t = " + readableTime(from);
    sumEnergyBalance(state);
    throw StopRequested(state.failure);
  }
}

template <int D>
void EquilibriumSteps<D>::takeWhole(Plan<D>& plan, State<D>& state, double until)
{
  if (state.method.analysis == Analysis::QuasiStatic)
    if (const double end = endBeforeGrowth(state, until, steps_.largest);
        end < state.clock.time + steps_.next)
      until = end;
  const double left = until - state.clock.time;
  const double from = state.clock.time, driveBefore = state.cracks.growth.drive;
  const EquilibriumCalls stages = calls(plan, state);
  if (state.method.analysis == Analysis::LoadFactor)
  {
    const double whole = steps_.largest;
    followLoadFactor(state, stages, *last_, (1.0 + shortStep) * whole >= left ? left : whole);
    stopIfFailed(state);
  }
  else
  {
    stages.between();
    solve(plan, state, left);
    stages.accept();
  }
  state.clock.time = state.clock.dt == left ? until : state.clock.time + state.clock.dt;
  const bool ends = until == state.clock.finalTime && state.clock.time == until;
  if (state.method.analysis == Analysis::QuasiStatic)
    withoutNewLoads(state,
                    [&]
                    {
                      stages.settle();
                      growAtFixedLoads(state, stages, *last_, from, driveBefore);
                    });
  stopIfFailed(state);
  if (state.cracks.growth.unstable.found)
    return;
  ++state.clock.step;
  state.particles.particleSteps += allParticles(state);
  measureEnergy(state);
  const EnergyBalance energy = energyOfAllRanks(state);
  largestEnergy_ = std::max(largestEnergy_, energy.strain + std::fabs(energy.externalWork));
  if (ends)
  {
    settleInPlace(stages, state);
    warnOfPenalty(energyOfAllRanks(state).stabilised, largestEnergy_, state);
  }
  // Nodes are those of the particles as they lie now, at rest.
  runBetweenSteps(plan, state);
  runStages(plan, state, {Stage::Scatter});
}

template struct LoadSteps<2>;
template struct LoadSteps<3>;
template class EquilibriumSteps<2>;
template class EquilibriumSteps<3>;

} // namespace Rhegma
