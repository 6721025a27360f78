#pragma once
/// The time loop of a scene.

#include "base/RunError.hpp"
#include "equilibrium/EquilibriumCore.hpp"
#include "geometry/Seeds.hpp"
#include "plan/Plan.hpp"
#include "step/EnergyWatch.hpp"
#include "step/FollowPath.hpp"

#include <functional>
#include <limits>

namespace Rhegma
{

/// Lengths of steps of equilibrium [s]. A step that is not solved is halved; steps grow again after easy
/// ones.
template <int D>
struct LoadSteps
{
  static constexpr int easy = 6;                   ///< iterations up to which the next step is longer
  static constexpr double smallest = 1.0 / 4096.0; ///< part of the largest step at which the run stops
  double largest = 0.0, next = 0.0;

  LoadSteps() = default;
  explicit LoadSteps(const Teuchos::ParameterList& scene);
};

/// Owns the state and the plan, and advances them by steps.
template <int D>
class Run
{
public:
  /// \param scene a validated scene
  /// \param own   effects of the application in addition to those of the scene, such as its own load
  /// \param ranks of the run: `initialize` and `step` are collective
  explicit Run(const Teuchos::ParameterList& scene, std::vector<Effect<D>> own = {}, const Ranks& ranks = {});
  /// \param scene is shared and must not change while this exists
  explicit Run(const Teuchos::RCP<Teuchos::ParameterList>& scene, std::vector<Effect<D>> own = {},
               const Ranks& ranks = {});

  /// Makes particles, fields and the plan. Throws std::invalid_argument for errors that depend on the bodies.
  void initialize();

  /// The stable step of the current state [s].
  double stableTimeStep() const;

  /// Fraction of the stable step that is used, 1 at the start; saved with the state.
  double stepFraction() const { return stepFraction_; }
  void setStepFraction(double fraction) { stepFraction_ = fraction; }

  /// One step, not beyond `until`. The step ends with a sample when `sample` is set.
  /// Throws RunError when the run can't go on.
  void step(double until, bool sample);

  /// Of an analysis of equilibrium: solves the first linear system of the next load step, which is not taken,
  /// so that its cost can be measured. Throws RunError. \return whether this is such an analysis
  bool trySolve();

  /// Saves or loads all persistent data of the run. Load after initialize().
  void serialize(Archive& archive);

  State<D>& state() { return state_; }
  const State<D>& state() const { return state_; }
  const Plan<D>& plan() const { return plan_; }
  const EnergyWatch& energyWatch() const { return energyWatch_; }

  /// Called in a sample before the Observe stage, to fill the row with the energies.
  std::function<void(State<D>&)> beforeObserve;

  /// Names of the effects of this scene.
  std::vector<std::string> effectNames() const;

private:
  /// \param isDivided for makeState
  void makeAll(const IsDivided<D>& isDivided);

  /// Makes all anew, with particles at the edges of bodies that suit the cells, which have been refined.
  void makeAllForRefinedCells();
  /// Throws std::invalid_argument with the warnings that need no particles.
  void makeParticles(const std::vector<Field>& extra, const IsDivided<D>& isDivided);
  /// Adds warnings of wrong physics. \param step first stable step [s] \param driven whether effects may load
  /// or move bodies \param attempt gets each judgment and calls it
  template <class Attempt>
  void judge(double step, bool driven, const Attempt& attempt);
  /// The effects of the scene and of the application. \param extra gets their fields of particles
  std::vector<Effect<D>> makeEffects(const RunOptions& options, std::vector<Field>& extra);
  /// Starts in equilibrium. Throws std::invalid_argument.
  void preload();
  void refuseEndless() const;
  /// Reduces over the ranks what they need for the next step: the fastest speed, whether to sort, and a
  /// failure. Throws RunError on failure.
  void agree();
  /// The first of two passes that strain (USAVG).
  void strainBeforeForces();
  /// Throws RunError where the stage fails; with several ranks the failure waits for `agree`.
  void runStage(Stage stage);
  /// Takes a sample.
  void observe();

  /// Refuses what has no equilibrium. Throws std::invalid_argument.
  void inspectEquilibrium();
  void stepOfEquilibrium(double until, bool sample);
  /// The stages of a step of equilibrium, for steps that solve several times.
  EquilibriumCalls equilibriumCalls();
  /// Solves once more without a new load, from the configuration that the last step has led to, so that the
  /// end does not depend on the cells that the particles were in before. Where that fails nothing changes.
  void settleInPlace();
  /// The loop that grows cracks under the loads of the time that the step has led to.
  void growInPlace();
  /// Runs a function while the clock stands a tiny step before the end of the last one, which adds no load.
  void withoutNewLoads(const std::function<void()>& solve);
  /// Solves for an increment of at most the remaining time, a shorter one where that fails.
  void solveLoadStep(double left);

  Teuchos::RCP<Teuchos::ParameterList> scene_;
  std::vector<Effect<D>> own_;
  State<D> state_;
  Plan<D> plan_;
  std::vector<Stage> order_;
  EnergyWatch energyWatch_;
  double stepFraction_ = 1.0;
  LoadSteps<D> loadSteps_;
  std::shared_ptr<equilibrium::LastStep> lastEquilibrium_ = std::make_shared<equilibrium::LastStep>();
};

} // namespace Rhegma
