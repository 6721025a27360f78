#include "Simulation.hpp"

#include "checkpoint/CheckpointFile.hpp"
#include "checkpoint/SceneText.hpp"
#include "checkpoint/ShareRecord.hpp"
#include "output/BodyReport.hpp"
#include "output/CoreRow.hpp"
#include "output/FieldWriter.hpp"
#include "output/OutputError.hpp"
#include "parallel/FirstRank.hpp"
#include "scene/Scene.hpp"
#include "step/EffectSchema.hpp"
#include "step/GiveHeat.hpp"
#include "step/Run.hpp"

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

namespace Rhegma
{

namespace
{

/// A checkpoint that is whole and can't be gone on from here; what follows its name in a sentence.
class CheckpointMisfit : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace

class Simulation::Engine
{
public:
  explicit Engine(const Ranks& ranks) : ranks_(ranks) {}
  virtual ~Engine() = default;
  const Ranks& ranks() const { return ranks_; }
  virtual void initialize() = 0;
  virtual double stableTimeStep() const = 0;
  virtual double stepShare() const = 0;
  virtual void advance(double until) = 0;
  virtual nlohmann::json report() const = 0;
  virtual std::string plan() const = 0;
  virtual std::map<std::string, double> stageSeconds() const = 0;
  virtual void writeFields(const std::string& folder) = 0;
  virtual bool continueFields(const std::string& folder) = 0;
  virtual std::vector<std::string> effects() const = 0;
  virtual void syncFields() const = 0;
  virtual bool sound() const = 0;
  virtual double wallSeconds() const = 0;
  virtual const FieldTable& particles() const = 0;
  virtual void giveHeat(const std::vector<double>& joules) = 0;
  virtual Record save(const Notes& notes) = 0;
  virtual Notes load(const Record& record) = 0;
  virtual Notes goBack() = 0;

  struct Progress
  {
    double time = 0.0;
    long steps = 0;
    bool settled = false;
    bool ended = false;
    int particles = 0;
    double particleSteps = 0.0;
  };
  virtual Progress progress() const = 0;

  double interval = 0.0;
  std::function<void(double, const Row&)> observer;
  std::function<void(double, long)> afterStep;
  Row last;
  Record held;
  double heldTime = -1.0; ///< negative: nothing is held

  /// The first rank has all that is held; no other needs it until the run goes back.
  void keepOnFirst()
  {
    if (ranks_.rank() > 0)
      held.clear();
  }

private:
  Ranks ranks_;
};

template <int D>
class Simulation::EngineOf : public Simulation::Engine
{
public:
  EngineOf(const Teuchos::ParameterList& scene, const Ranks& ranks)
      : Engine(ranks), scene_(scene), lines_(sceneLines(scene, effectSchema()))
  {
    makeRun(run_);
    const std::vector<std::string> names = run_->effectNames();
    effects_.insert(names.begin(), names.end());
  }

  void initialize() override { initialize(*run_); }

  double stableTimeStep() const override { return run_->stableTimeStep(); }
  double stepShare() const override { return run_->stepShare(); }

  void advance(double until) override
  {
    State<D>& state = run_->state();
    while (state.time < until && !state.ended())
    {
      const double dt = run_->stableTimeStep();
      const bool ends = state.time + dt >= until || state.step + 1 >= state.maximumSteps;
      const bool sample = interval > 0.0 && (ends || state.time + dt >= next_);
      run_->step(until, sample);
      if (sample)
      {
        // Samples missed by a long step are left out, not bunched up.
        while (next_ <= state.time)
          next_ += interval;
        Engine::last = state.row;
        if (observer)
          observer(state.time, state.row);
      }
      try
      {
        if (afterStep)
          afterStep(state.time, state.step);
      }
      catch (...)
      {
        // Who stops the run, on all ranks at once, reads the books as they are now.
        measureEnergy(state);
        shareBooks(state);
        throw;
      }
    }
  }

  nlohmann::json report() const override
  {
    nlohmann::json summary = nlohmann::json::object();
    const State<D>& state = run_->state();
    summary["warnings"] = state.warnings;
    const std::string ofEnergy =
        run_->energyWatch().warning(state.picFraction > 0.0, state.step, state.subcycledLevels);
    if (!ofEnergy.empty() && state.trouble.empty())
      summary["warnings"].push_back(ofEnergy);
    coreReport(state, summary);
    bodyReport(state, summary);
    for (const Effect<D>& effect : run_->plan().effects)
      if (effect.report)
        effect.report(state, summary);
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
    if (!writer_ && !fieldsBefore_.empty())
      continueFields(folder);
    if (!writer_)
      writer_ = std::make_unique<FieldWriter<D>>(folder, run_->state().ranks);
    writer_->write(run_->state());
  }

  bool continueFields(const std::string& folder) override
  {
    if (fieldsBefore_.empty())
      return true;
    Archive archive = Archive::loading(fieldsBefore_, ranks());
    const Archive::Group group(archive, "fields");
    try
    {
      writer_ = std::make_unique<FieldWriter<D>>(folder, archive);
    }
    catch (const OutputError&)
    {
    }
    fieldsBefore_.clear();
    return writer_ != nullptr;
  }

  std::vector<std::string> effects() const override { return run_->effectNames(); }

  Progress progress() const override
  {
    const State<D>& state = run_->state();
    return {state.time, state.step, state.settled, state.ended(), allParticles(state), state.particleSteps};
  }

  void syncFields() const override
  {
    if (writer_)
      writer_->sync();
  }

  bool sound() const override { return run_->energyWatch().sound(); }

  double wallSeconds() const override { return earlierSeconds_ + timer_.seconds(); }

  const FieldTable& particles() const override { return run_->state().particles; }

  void giveHeat(const std::vector<double>& joules) override { Rhegma::giveHeat(run_->state(), joules); }

  Record save(const Notes& notes) override
  {
    Record record;
    Archive archive = Archive::saving(record, ranks());
    std::string version = RHEGMA_VERSION, scene = text(lines_);
    long hash = hashOfScene(lines_);
    archive("version", version);
    archive("scene", scene);
    archive("scene_hash", hash);
    Notes copy = notes;
    keepNotes(copy, archive);
    keep(*run_, next_, Engine::last, archive);
    double wall = wallSeconds();
    archive("wall_seconds", wall);
    if (writer_)
    {
      const Archive::Group group(archive, "fields");
      writer_->keep(archive);
    }
    else
      record.insert(fieldsBefore_.begin(), fieldsBefore_.end());
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
      throw CheckpointMisfit(std::string("has no scene: ") + error.what());
    }
    const std::string difference = differenceOfScenes(lines_, linesOf(scene));
    if (!difference.empty())
      throw CheckpointMisfit("is of another scene: " + difference);
    // All is made anew, so that nothing of what has been done since is left, and what goes wrong changes
    // nothing.
    std::unique_ptr<Run<D>> run;
    makeRun(run);
    initialize(*run);
    Notes notes;
    double next = 0.0, wall = 0.0;
    Row sampled;
    try
    {
      keepNotes(notes, archive);
      keep(*run, next, sampled, archive);
      archive("wall_seconds", wall);
    }
    catch (const std::invalid_argument& error)
    {
      throw CheckpointMisfit(std::string("does not fit this program, though its scene is right: ") +
                             error.what());
    }
    run_ = std::move(run);
    next_ = next;
    Engine::last = sampled;
    earlierSeconds_ = wall;
    timer_.reset();
    writer_.reset();
    fieldsBefore_.clear();
    for (const auto& [path, table] : record)
      if (path.rfind("fields/", 0) == 0)
        fieldsBefore_[path] = table;
    return notes;
  }

  Notes goBack() override
  {
    const double share = 0.5 * run_->stepShare();
    shareRecord(ranks(), held);
    Notes notes = load(held);
    keepOnFirst();
    run_->takeShareOfStep(share);
    return notes;
  }

private:
  void makeRun(std::unique_ptr<Run<D>>& run)
  {
    run = std::make_unique<Run<D>>(scene_, std::vector<Effect<D>>{}, ranks());
    run->beforeObserve = [this](State<D>& state) { coreRow(state, effects_); };
  }

  void initialize(Run<D>& run)
  {
    run.initialize();
    State<D>& state = run.state();
    coreRow(state, effects_);
    state.energy.start = state.energy.kinetic + state.energy.strain;
    state.energy.thermalStart = state.energy.thermal;
    state.energy.thermal = 0.0;
    state.row.clear();
  }

  static void keep(Run<D>& run, double& next, Row& last, Archive& archive)
  {
    run.keep(archive);
    const Archive::Group group(archive, "sampling");
    archive("next", next);
    std::vector<std::string> names;
    std::vector<double> values;
    for (const auto& [name, value] : last)
    {
      names.push_back(name);
      values.push_back(value);
    }
    archive("names", names);
    archive("values", values);
    last.clear();
    for (std::size_t k = 0; k < std::min(names.size(), values.size()); ++k)
      last.emplace_back(names[k], values[k]);
  }

  static void keepNotes(Notes& notes, Archive& archive)
  {
    const Archive::Group group(archive, "notes");
    std::vector<std::string> names, texts;
    for (const auto& [name, text] : notes)
    {
      names.push_back(name);
      texts.push_back(text);
    }
    archive("names", names);
    archive("texts", texts);
    for (std::size_t k = 0; k < std::min(names.size(), texts.size()); ++k)
      notes[names[k]] = texts[k];
  }

  static std::string text(const std::vector<std::string>& lines)
  {
    std::string all;
    for (const std::string& line : lines)
      all += line + "\n";
    return all;
  }

  static std::vector<std::string> linesOf(const std::string& text)
  {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
      lines.push_back(line);
    return lines;
  }

  Teuchos::ParameterList scene_;
  std::vector<std::string> lines_; ///< of the scene
  std::unique_ptr<Run<D>> run_;
  std::set<std::string> effects_;
  std::unique_ptr<FieldWriter<D>> writer_;
  Record fieldsBefore_; ///< what a checkpoint says of the fields, until they are gone on with
  double next_ = 0.0;
  double earlierSeconds_ = 0.0;
  Kokkos::Timer timer_;
};

namespace
{

/// Throws std::invalid_argument where the scene has effects that work on one rank only.
void refuseOnRanks(const Teuchos::ParameterList& scene)
{
  std::string alone;
  for (const EffectEntry& entry : knownEffects())
    if (scene.isSublist(entry.section.name) && !entry.onRanks)
      alone += (alone.empty() ? "" : ", ") + entry.section.name;
  if (!alone.empty())
    throw std::invalid_argument(alone + ": this version runs such scenes on one rank; start it without "
                                        "mpirun, or with mpirun -np 1");
}

} // namespace

Simulation::Simulation(Teuchos::RCP<const Teuchos::Comm<int>> comm,
                       const Teuchos::RCP<Teuchos::ParameterList>& scene)
{
  std::vector<SceneError> errors;
  validateList(*scene, effectSchema(), errors);
  if (!errors.empty())
  {
    std::ostringstream all;
    for (const SceneError& error : errors)
      all << (&error == &errors.front() ? "" : "\n") << error.where << ": " << error.message;
    throw std::invalid_argument(all.str());
  }
  const Ranks ranks(comm);
  if (ranks.many())
    refuseOnRanks(*scene);
  if (scene->sublist("Domain").get<int>("Dimension") == 2)
    engine_ = std::make_unique<EngineOf<2>>(*scene, ranks);
  else
    engine_ = std::make_unique<EngineOf<3>>(*scene, ranks);
}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::initialize() { engine_->initialize(); }

void Simulation::checkpoint(const std::string& path, const Notes& notes)
{
  const Record record = engine_->save(notes);
  onFirstRank<OutputError>(engine_->ranks(),
                           [&]
                           {
                             engine_->syncFields();
                             writeCheckpoint(path, record);
                           });
}

Simulation::Notes Simulation::restore(const std::string& path)
{
  // All ranks read it: what one can't read, none goes on from.
  Record record;
  onEachRank(engine_->ranks(), [&] { record = readCheckpoint(path); });
  try
  {
    return engine_->load(record);
  }
  catch (const CheckpointMisfit& error)
  {
    throw std::invalid_argument("the checkpoint " + path + " " + error.what());
  }
}

void Simulation::hold(const Notes& notes)
{
  engine_->held = engine_->save(notes);
  engine_->keepOnFirst();
  engine_->heldTime = time();
}

bool Simulation::holds() const { return engine_->heldTime >= 0.0; }
double Simulation::heldTime() const { return engine_->heldTime; }
void Simulation::checkpointHeld(const std::string& path) const
{
  onFirstRank<OutputError>(engine_->ranks(), [&] { writeCheckpoint(path, engine_->held); });
}
Simulation::Notes Simulation::goBack() { return engine_->goBack(); }
bool Simulation::sound() const { return engine_->sound(); }
double Simulation::wallSeconds() const { return engine_->wallSeconds(); }
bool Simulation::continueFields(const std::string& folder) { return engine_->continueFields(folder); }
double Simulation::stepShare() const { return engine_->stepShare(); }
double Simulation::stableTimeStep() const { return engine_->stableTimeStep(); }
void Simulation::advance(double time) { engine_->advance(time); }

void Simulation::sampleEvery(double interval, std::function<void(double, const Row&)> observer)
{
  engine_->interval = interval;
  engine_->observer = std::move(observer);
}

void Simulation::onStep(std::function<void(double, long)> progress)
{
  engine_->afterStep = std::move(progress);
}
const Simulation::Row& Simulation::observe() const { return engine_->last; }

std::vector<std::string> Simulation::particleFields() const
{
  std::vector<std::string> names;
  for (const Field& field : engine_->particles().fields())
    names.push_back(field.name);
  return names;
}

ParticleCopy Simulation::particleField(const std::string& name) const
{
  return copyField(engine_->particles(), name);
}

void Simulation::giveHeat(const std::vector<double>& joules) { engine_->giveHeat(joules); }
double Simulation::time() const { return engine_->progress().time; }
long Simulation::steps() const { return engine_->progress().steps; }
bool Simulation::settled() const { return engine_->progress().settled; }
bool Simulation::ended() const { return engine_->progress().ended; }
int Simulation::particles() const { return engine_->progress().particles; }
double Simulation::particleSteps() const { return engine_->progress().particleSteps; }
std::vector<std::string> Simulation::effects() const { return engine_->effects(); }
std::string Simulation::plan() const { return engine_->plan(); }
std::map<std::string, double> Simulation::stageSeconds() const { return engine_->stageSeconds(); }
nlohmann::json Simulation::report() const { return engine_->report(); }
void Simulation::writeFields(const std::string& folder) { engine_->writeFields(folder); }

} // namespace Rhegma
