#include "Simulation.hpp"

#include "SimulationEngine.hpp"
#include "base/OutputError.hpp"
#include "checkpoint/CheckpointFile.hpp"
#include "parallel/FirstRank.hpp"
#include "plan/EffectSchema.hpp"
#include "plan/KnownEffects.hpp"
#include "scene/Scene.hpp"

#include <sstream>
#include <stdexcept>

namespace Rhegma
{

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
    throw std::invalid_argument(
        alone + ": such scenes run on one rank only; start the program without mpirun, or with mpirun -np 1");
}

/// Throws std::invalid_argument with all errors, a line each, if there are any.
void throwAll(const std::vector<SceneError>& errors)
{
  std::string all;
  for (const SceneError& error : errors)
    all += (all.empty() ? "" : "\n") + toString(error);
  if (!errors.empty())
    throw std::invalid_argument(all);
}

} // namespace

Teuchos::RCP<Teuchos::ParameterList> Simulation::readScene(const std::string& file,
                                                           const std::vector<std::string>& overrides)
{
  const SceneResult result = Rhegma::readScene(file, overrides, effectSchema());
  throwAll(result.errors);
  return result.list;
}

Simulation::Simulation(Teuchos::RCP<const Teuchos::Comm<int>> comm,
                       const Teuchos::RCP<Teuchos::ParameterList>& scene, bool validated)
{
  std::vector<SceneError> errors;
  if (!validated)
    validateList(*scene, effectSchema(), errors);
  throwAll(errors);
  const Ranks ranks(comm);
  if (ranks.many())
    refuseOnRanks(*scene);
  // An application may change its list later.
  engine_ = Engine::make(validated ? scene : Teuchos::rcp(new Teuchos::ParameterList(*scene)), ranks);
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
  // All ranks read it: if one can't, none continues from it.
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
bool Simulation::continueFields(const std::string& folder, std::string* why)
{
  const std::string reason = engine_->continueFields(folder);
  if (why != nullptr)
    *why = reason;
  return reason.empty();
}
bool Simulation::continueFronts(const std::string& folder, std::string* why)
{
  const std::string reason = engine_->continueFronts(folder);
  if (why != nullptr)
    *why = reason;
  return reason.empty();
}
double Simulation::stepFraction() const { return engine_->stepFraction(); }
double Simulation::stableTimeStep() const { return engine_->stableTimeStep(); }
void Simulation::advance(double time) { engine_->advance(time); }
bool Simulation::trySolve(bool onlyLoads) { return engine_->trySolve(onlyLoads); }

void Simulation::sampleEvery(double interval, std::function<void(double, const Row&)> observer)
{
  engine_->interval = interval;
  engine_->observer = std::move(observer);
}

void Simulation::onIteration(std::function<void(int, double)> progress)
{
  engine_->onIteration = std::move(progress);
}
void Simulation::onStep(std::function<void(double, long)> progress)
{
  engine_->afterStep = std::move(progress);
}

bool Simulation::sampleNextStep()
{
  engine_->sampleNext = !engine_->sampled;
  return engine_->sampleNext;
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
nlohmann::json Simulation::report(std::size_t mostBodies) const { return engine_->report(mostBodies); }
void Simulation::writeFields(const std::string& folder) { engine_->writeFields(folder); }
void Simulation::writeFronts(const std::string& folder) { engine_->writeFronts(folder); }

} // namespace Rhegma
