#include "SimulationEngine.hpp"

#include "ArchivedSampling.hpp"
#include "ContinuedFiles.hpp"
#include "SceneOfCheckpoint.hpp"
#include "archive/BroadcastRecord.hpp"
#include "base/FoldMessages.hpp"
#include "base/OutputError.hpp"
#include "checkpoint/SceneText.hpp"
#include "output/BodyReport.hpp"
#include "output/CoreRow.hpp"
#include "output/FieldWriter.hpp"
#include "output/FrontFiles.hpp"
#include "output/LibraryReport.hpp"
#include "parallel/FirstRank.hpp"
#include "plan/EffectSchema.hpp"
#include "state/EnergySums.hpp"
#include "state/Nonlinearity.hpp"
#include "step/GiveHeat.hpp"
#include "step/Run.hpp"
#include "step/StartOfMotion.hpp"
#include "step/TransferRun.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

namespace Rhegma
{

/// Warnings of one kind are folded where there are more; of many kinds, none is lost.
constexpr std::size_t mostWarnings = 100;

/// Entry of checkpoints of motion that has followed an equilibrium.
constexpr const char* motionName = "motion";

/// The fields that a scene asks for. \param scene validated
static RequestedFields requestedFields(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& output = scene.sublist("Output");
  return {output.get<bool>("Principal Stress"), output.get<bool>("Energy Density"),
          output.get<bool>("Damage"), output.get<bool>("State Variables")};
}

template <int D>
class Simulation::EngineOf : public Simulation::Engine
{
public:
  EngineOf(const Teuchos::RCP<Teuchos::ParameterList>& scene, const Ranks& ranks)
      : Engine(ranks), scene_(scene)
  {
    run_ = makeRun(scene);
  }

  void initialize() override { initialize(*run_); }

  double stableTimeStep() const override { return run_->stableTimeStep(); }
  double stepFraction() const override { return run_->stepFraction(); }

  void advance(double until) override
  {
    run_->onIteration(onIteration);
    while (run_->state().clock.time < until && !run_->state().clock.ended())
    {
      const bool due = interval > 0.0 && sampleIsDue(run_->state().clock, until);
      sampled = due || sampleNext;
      const bool motionFollows = step(until, sampled);
      sampled = sampled || motionFollows;
      sampleNext = false;
      State<D>& state = run_->state();
      if (state.warnings.size() > mostWarnings)
        state.warnings = foldMessages(state.warnings);
      if (sampled)
        Engine::last = state.sample.row;
      if (due || (motionFollows && interval > 0.0))
      {
        // Samples missed by a step are left out.
        const double apart = sampleInterval();
        while (next_ <= state.clock.time)
          next_ += apart;
        if (observer)
          observer(state.clock.time, state.sample.row);
      }
      if (motionFollows)
        startMotion();
      callAfterStep(run_->state());
    }
  }

  bool trySolve(bool onlyLoads) override { return run_->trySolve(onlyLoads); }

  /// What growth left open in the energy balance of an equilibrium, without what was open before it.
  void judgeGrowthInEquilibrium(nlohmann::json& summary) const
  {
    if (!run_->state().method.equilibrium() || !summary.contains("propagation"))
      return;
    const EnergyWatch& watch = run_->energyWatch();
    nlohmann::json& fraction = summary["propagation"]["residual_fraction"];
    if (watch.fractureOfGrowth() > 0.0)
      fraction = watch.residualOfGrowth() / watch.fractureOfGrowth();
    else // the first sample with growth is one in which a front has ended
      fraction = nullptr;
  }

  nlohmann::json report(std::size_t mostBodies) const override
  {
    nlohmann::json summary = nlohmann::json::object();
    const State<D>& state = run_->state();
    summary["warnings"] = state.warnings;
    const EnergyWatch& watch = run_->energyWatch();
    const std::string ofEnergy =
        state.method.equilibrium()
            ? watch.warningInEquilibrium(
                  {state.cracks.growth.area > 0.0, state.method.analysis == Analysis::LoadFactor,
                   anyEnded(state.cracks), isNonlinear(state), state.energy.heat != 0.0})
            : watch.warning(state.method.picFraction > 0.0, state.clock.step, state.mesh.subcycledLevels);
    if (!ofEnergy.empty() && state.failure.empty())
      summary["warnings"].push_back(ofEnergy);
    summary["largest_energy_supplied"] = watch.supplied();
    coreReport(state, summary);
    bodyReport(state, summary, mostBodies);
    reportLibrary(*scene_, effectSchema(), summary);
    for (const Effect<D>& effect : run_->plan().effects)
      if (effect.report)
        effect.report(state, summary);
    judgeGrowthInEquilibrium(summary);
    summary["warnings"] = foldMessages(summary["warnings"].get<std::vector<std::string>>());
    return summary;
  }

  std::string plan() const override { return printPlan(run_->plan(), run_->state()); }

  std::map<std::string, double> stageSeconds() const override
  {
    std::map<std::string, double> seconds;
    for (int s = 0; s < numStages; ++s)
      if (!run_->plan().calls[s].empty())
        seconds[stageName(static_cast<Stage>(s))] = run_->plan().seconds[s];
    return seconds;
  }

  void writeFields(const std::string& folder) override
  {
    std::error_code none;
    if (!fieldsIn_.empty() && asFirstRank(ranks(), !std::filesystem::equivalent(folder, fieldsIn_, none)))
      writer_.reset();
    fieldsIn_ = folder;
    if (!writer_ && !fieldsBefore_.empty())
      if (const std::string why = continueFields(folder);
          !why.empty() && asFirstRank(ranks(), std::filesystem::exists(folder + "/fields.h5")))
        throw OutputError(folder +
                          "/fields.h5 does not hold the fields of the run up to the checkpoint: " + why);
    if (!writer_)
      writer_ = std::make_unique<FieldWriter<D>>(folder, run_->state().ranks);
    writer_->write(run_->state(), requestedFields(*scene_));
  }

  std::string continueFields(const std::string& folder) override
  {
    fieldsIn_ = folder;
    return continueFiles(folder, ranks(), "fields", fieldsBefore_, writer_);
  }

  void writeFronts(const std::string& folder) override
  {
    const State<D>& state = run_->state();
    if (state.sample.fronts.empty() || state.sample.step != state.clock.step)
      return;
    if (!fronts_ && !frontsBefore_.empty())
      if (const std::string why = continueFronts(folder);
          !why.empty() && asFirstRank(ranks(), std::filesystem::exists(folder + "/fronts.h5")))
        throw OutputError(folder +
                          "/fronts.h5 does not hold the fronts of the run up to the checkpoint: " + why);
    if (!fronts_)
      fronts_ = std::make_unique<FrontFiles>(folder, state.ranks);
    fronts_->write(state.clock.time, state.sample.fronts);
  }

  std::string continueFronts(const std::string& folder) override
  {
    return continueFiles(folder, ranks(), "fronts", frontsBefore_, fronts_);
  }

  std::vector<std::string> effects() const override { return run_->effectNames(); }

  Progress progress() const override
  {
    const State<D>& state = run_->state();
    return {state.clock.time,    state.clock.step,    state.clock.settled,
            state.clock.ended(), allParticles(state), state.particles.particleSteps};
  }

  void syncFields() const override
  {
    if (writer_)
      writer_->sync();
    if (fronts_)
      fronts_->sync();
  }

  bool sound() const override { return run_->energyWatch().sound(); }

  double wallSeconds() const override { return earlierSeconds_ + timer_.seconds(); }

  const FieldTable& particles() const override { return run_->state().particles; }

  void giveHeat(const std::vector<double>& joules) override { Rhegma::giveHeat(run_->state(), joules); }

  Record save(const Notes& notes) override
  {
    Record record;
    Archive archive = Archive::saving(record, ranks());
    std::string version = RHEGMA_VERSION, scene = text(lines());
    long hash = hashOfScene(lines());
    archive("version", version);
    archive("scene", scene);
    archive("scene_hash", hash);
    Notes copy = notes;
    archiveNotes(copy, archive);
    if (bool moving = isMotion(); moving)
      archive(motionName, moving);
    run_->serialize(archive);
    archiveSampling(next_, Engine::last, archive);
    double wall = wallSeconds();
    archive("wall_seconds", wall);
    saveFiles(archive, record, "fields", fieldsBefore_, writer_);
    saveFiles(archive, record, "fronts", frontsBefore_, fronts_);
    return record;
  }

  Notes load(const Record& record) override
  {
    Archive archive = Archive::loading(record, ranks());
    std::string scene;
    try
    {
      archive("scene", scene);
    }
    catch (const std::invalid_argument& error)
    {
      throw CheckpointMisfit(std::string("holds no scene: ") + error.what());
    }
    const std::string difference = differenceOfScenes(lines(), linesOf(scene));
    if (!difference.empty())
      throw CheckpointMisfit("belongs to another scene: " + difference +
                             reasonOfDifference(difference, *scene_, effectSchema()));
    // Everything is made anew, so that nothing of the later state remains, and an error changes nothing.
    std::unique_ptr<Run<D>> run = makeInitialised(record.count(motionName) > 0);
    Notes notes;
    double next = 0.0, wall = 0.0;
    Row sampledRow;
    try
    {
      archiveNotes(notes, archive);
      run->serialize(archive);
      archiveSampling(next, sampledRow, archive);
      archive("wall_seconds", wall);
    }
    catch (const std::invalid_argument& error)
    {
      throw CheckpointMisfit("was written by another build of this program, version " + versionOf(record) +
                             ", whose data layout differs from that of this build, version " RHEGMA_VERSION
                             ": " +
                             error.what() + "; restart with the build that wrote it");
    }
    run_ = std::move(run);
    next_ = next;
    Engine::last = sampledRow;
    earlierSeconds_ = wall;
    timer_.reset();
    writer_.reset();
    fronts_.reset();
    fieldsBefore_ = partOf(record, "fields/");
    frontsBefore_ = partOf(record, "fronts/");
    return notes;
  }

  Notes goBack() override
  {
    const double fraction = 0.5 * run_->stepFraction();
    broadcastRecord(ranks(), held);
    Notes notes = load(held);
    keepOnFirst();
    run_->setStepFraction(fraction);
    return notes;
  }

private:
  /// Whether the next step ends with a sample.
  bool sampleIsDue(const Clock& clock, double until) const
  {
    const double end = clock.time + run_->stableTimeStep();
    return end >= std::min(until, clock.lastTime) || clock.step + 1 >= clock.maximumSteps || end >= next_;
  }

  void callAfterStep(State<D>& state)
  try
  {
    if (afterStep)
      afterStep(state.clock.time, state.clock.step);
  }
  catch (...)
  {
    // The end of the run reads the current energy balance.
    measureEnergy(state);
    sumEnergyBalance(state);
    throw;
  }

  /// The scene as text, which only checkpoints need: made where it is first asked for.
  const std::vector<std::string>& lines()
  {
    if (lines_.empty())
      lines_ = sceneLines(*scene_, effectSchema());
    return lines_;
  }

  std::unique_ptr<Run<D>> makeRun(const Teuchos::RCP<Teuchos::ParameterList>& scene)
  {
    auto run = std::make_unique<Run<D>>(scene, std::vector<Effect<D>>{}, ranks());
    run->beforeObserve = [this](State<D>& state) { coreRow(state, balance_); };
    return run;
  }

  /// An initialised run. \param moving whether it is the motion that follows an equilibrium
  std::unique_ptr<Run<D>> makeInitialised(bool moving)
  {
    std::unique_ptr<Run<D>> run = makeRun(moving ? sceneOfMotion(*scene_) : scene_);
    run->onIteration(onIteration);
    initialize(*run);
    return run;
  }

  /// Whether motion has followed an equilibrium.
  bool isMotion() const { return run_->state().method.handsOver && !run_->state().method.equilibrium(); }

  /// Takes a step. \return whether it ends where motion follows the equilibrium
  bool step(double until, bool sample)
  {
    const Method& method = run_->state().method;
    if (method.handsOver && method.equilibrium())
      return stepToMotion<D>(run_, until, sample, [this] { return makeInitialised(false); });
    run_->step(until, sample);
    return false;
  }

  /// Replaces the run, which ends in equilibrium, by one of motion that begins there.
  void startMotion()
  {
    const Record record = recordOf(*run_);
    std::unique_ptr<Run<D>> run = makeInitialised(true);
    loadRecord(record, *run);
    run->startMotion();
    run_ = std::move(run);
    next_ = run_->state().clock.time + sampleInterval();
  }

  /// Time between two samples [s]; 0: there are none. Motion that has a time of its own has as many at least
  /// as a run by default.
  double sampleInterval() const
  {
    constexpr double usualSamples = 200.0;
    const Teuchos::ParameterList& time = scene_->sublist("Time");
    return interval > 0.0 && isMotion() && time.isParameter("Dynamic Time")
               ? std::min(interval, time.get<double>("Dynamic Time") / usualSamples)
               : interval;
  }

  void initialize(Run<D>& run)
  {
    run.initialize();
    for (const Effect<D>& effect : run.plan().effects)
      balance_.insert(effect.balance.begin(), effect.balance.end());
    State<D>& state = run.state();
    coreRow(state, balance_);
    // A preload may have caused plastic flow already.
    state.energy.start =
        state.energy.kinetic + state.energy.strain + state.energy.tools + state.energy.plastic;
    state.energy.thermalStart = state.energy.thermal;
    state.energy.thermal = 0.0;
    state.sample.row.clear();
  }

  Teuchos::RCP<Teuchos::ParameterList> scene_;
  std::vector<std::string> lines_; ///< of the scene; empty: not yet made
  std::unique_ptr<Run<D>> run_;
  std::set<std::string> balance_; ///< columns of the energy balance from effects
  std::unique_ptr<FieldWriter<D>> writer_;
  std::string fieldsIn_; ///< folder of its files
  std::unique_ptr<FrontFiles> fronts_;
  Record fieldsBefore_; ///< state of the fields in a checkpoint, until they are continued
  Record frontsBefore_; ///< the same of the values along fronts
  double next_ = 0.0;
  double earlierSeconds_ = 0.0;
  Kokkos::Timer timer_;
};

std::unique_ptr<Simulation::Engine>
Simulation::Engine::make(const Teuchos::RCP<Teuchos::ParameterList>& scene, const Ranks& ranks)
{
  if (scene->sublist("Domain").get<int>("Dimension") == 2)
    return std::make_unique<EngineOf<2>>(scene, ranks);
  return std::make_unique<EngineOf<3>>(scene, ranks);
}

} // namespace Rhegma
