#include "step/StartOfMotion.hpp"

#include "step/TransferRun.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma
{

namespace
{

/// G/Gc under whose loads motion may begin, and the one that is looked for: with less, cracks would wait for
/// loads that may rise slowly; with more, they would start faster than they do.
constexpr double mostDrive = 1.002, wantedDrive = 1.001;

/// Parts of an interval at which it is divided.
constexpr double leastPart = 0.02, mostPart = 0.98;

/// Relative length of an interval of time that is not divided further: G jumps within it.
constexpr double shortest = 1e-9;

/// Where to divide the interval between loads under which growth is stable and unstable: where G/Gc is the
/// wanted one, for loads that are linear in time. \param stable, unstable G/Gc under these loads before
/// cracks grow
double partOfInterval(double stable, double unstable)
{
  const double begin = std::sqrt(std::max(stable, 0.0)), end = std::sqrt(unstable);
  const double wanted = std::sqrt(wantedDrive);
  if (!(end > begin) || begin >= wanted || wanted >= end)
    return 0.5;
  return std::clamp((wanted - begin) / (end - begin), leastPart, mostPart);
}

template <int D>
void restore(const Record& record, const MakeRun<D>& make, std::unique_ptr<Run<D>>& run)
{
  run = make();
  loadRecord(record, *run);
}

/// Ends the equilibrium: takes the last step again, in which no crack advances. \param rise of G/Gc when one
/// does
template <int D>
void stepToVerge(Run<D>& run, double until, double rise)
{
  constexpr double noticeable = 0.01; // where no equilibrium is found, G has no rise
  EquilibriumGrowth& growth = run.state().cracks.growth;
  const double from = run.state().clock.time;
  growth.held = true;
  while (run.state().clock.time < until)
    run.step(until, true);
  growth.held = false;
  growth.path.push_back({until, 0.0, 0.0, growth.area, std::max(rise, noticeable), from, until});
}

} // namespace

Teuchos::RCP<Teuchos::ParameterList> sceneOfMotion(const Teuchos::ParameterList& scene)
{
  const auto motion = Teuchos::rcp(new Teuchos::ParameterList(scene));
  motion->setName(scene.name());
  motion->sublist("Time").set("Analysis", std::string("Dynamic"));
  return motion;
}

template <int D>
bool stepToMotion(std::unique_ptr<Run<D>>& run, double until, bool sample, const MakeRun<D>& make)
{
  Record before = recordOf(*run);
  double stableUntil = run->state().clock.time, drive = run->state().cracks.growth.drive;
  run->step(until, sample);
  if (!run->state().cracks.growth.unstable.found)
    return false;
  const double whole = until - stableUntil;
  double unstableAt = run->state().clock.time;
  UnstableGrowth unstable = run->state().cracks.growth.unstable;
  while (unstable.drive > mostDrive && unstableAt - stableUntil > shortest * whole)
  {
    const double at = stableUntil + partOfInterval(drive, unstable.drive) * (unstableAt - stableUntil);
    restore(before, make, run);
    run->step(at, false);
    if (run->state().cracks.growth.unstable.found)
    {
      unstableAt = run->state().clock.time;
      unstable = run->state().cracks.growth.unstable;
      continue;
    }
    before = recordOf(*run);
    stableUntil = run->state().clock.time;
    drive = run->state().cracks.growth.drive;
  }
  restore(before, make, run);
  stepToVerge(*run, unstableAt, unstable.rise);
  return true;
}

template bool stepToMotion(std::unique_ptr<Run<2>>&, double, bool, const MakeRun<2>&);
template bool stepToMotion(std::unique_ptr<Run<3>>&, double, bool, const MakeRun<3>&);

} // namespace Rhegma
