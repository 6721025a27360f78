#include "step/FollowPath.hpp"

#include "base/Numbers.hpp"
#include "base/RunError.hpp"
#include "base/ShortNumber.hpp"
#include "base/StopRequest.hpp"
#include "state/Nonlinearity.hpp"
#include "state/Subdomain.hpp"
#include "step/LoadFactorSearch.hpp"
#include "step/RunStage.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace Rhegma
{

namespace
{

/// The factor of the first equilibrium of a run, small enough that a body hardly deforms; and by how much
/// more it is tried where unit loads strain a body by rounding only.
constexpr double firstFactor = 0.01, moreOfUnitLoads = 100.0;
constexpr int mostRaises = 4;

/// Equilibria of a step after which no factor is found.
constexpr int mostTrials = 60;

/// Trials one after another that gain less than this fraction of the change of the factor that is wanted,
/// because there is no equilibrium at more of it, after which no factor is found. A body that bears its load
/// only in increments gains more.
constexpr int mostReduced = 4;
constexpr double leastGained = 0.1;

/// How often a change of the factor is halved where there is no equilibrium.
constexpr int mostHalvings = 12;

/// G/Gc from which on cracks grow under given loads: G is no more accurate.
constexpr double heldDrive = 1.0 + 1e-6;

/// G/Gc to which a load step is made to lead: enough for growth, and what is released above the toughness is
/// no more than what an increment of a quarter of a cell changes. Steps for that are no shorter than this
/// part of the largest.
constexpr double aimedDrive = 1.01, shortestStep = 1.0 / 64.0;

/// Relative difference of times that is rounding: load steps add up to them.
constexpr double roundingOfTime = 1e-9;

/// By how much G/Gc must rise while cracks grow under given loads to be unstable: more than it jumps between
/// cells, half a percent.
constexpr double unstableRise = 0.01;

/// Strain above which no factor is searched for, by a linear estimate (meanStrain): rubber tears at strains
/// of a few.
constexpr double largestStrain = 10.0;

/// Fraction of the work of a step below which the work of loads is rounding.
constexpr double roundingOfWork = 1e-9;

template <int D>
bool canAdvance(const State<D>& state)
{
  const auto& fronts = state.cracks.fronts;
  return std::any_of(fronts.begin(), fronts.end(),
                     [](const CrackFront<D>& front) { return !front.ended && !front.stopped(); });
}

/// The factor after the next increment, on a straight line through the last two.
double extrapolated(const std::vector<PathState>& path)
{
  if (path.empty())
    return firstFactor;
  const double last = path.back().factor;
  return path.size() < 2 ? last : std::max(0.5 * last, 2.0 * last - path[path.size() - 2].factor);
}

/// Solves for a factor, or for one nearer to the last where that fails. \return whether there is an
/// equilibrium
template <int D>
bool solveFor(State<D>& state, const EquilibriumCalls& calls, const equilibrium::LastStep& last,
              double factor)
{
  Clock& clock = state.clock;
  clock.factor = {clock.factor.end, factor};
  calls.solve();
  for (int k = 0; k < mostRaises && !last.converged && clock.factor.begin == 0.0; ++k)
  {
    clock.factor.end *= moreOfUnitLoads;
    calls.solve();
  }
  if (!last.converged)
    clock.factor.end = factor;
  for (int k = 0; k < mostHalvings && !last.converged; ++k)
  {
    clock.factor.end = 0.5 * (clock.factor.begin + clock.factor.end);
    calls.solve();
  }
  return last.converged;
}

/// When G/Gc is 1 between two times, for loads that are linear in time; the first one where it is above 1
/// already [s].
double timeOfToughness(double from, double driveFrom, double to, double driveTo)
{
  const double begin = std::sqrt(std::max(driveFrom, 0.0)), end = std::sqrt(std::max(driveTo, 0.0));
  if (begin > 1.0)
    return from;
  return end > begin ? from + std::clamp((1.0 - begin) / (end - begin), 0.0, 1.0) * (to - from) : to;
}

/// How far the search for a factor has come.
template <int D>
std::string progressOfSearch(const State<D>& state)
{
  return "no load factor is found at which a crack grows: with the loads of Time > Final Time times " +
         formatShort(state.clock.factor.end) + ", G is " + formatShort(state.cracks.growth.drive) +
         " of the toughness";
}

/// Why no factor is found.
template <int D>
std::string failureOfSearch(const State<D>& state, bool solved)
{
  const std::string at = "the loads of Time > Final Time times " + formatShort(state.clock.factor.end);
  if (!solved)
    return "no equilibrium is found near " + at + ", where G is " + formatShort(state.cracks.growth.drive) +
           " of the toughness; the loads may exceed what the bodies can bear, or a crack may have cut off a "
           "part";
  return progressOfSearch(state) + "; the loads must open a crack (Propagation > Load Control)";
}

/// Why no factor is searched for: the strain of a linear body at the factor at which G of the first
/// equilibrium would be the toughness is beyond sense; empty if it is not. \param needed this factor
template <int D>
std::string failureOfStrain(const State<D>& state, double needed)
{
  const double factor = state.clock.factor.end, strain = meanStrain(state) * needed / factor;
  if (!(std::isfinite(needed) && strain > largestStrain))
    return {};
  return "no load factor is searched for: at " + formatShort(factor) +
         " times the loads of Time > Final Time G is " + formatShort(state.cracks.growth.drive) +
         " of the toughness, so that a crack would grow at about " + formatShort(needed) +
         " times these loads, which would strain the bodies by about " + formatShort(100.0 * strain) +
         " %; check the unit of Propagation > Toughness (J/m2) and the stiffness of Materials";
}

/// Warns where the first equilibrium is beyond the start of growth: bodies go back from it as their laws do,
/// and laws that are linear in increments do not come back to where they were.
template <int D>
void warnOfFirstFactor(State<D>& state)
{
  const double drive = state.cracks.growth.drive;
  if (drive > 1.0)
    state.warnings.push_back("Propagation > Load Control: with " + formatShort(state.clock.factor.end) +
                             " times the loads of Time > Final Time, the first factor that is tried, G is " +
                             formatShort(drive) +
                             " times the toughness, so that the bodies have been strained more than at the "
                             "start of growth, and the "
                             "factor can be off by percents; write loads that are " +
                             formatShort(std::ceil(std::sqrt(drive))) + " times smaller or less");
}

/// Work of the loads of a step over the mean of their factor. \param last of its solves \param before
/// external work at its start [J]
template <int D>
double displacementOfLoads(const State<D>& state, const equilibrium::LastStep& last, double before)
{
  const double all = state.energy.externalWork - before;
  double work[] = {all - last.workOfSupports, std::fabs(all)};
  sumParts(state, work, 2);
  // Where supports do all the work, what is left is rounding.
  return std::fabs(work[0]) > roundingOfWork * work[1]
             ? 2.0 * work[0] / (state.clock.factor.begin + state.clock.factor.end)
             : 0.0;
}

/// Advances the cracks by an increment under given loads, where motion follows unstable growth. \param least
/// G/Gc under these loads so far \return
/// whether growth is stable so far: there is an equilibrium, in which G has not risen
template <int D>
bool growsStably(State<D>& state, const EquilibriumCalls& calls, const equilibrium::LastStep& last,
                 double& least)
{
  UnstableGrowth& unstable = state.cracks.growth.unstable;
  unstable.found = true;
  state.cracks.growth.advance = true;
  try
  {
    calls.between();
    calls.solve();
    if (!last.converged)
      return false;
    calls.accept();
  }
  catch (const StopRequested&)
  {
    throw;
  }
  catch (const RunError&) // a crack has parted the body: nothing of this step is kept
  {
    state.failure.clear();
    return false;
  }
  // A load step may go past the toughness: growth first takes that off, and may then be unstable.
  unstable.rise = state.cracks.growth.drive / least - 1.0;
  least = std::min(least, state.cracks.growth.drive);
  unstable.found = unstable.rise > unstableRise;
  return !unstable.found;
}

/// Moves the particles into the equilibrium that was found. \param explain why the run ends, where they can't
template <int D, class Explain>
void accept(State<D>& state, const EquilibriumCalls& calls, const Explain& explain)
{
  try
  {
    calls.accept();
  }
  catch (const StopRequested&)
  {
    throw;
  }
  catch (const RunError&)
  {
    state.failure = explain();
    stopRun(state);
  }
}

} // namespace

template <int D>
void followLoadFactor(State<D>& state, const EquilibriumCalls& calls, const equilibrium::LastStep& last,
                      double length)
{
  EquilibriumGrowth& growth = state.cracks.growth;
  Clock& clock = state.clock;
  PathState now = growth.path.empty() ? PathState() : growth.path.back();
  growth.advance = !growth.path.empty();
  calls.between();
  clock.dt = length;
  if (!canAdvance(state))
    return;
  LoadFactorSearch search;
  double factor = extrapolated(growth.path);
  bool solved = true;
  int reduced = 0; // trials one after another with hardly a change of the factor
  for (int k = 0; k < mostTrials && reduced < mostReduced && state.failure.empty() && !search.found(); ++k)
  {
    const double before = state.energy.externalWork;
    solved = solveFor(state, calls, last, factor);
    if (!solved)
      break;
    const double gained = clock.factor.end - clock.factor.begin;
    // A search that starts far below what it looks for asks for many times the factor that it has.
    const double wanted = std::fabs(factor - clock.factor.begin), has = std::fabs(clock.factor.begin);
    const bool stuck = std::fabs(gained) < leastGained * (has > 0.0 ? std::min(wanted, has) : wanted);
    reduced = stuck ? reduced + 1 : 0;
    accept(state, calls, [&] { return progressOfSearch(state) + ", and " + state.failure; });
    now.displacement += displacementOfLoads(state, last, before);
    search.record(clock.factor.end, growth.drive);
    const double atLoad = state.energy.externalWork;
    if (search.found() && state.failure.empty() && calls.settle())
    {
      now.displacement += displacementOfLoads(state, last, atLoad);
      search.record(clock.factor.end, growth.drive);
    }
    if (k == 0 && growth.path.empty() && state.failure.empty())
    {
      state.failure = failureOfStrain(state, search.proportional());
      warnOfFirstFactor(state);
    }
    factor = search.next();
    calls.between();
  }
  if (state.failure.empty() && !search.found())
    state.failure = failureOfSearch(state, solved && reduced < mostReduced);
  now.time = clock.time + length;
  now.factor = clock.factor.end;
  now.area = growth.area;
  if (state.failure.empty())
    growth.path.push_back(now);
}

template <int D>
double endBeforeGrowth(const State<D>& state, double until, double largest)
{
  const EquilibriumGrowth& growth = state.cracks.growth;
  const double now = state.clock.time, root = std::sqrt(std::max(growth.drive, 0.0));
  if (!(growth.rate > 0.0) || growth.held || !canAdvance(state) || until < growth.startTime)
    return until;
  const double shortest = shortestStep * largest;
  const double reached =
      std::max({now + (std::sqrt(aimedDrive) - root) / growth.rate, now + shortest, growth.startTime});
  return reached < until - shortest ? reached : until;
}

template <int D>
void growAtFixedLoads(State<D>& state, const EquilibriumCalls& calls, const equilibrium::LastStep& last,
                      double from, double driveBefore)
{
  EquilibriumGrowth& growth = state.cracks.growth;
  const double now = state.clock.time + state.clock.dt; // the end of the load step
  growth.unstable = {false, growth.drive, 0.0};
  growth.rate =
      (std::sqrt(std::max(growth.drive, 0.0)) - std::sqrt(std::max(driveBefore, 0.0))) / (now - from);
  if (growth.held || now < growth.startTime * (1.0 - roundingOfTime))
    return;
  const double reached = std::max(timeOfToughness(from, driveBefore, now, growth.drive), growth.startTime);
  const double areaBefore = growth.area;
  double least = growth.drive;
  while (state.failure.empty() && canAdvance(state) && growth.drive > heldDrive)
  {
    const double before = growth.release;
    const auto record = [&] {
      growth.path.push_back({now, 0.0, 0.0, growth.area, growth.release / before - 1.0, from, reached});
    };
    if (state.method.handsOver)
    {
      if (!growsStably(state, calls, last, least))
        return;
      record();
      continue;
    }
    growth.advance = true;
    calls.between();
    calls.solve();
    if (!last.converged)
    {
      state.failure =
          "no equilibrium is found after the crack has grown under the loads of t = " + readableTime(now) +
          ": they may exceed what the remaining ligament can bear";
      return;
    }
    accept(state, calls,
           [&]
           {
             return "the crack has grown by " + formatShort(growth.area - areaBefore) +
                    " m2 under the loads of t = " + readableTime(now) +
                    ", and what is left of the body does not bear them (" + state.failure +
                    "): the body breaks at these loads, or between them and those of the load step before";
           });
    record();
  }
}

template void followLoadFactor(State<2>&, const EquilibriumCalls&, const equilibrium::LastStep&, double);
template void followLoadFactor(State<3>&, const EquilibriumCalls&, const equilibrium::LastStep&, double);
template double endBeforeGrowth(const State<2>&, double, double);
template double endBeforeGrowth(const State<3>&, double, double);
template void growAtFixedLoads(State<2>&, const EquilibriumCalls&, const equilibrium::LastStep&, double,
                               double);
template void growAtFixedLoads(State<3>&, const EquilibriumCalls&, const equilibrium::LastStep&, double,
                               double);

} // namespace Rhegma
