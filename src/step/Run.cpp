#include "step/Run.hpp"

#include "base/Attempts.hpp"
#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "boundary/Boundaries.hpp"
#include "boundary/DomainEdges.hpp"
#include "material/Units.hpp"
#include "parallel/FirstRank.hpp"
#include "plan/EffectSchema.hpp"
#include "plan/KnownEffects.hpp"
#include "plausibility/Judges.hpp"
#include "scene/SceneParts.hpp"
#include "state/EnergySums.hpp"
#include "state/MovingCells.hpp"
#include "state/StateArchive.hpp"
#include "state/Subdomain.hpp"
#include "step/CoreStep.hpp"
#include "step/LevelsOfCells.hpp"
#include "step/Preload.hpp"
#include "step/RunStage.hpp"
#include "step/Setup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma
{

namespace
{

template <int D>
Effect<D> makeEffect(const EffectEntry& entry, const Teuchos::ParameterList& part, const RunOptions& options)
{
  if constexpr (D == 2)
    return entry.make2(part, options);
  else
    return entry.make3(part, options);
}

/// A line for each material of odd wave speed, which steps that are too many may come from.
template <int D>
std::string oddMaterials(const State<D>& state)
{
  std::string lines;
  if (state.method.mechanics)
    for (const std::string& line : warningsOfUnits(state.materials.names, state.materials.properties))
      lines += "\n" + line;
  return lines;
}

/// Throws std::invalid_argument where bodies have a mass with which nothing can be computed.
template <int D>
void refuseSenselessMass(const State<D>& state)
{
  const auto mass = state.particles.scalar(fields::mass);
  double all = 0.0, least = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::massOfBodies", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& sum, double& smallest) {
        sum += mass(p);
        smallest = mass(p) < smallest ? mass(p) : smallest;
      },
      all, Kokkos::Min<double>(least));
  if (std::isfinite(all) && least > 0.0)
    return;
  const double thickness = state.method.thickness;
  throw std::invalid_argument(
      (thickness == 1.0 ? std::string("Materials") : "Domain > Thickness is " + formatReal(thickness)) +
      ": the mass of the bodies is zero or not finite; check exponents and units (m, kg/m3)");
}

/// Largest number of steps; the default of Time > Maximum Steps.
constexpr double mostSteps = 2e9;

/// Whether effects may load or move the bodies of a scene, or one of an application is there that may.
bool isDrivenByEffects(const Teuchos::ParameterList& scene, const RunOptions& options, bool own)
{
  const std::vector<EffectEntry>& known = knownEffects();
  const auto added = known.begin() + static_cast<std::ptrdiff_t>(builtInEffects().size());
  return own || options.heat() || options.toolsPress || options.burning || !options.pressedCracks.empty() ||
         std::any_of(added, known.end(),
                     [&](const EffectEntry& entry) { return scene.isSublist(entry.section.name); });
}

} // namespace

template <int D>
Run<D>::Run(const Teuchos::ParameterList& scene, std::vector<Effect<D>> own, const Ranks& ranks)
    : Run(Teuchos::rcp(new Teuchos::ParameterList(scene)), std::move(own), ranks)
{
}

template <int D>
Run<D>::Run(const Teuchos::RCP<Teuchos::ParameterList>& scene, std::vector<Effect<D>> own, const Ranks& ranks)
    : scene_(scene), own_(std::move(own))
{
  state_.ranks = ranks;
}

template <int D>
void Run<D>::initialize()
{
  // A single rank may fail, for example for lack of memory: then all stop.
  onEachRank(state_.ranks, [&] { makeAll({}); });
  divideState(state_);
}

template <int D>
std::vector<Effect<D>> Run<D>::makeEffects(const RunOptions& options, std::vector<Field>& extra)
{
  std::vector<Effect<D>> effects;
  SceneParts parts(effectSchema(), *scene_);
  for (const EffectEntry& entry : knownEffects())
    if (scene_->isSublist(entry.section.name))
      effects.push_back(makeEffect<D>(entry, parts.of(entry.section.name), options));
  effects.insert(effects.end(), own_.begin(), own_.end());
  for (const Effect<D>& effect : effects)
    extra.insert(extra.end(), effect.adds.begin(), effect.adds.end());
  return effects;
}

template <int D>
void Run<D>::makeAll(const IsDivided<D>& isDivided)
{
  RunOptions options = declaredOptions(*scene_);
  if (motion_)
  {
    options.motion = motion_->options;
    state_.clock.stepOfMotion = motion_->step;
    state_.mesh.subcycledLevels = motion_->subcycledLevels;
  }
  state_.method.mechanics = options.mechanics;
  std::vector<Field> extra;
  std::vector<Effect<D>> effects = makeEffects(options, extra);
  makeParticles(extra, effects, isDivided);
  for (const Effect<D>& effect : effects)
    for (const NodalField& field : effect.addsNodal)
      state_.mesh.nodalFields.add(field);
  effects.insert(effects.begin(), makeCore(state_, equilibrium_.last()));
  Effect<D> boundaries = makeBoundaries<D>(*scene_, options.adaptive);
  if (!boundaries.calls.empty() || boundaries.report) // surfaces that only heat uses are reported
    effects.insert(effects.begin() + 1, std::move(boundaries));
  // Without constraints, calls that read the constrained motion get the solved one.
  plan_ = makePlan<D>(std::move(effects));
  order_ = stageOrder(state_.method.scheme);
  // Boundaries depend on the bodies only, so their errors are reported with those of the first effect; later
  // effects may depend on earlier ones.
  Attempts attempts;
  bool on = true; // whether all effects have started, which the stages of a step need
  for (const Effect<D>& effect : plan_.effects)
  {
    if (effect.atStart && on)
      on = attempts.attempt([&] { effect.atStart(state_); }) || effect.name == boundariesName;
    if (!isDivided && attempts.succeeded() && state_.mesh.tree.refined() && haveCutParticles(state_))
      return makeAllForRefinedCells();
  }
  if (state_.method.mechanics)
  {
    state_.clock.fastestSpeed = fastestSpeed(state_);
    for (const auto& found :
         {warningsOfUnits(state_.materials.names, state_.materials.properties), warningsOfEdges<D>(*scene_)})
      state_.warnings.insert(state_.warnings.end(), found.begin(), found.end());
  }
  if (state_.method.equilibrium())
  {
    if (options.loadFactor)
      state_.method.analysis = Analysis::LoadFactor;
    equilibrium_.start(*scene_);
    if (on)
      attempts.attempt([&] { equilibrium_.inspect(*scene_, plan_, state_); });
  }
  if (on && scene_->sublist("Time").get<std::string>("Initial State") != initialState::unloaded)
    attempts.attempt([&] { preload(options); });
  attempts.attempt([&] { refuseSenselessMass(state_); });
  const bool ends = attempts.attempt([&] { refuseEndless(); });
  if (attempts.succeeded())
    return judge(stableTimeStep(), options, [](const auto& judgment) { judgment(); });
  const double alone = state_.method.mechanics && !state_.method.equilibrium() && ends
                           ? stepOfWaves()
                           : std::numeric_limits<double>::quiet_NaN();
  Attempts hidden; // errors that follow from those that are said
  judge(alone, options, [&](const auto& judgment) { hidden.attempt(judgment); });
  attempts.throwIfAny(state_.warnings);
}

template <int D>
void Run<D>::makeAllForRefinedCells()
{
  const IsDivided<D> isDivided = dividedByCells(state_);
  const Ranks ranks = state_.ranks;
  state_ = State<D>();
  state_.ranks = ranks;
  makeAll(isDivided);
}

template <int D>
void Run<D>::makeParticles(const std::vector<Field>& extra, const std::vector<Effect<D>>& effects,
                           const IsDivided<D>& isDivided)
{
  const auto rules = [&](const State<D>& state)
  {
    SeedRules<D> all{isDivided, {}};
    for (const Effect<D>& effect : effects)
      if (effect.cuts)
        all.cuts = effect.cuts(state); // of the one effect that has surfaces in bodies
    return all;
  };
  Attempts attempts, hidden;
  state_.mesh.grid.spacing = 0.0; // until there are cells
  if (attempts.attempt([&] { makeState<D>(*scene_, extra, state_, rules); }))
    return;
  if (state_.mesh.grid.spacing > 0.0)
    hidden.attempt([&] { judgeWithoutParticles(*scene_, state_); });
  attempts.throwIfAny(state_.warnings);
}

template <int D>
template <class Attempt>
void Run<D>::judge(double step, const RunOptions& options, const Attempt& attempt)
{
  for (const Effect<D>& effect : plan_.effects)
    if (effect.judge)
      attempt([&] { effect.judge(state_); });
  const bool driven = isDrivenByEffects(*scene_, options, !own_.empty());
  attempt([&] { judgeScene(*scene_, step, driven, options.facePressures, state_); });
}

template <int D>
void Run<D>::preload(const RunOptions& options)
{
  // The first cells of the run, which the particles then are of.
  plan_.run(Stage::BetweenSteps, state_);
  moveNodalFields(state_);
  const MotionToCome motion{std::make_shared<RunOptions>(options), stableTimeStep(),
                            state_.mesh.subcycledLevels};
  startInEquilibrium(*scene_, motion, plan_, state_);
  state_.clock.fastestSpeed = fastestSpeed(state_);
}

template <int D>
void Run<D>::refuseEndless() const
{
  if (state_.method.mechanics &&
      (!std::isfinite(state_.clock.fastestSpeed) || !(state_.clock.fastestSpeed > 0.0)))
    throw std::invalid_argument("Materials: the speed of waves and particles is not finite and positive; "
                                "check stiffness, density and the velocity of bodies (SI units)" +
                                oddMaterials(state_));
  const Teuchos::ParameterList& time = scene_->sublist("Time");
  const bool moves = state_.method.handsOver; // at last
  const char* const length = moves && time.isParameter("Dynamic Time") ? "Dynamic Time" : "Final Time";
  const double step = moves ? stepOfWaves() : stableTimeStep();
  const double steps = time.get<double>(length) / step;
  // A scene that limits its steps is accepted.
  if (steps <= mostSteps || time.get<int>("Maximum Steps") < mostSteps)
    return;
  throw std::invalid_argument(
      std::string("Time > ") + length + ": the run would take " +
      (std::isfinite(steps) ? "about " + formatReal(std::round(steps)) : "endlessly many") + " steps of " +
      formatReal(step) +
      " s; write a shorter time, larger cells or fewer Maximum Steps, and check that "
      "materials are in SI units" +
      oddMaterials(state_));
}

template <int D>
double Run<D>::stableTimeStep() const
{
  if (state_.method.equilibrium())
    return equilibrium_.next();
  double dt = state_.method.mechanics ? stepOfWaves() : std::numeric_limits<double>::infinity();
  for (const Effect<D>& effect : plan_.effects)
    if (effect.timeStepLimit)
      dt = std::min(dt, effect.timeStepLimit(state_));
  return stepFraction_ * dt;
}

template <int D>
void Run<D>::strainBeforeForces()
{
  state_.clock.strainPass = {0.5, true};
  for (const Stage stage : {Stage::AfterProjection, Stage::OnParticles})
    plan_.runPass(stage, state_);
  state_.clock.strainPass = {0.5, false};
}

template <int D>
bool Run<D>::trySolve(bool onlyLoads)
{
  if (!state_.method.equilibrium())
    return false;
  equilibrium_.trySolve(plan_, state_, onlyLoads);
  return true;
}

template <int D>
void Run<D>::observe()
{
  state_.sample.row.clear();
  if (beforeObserve)
    beforeObserve(state_);
  plan_.run(Stage::Observe, state_);
  if (state_.method.equilibrium())
    energyWatch_.sampleOfEquilibrium(state_.energy, anyEnded(state_.cracks), errorOfThermalPath(state_));
  else
    energyWatch_.sample(state_.energy, anyEnded(state_.cracks));
  if (state_.failure.empty())
    state_.failure = energyWatch_.failure(state_.mesh.subcycledLevels);
  if (!state_.failure.empty())
    stopRun(state_);
}

template <int D>
void Run<D>::step(double until, bool sample)
{
  state_.clock.observing = sample;
  if (state_.method.equilibrium())
    equilibrium_.take(plan_, state_, until);
  else
    explicitStep(std::min(until, state_.clock.lastTime));
  if (state_.cracks.growth.unstable.found) // the step is not kept
    return;
  if (sample)
    observe();
}

template <int D>
void Run<D>::explicitStep(double until)
{
  const double left = until - state_.clock.time;
  moveCells(state_);
  // First, because the step depends on the cells.
  runStage(plan_, state_, Stage::BetweenSteps);
  moveNodalFields(state_);
  state_.clock.dt = stableTimeStep();
  if (!(state_.clock.dt > 0.0) || !std::isfinite(state_.clock.dt))
  {
    state_.failure = "the stable step is not a positive number";
    stopRun(state_);
  }
  // The remaining time is divided evenly between the last two steps, so that none is tiny.
  if (state_.clock.dt >= left)
    state_.clock.dt = left;
  else if (2.0 * state_.clock.dt > left)
    state_.clock.dt = 0.5 * left;
  for (const Stage stage : order_)
    if (stage != Stage::Observe && stage != Stage::BetweenSteps)
    {
      runStage(plan_, state_, stage);
      if (stage == Stage::Scatter && state_.method.scheme == UpdateScheme::Usavg)
        strainBeforeForces();
    }
  agree(state_);
  state_.clock.time = state_.clock.dt == left ? until : state_.clock.time + state_.clock.dt;
  ++state_.clock.step;
  state_.particles.particleSteps += allParticles(state_);
}

template <int D>
void Run<D>::limitMotion()
{
  const Teuchos::ParameterList& time = scene_->sublist("Time");
  if (state_.cracks.growth.motionFrom >= 0.0 && time.isParameter("Dynamic Time"))
    state_.clock.lastTime = state_.cracks.growth.motionFrom + time.get<double>("Dynamic Time");
}

template <int D>
void Run<D>::startMotion()
{
  Kokkos::deep_copy(state_.particles.table(fields::velocity), 0.0);
  state_.clock.settled = false;
  state_.clock.fastestSpeed = state_.ranks.max(fastestSpeed(state_));
  state_.cracks.growth.motionFrom = state_.clock.time;
  limitMotion();
}

template <int D>
void Run<D>::serialize(Archive& archive)
{
  archiveState(state_, archive);
  archiveNodalFields(state_, archive);
  {
    const Archive::Group group(archive, "run");
    archive("stage_seconds", plan_.seconds);
    archive("step_fraction", stepFraction_);
    if (state_.method.equilibrium())
      archive("load_step", equilibrium_.next());
  }
  {
    const Archive::Group group(archive, "run/energy watch");
    energyWatch_.serialize(archive);
  }
  for (const Effect<D>& effect : plan_.effects)
    if (effect.memory)
    {
      const Archive::Group group(archive, "effects/" + effect.name);
      effect.memory(state_, archive);
    }
  if (archive.loads())
    limitMotion();
}

template <int D>
std::vector<std::string> Run<D>::effectNames() const
{
  std::vector<std::string> names;
  for (const EffectEntry& entry : knownEffects())
    if (scene_->isSublist(entry.section.name))
      names.push_back(entry.section.name);
  return names;
}

template class Run<2>;
template class Run<3>;

} // namespace Rhegma
