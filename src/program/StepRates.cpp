#include "program/StepRates.hpp"

#include "base/OutputError.hpp"
#include "output/Summary.hpp"
#include "parallel/FirstRank.hpp"
#include "plan/KnownEffects.hpp"
#include "program/Budget.hpp"
#include "program/Intervals.hpp"
#include "program/ScratchFolder.hpp"

#include <Kokkos_Core.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numeric>
#include <type_traits>
#include <vector>

namespace Rhegma::program
{

namespace
{

/// Linear systems of a load step and of the end of a run, where none was solved: those of most scenes.
constexpr double usualSolves = 4.0, usualSolvesOfSearch = 10.0; // of one for a load factor

/// Linear systems for an increment of a front under loads that follow time: three for the increment, and
/// three for the load step that leads to the next one. dcb_grips_static takes 6.2.
constexpr double usualSolvesOfIncrement = 6.0;

/// Load steps that take longer, as a multiple of the time to measure, are not taken.
constexpr double longestLoadStep = 3.0;

/// Part of a run of which the rest needs no guess of how cells will change.
constexpr double wellKnown = 0.7;

class Measurement
{
public:
  Measurement(Simulation& simulation, const Teuchos::ParameterList& scene, const Ranks& ranks)
      : simulation_(simulation), finalTime_(scene.sublist("Time").get<double>("Final Time")), ranks_(ranks)
  {
  }

  /// \param seconds of the processor
  void steps(double seconds, StepRates& rates)
  {
    const Budget budget(ranks_);
    std::vector<Mark> marks{mark()};
    long batch = 1;
    // What is left is for samples.
    while (!over() && simulation_.time() < 0.97 * finalTime_ && budget.less(seconds))
    {
      const Budget ofBatch(ranks_);
      advance(batch);
      marks.push_back(mark());
      if (ofBatch.less(0.02 * seconds))
        batch *= 2;
    }
    // The second half counts: at first memory is taken, and cells and loads are not yet as they will be.
    const Mark& last = marks.back();
    const long half = (marks.front().step + last.step) / 2;
    const auto isLate = [&](const Mark& m) { return m.step >= half; };
    const Mark& first =
        marks.size() < 3 ? marks.front() : *std::find_if(marks.begin(), marks.end() - 2, isLate);
    const double measured = static_cast<double>(std::max(1L, last.step - first.step));
    const double spent = last.processor - first.processor;
    rates.step = ranks_.max(spent) / measured;
    rates.timeStep =
        last.step > first.step ? (last.time - first.time) / measured : simulation_.stableTimeStep();
    rates.busy = ranks_.max(spent > 0.0 ? std::max(1.0, (last.wall - first.wall) / spent) : 1.0);
    late_ = {first.time, last.time};
    rates.spent = ranks_.max(last.processor - marks.front().processor);
  }

  /// The part of the run that the second half of its first steps is.
  const Part& late() const { return late_; }

  void samples(double seconds, StepRates& rates)
  {
    if (over())
      return;
    simulation_.sampleEvery(finalTime_, [](double, const Simulation::Row&) {});
    const Budget budget(ranks_);
    double processor = processorSeconds();
    int taken = 0;
    while (!over() && taken < 8 && (taken == 0 || budget.less(seconds)))
    {
      advance(1);
      // As with steps, the first one is not like the others.
      if (taken++ == 0 && budget.less(0.25 * seconds) && !over())
      {
        processor = processorSeconds();
        advance(1);
      }
    }
    rates.sample = std::max(0.0, ranks_.max(processorSeconds() - processor) / taken - rates.step);
  }

  /// Load steps, each with a sample as in the run. \return whether the analysis is one of equilibrium
  bool loadSteps(double seconds, StepRates& rates)
  {
    const Budget trial(ranks_);
    if (!simulation_.trySolve())
      return false;
    const nlohmann::json summary = simulation_.report(0), &found = summary.at("equilibrium");
    const bool grows = summary.contains("propagation");
    const bool searches = grows && summary["propagation"].contains("load_factor");
    rates.unknowns = found.at("unknowns").get<int>();
    rates.solve = trial.spent();
    rates.busy = ranks_.max(trial.busy());
    rates.timeStep = simulation_.stableTimeStep();
    rates.solves = searches ? usualSolvesOfSearch : usualSolves;
    rates.incrementSolves = grows && !searches ? usualSolvesOfIncrement : 0.0;
    rates.step = rates.solves * rates.solve;
    if (rates.step > longestLoadStep * seconds)
      return true;
    const long first = linearSystems();
    const Budget budget(ranks_);
    simulation_.sampleEvery(1e-3 * rates.timeStep, [](double, const Simulation::Row&) {});
    int taken = 0;
    for (; !over() && (taken == 0 || budget.less(seconds)); ++taken)
    {
      // A little less than a load step: of more, by rounding, two would be made.
      const double step = simulation_.stableTimeStep(), end = simulation_.time() + (1.0 - 1e-9) * step;
      simulation_.advance(finalTime_ - end > 1e-6 * step ? end : finalTime_);
    }
    rates.spent = budget.spent();
    rates.step = rates.spent / taken;
    rates.timeStep = simulation_.stableTimeStep();
    rates.solves = static_cast<double>(linearSystems() - first) / taken;
    rates.solve = rates.step / std::max(1.0, rates.solves);
    return true;
  }

  /// A snapshot and a checkpoint, of those that the run writes: in one folder, since a checkpoint waits until
  /// the fields are on the disk.
  void files(const Teuchos::ParameterList& scene, StepRates& rates)
  {
    const bool fields = scene.sublist("Output").get<bool>("Fields"), checkpoints = writesCheckpoints(scene);
    if (!fields && !checkpoints)
      return;
    const ScratchFolder folder(ranks_);
    if (folder.path().empty())
      return;
    try
    {
      const double processor = processorSeconds();
      if (fields)
        simulation_.writeFields(folder.path());
      rates.frame = fields ? ranks_.max(processorSeconds() - processor) : 0.0;
      rates.frameBytes = ranks_.max(folder.bytes());
      if (!checkpoints)
        return;
      const double begin = wallSeconds();
      simulation_.checkpoint(folder.path() + "/checkpoint.h5");
      rates.checkpoint = ranks_.max(wallSeconds() - begin);
      rates.checkpointBytes = ranks_.max(folder.bytes()) - rates.frameBytes;
    }
    catch (const OutputError&) // a run would say so
    {
    }
  }

private:
  /// Where the simulation is, and when.
  struct Mark
  {
    long step;
    double time, processor, wall;
  };
  Mark mark() const { return {simulation_.steps(), simulation_.time(), processorSeconds(), wallSeconds()}; }
  /// That were solved so far; 0 in a dynamic analysis.
  long linearSystems() const
  {
    const nlohmann::json summary = simulation_.report(0);
    return summary.contains("equilibrium") ? summary["equilibrium"].value("iterations", 0L) : 0L;
  }
  bool over() const { return simulation_.time() >= finalTime_ || simulation_.ended(); }

  /// The last of the steps ends a little early: where it would end only rounding decides.
  void advance(long steps)
  {
    const double length = simulation_.stableTimeStep() * (static_cast<double>(steps) - 0.01);
    simulation_.advance(std::min(finalTime_, simulation_.time() + length));
  }

  Simulation& simulation_;
  double finalTime_;
  Ranks ranks_;
  Part late_;
};

double finestCell(const Simulation& simulation)
{
  return simulation.report(0).at("cells").at("smallest").get<double>();
}

/// The step to go on with. One that is less than half of the first one, in cells of the same size, is that of
/// something that passes, such as gas that begins to burn.
double lastingStep(double first, double measured, bool sameCells)
{
  return sameCells && measured < 0.5 * first ? first : measured;
}

void measureMotion(Measurement& measurement, const Simulation& simulation, double seconds, StepRates& rates)
{
  const double firstStep = simulation.stableTimeStep(), finest = finestCell(simulation);
  const long before = simulation.steps();
  measurement.steps(0.7 * seconds, rates);
  rates.steps = static_cast<int>(simulation.steps() - before);
  rates.timeStep = lastingStep(firstStep, rates.timeStep, finestCell(simulation) == finest);
  measurement.samples(0.3 * seconds, rates);
}

} // namespace

double wallSeconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double processorSeconds()
{
  if constexpr (!std::is_same_v<Kokkos::DefaultExecutionSpace, Kokkos::DefaultHostExecutionSpace>)
    return wallSeconds();
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

StepRates measureRates(Simulation& simulation, const Teuchos::ParameterList& scene, const Ranks& ranks,
                       double seconds)
{
  StepRates rates;
  rates.particles = simulation.particles();
  const double time = simulation.time();
  const long steps = simulation.steps();
  Part late;
  try
  {
    Measurement measurement(simulation, scene, ranks);
    if (!measurement.loadSteps(seconds, rates))
      measureMotion(measurement, simulation, seconds, rates);
    late = measurement.late();
    // A run keeps a copy of its state.
    simulation.hold();
    measurement.files(scene, rates);
  }
  catch (const RunError& error)
  {
    rates.failure = error.what();
  }
  const int ofSpent = rates.steps;
  rates.steps = static_cast<int>(simulation.steps() - steps);
  if (rates.unknowns == 0)
    rates.spent += rates.step * (rates.steps - ofSpent);
  rates.time = simulation.time() - time;
  const std::vector<double> memory = ranks.gatherOnAll({peakMemoryBytes()});
  rates.memory = std::accumulate(memory.begin(), memory.end(), 0.0);
  if (rates.failure.empty() && time == 0.0 && rates.unknowns == 0 && declaredOptions(scene).adaptive &&
      rates.time < wellKnown * scene.sublist("Time").get<double>("Final Time"))
    if (const auto growth = growthByCoarseRun(scene, late, ranks, seconds); growth && isNoticeable(*growth))
      rates.growth = *growth;
  return rates;
}

} // namespace Rhegma::program
