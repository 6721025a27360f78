#include "Simulation.hpp"

#include "output/BodyReport.hpp"
#include "output/CoreRow.hpp"
#include "output/FieldWriter.hpp"
#include "scene/Scene.hpp"
#include "step/EffectSchema.hpp"
#include "step/Run.hpp"

#include <set>
#include <sstream>
#include <stdexcept>

namespace Rhegma
{

class Simulation::Engine
{
public:
  virtual ~Engine() = default;
  virtual void initialize() = 0;
  virtual double stableTimeStep() const = 0;
  virtual void advance(double until) = 0;
  virtual nlohmann::json report() const = 0;
  virtual std::string plan() const = 0;
  virtual std::map<std::string, double> stageSeconds() const = 0;
  virtual void writeFields(const std::string& folder) = 0;
  virtual std::vector<std::string> effects() const = 0;

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
};

template <int D>
class Simulation::EngineOf : public Simulation::Engine
{
public:
  EngineOf(const Teuchos::ParameterList& scene, const Ranks& ranks) : run_(scene, {}, ranks)
  {
    const std::vector<std::string> names = run_.effectNames();
    effects_.insert(names.begin(), names.end());
    run_.beforeObserve = [this](State<D>& state) { coreRow(state, effects_); };
  }

  void initialize() override
  {
    run_.initialize();
    State<D>& state = run_.state();
    coreRow(state, effects_);
    state.energy.start = state.energy.kinetic + state.energy.strain;
    state.row.clear();
  }

  double stableTimeStep() const override { return run_.stableTimeStep(); }

  void advance(double until) override
  {
    State<D>& state = run_.state();
    while (state.time < until && !state.ended())
    {
      const double dt = run_.stableTimeStep();
      const bool ends = state.time + dt >= until || state.step + 1 >= state.maximumSteps;
      const bool sample = interval > 0.0 && (ends || state.time + dt >= next_);
      run_.step(until, sample);
      if (sample)
      {
        // Samples missed by a long step are left out, not bunched up.
        while (next_ <= state.time)
          next_ += interval;
        Engine::last = state.row;
        if (observer)
          observer(state.time, state.row);
      }
      if (afterStep)
        afterStep(state.time, state.step);
    }
  }

  nlohmann::json report() const override
  {
    nlohmann::json summary = nlohmann::json::object();
    const State<D>& state = run_.state();
    summary["warnings"] = state.warnings;
    const std::string ofEnergy =
        run_.energyWatch().warning(state.picFraction > 0.0, state.step, state.subcycledLevels);
    if (!ofEnergy.empty() && state.trouble.empty())
      summary["warnings"].push_back(ofEnergy);
    coreReport(state, summary);
    bodyReport(state, summary);
    for (const Effect<D>& effect : run_.plan().effects)
      if (effect.report)
        effect.report(state, summary);
    return summary;
  }

  std::string plan() const override { return printPlan(run_.plan(), run_.state()); }

  std::map<std::string, double> stageSeconds() const override
  {
    std::map<std::string, double> seconds;
    for (int s = 0; s < numStages; ++s)
      if (!run_.plan().calls[s].empty())
        seconds[stageName(static_cast<Stage>(s))] = run_.plan().seconds[s];
    return seconds;
  }

  void writeFields(const std::string& folder) override
  {
    if (!writer_)
      writer_ = std::make_unique<FieldWriter<D>>(folder, run_.state().ranks);
    writer_->write(run_.state());
  }

  std::vector<std::string> effects() const override { return run_.effectNames(); }

  Progress progress() const override
  {
    const State<D>& state = run_.state();
    return {state.time, state.step, state.settled, state.ended(), allParticles(state), state.particleSteps};
  }

private:
  Run<D> run_;
  std::set<std::string> effects_;
  std::unique_ptr<FieldWriter<D>> writer_;
  double next_ = 0.0;
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
