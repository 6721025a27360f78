#pragma once
/// A scene in motion.

#include "base/RunError.hpp"
#include "plan/Plan.hpp"
#include "step/EnergyWatch.hpp"

#include <functional>
#include <limits>

namespace Rhegma
{

/// Owns the state and the plan, and steps them.
template <int D>
class Run
{
public:
  /// \param scene a validated scene
  /// \param own   effects that the application brings next to those of the scene, such as a load of its own
  /// \param ranks that share the run: `initialize` and `step` are then collective
  explicit Run(const Teuchos::ParameterList& scene, std::vector<Effect<D>> own = {}, const Ranks& ranks = {});

  /// Makes particles, fields and the plan. Throws std::invalid_argument for what only the bodies can show
  /// wrong.
  void initialize();

  /// The step that would be taken now [s].
  double stableTimeStep() const;

  /// Fraction of the stable step that is taken, 1 at the start; kept with the state.
  double stepFraction() const { return stepFraction_; }
  void setStepFraction(double share) { stepFraction_ = share; }

  /// One step, not beyond `until`. The step ends with a sample when `sample` is set.
  /// Throws RunError when the run can't go on.
  void step(double until, bool sample);

  /// Saves or loads all that the run keeps from step to step. Load after initialize().
  void keep(Archive& archive);

  State<D>& state() { return state_; }
  const State<D>& state() const { return state_; }
  const Plan<D>& plan() const { return plan_; }
  const EnergyWatch& energyWatch() const { return energyWatch_; }

  /// Called in a sample before the Observe stage, to fill the row with the energies.
  std::function<void(State<D>&)> beforeObserve;

  /// Names of the effects of this scene.
  std::vector<std::string> effectNames() const;

private:
  void makeAll();
  void refuseEndless() const;
  /// Makes what ranks must know of each other before the next step the same on all: the fastest speed,
  /// whether somebody must sort, and why the run can't go on. Throws RunError where it can't.
  void agree();
  /// The first of two passes that strain (USAVG).
  void strainBeforeForces();
  /// Throws RunError where the stage brings failure; where there are many ranks that waits for `agree`.
  void runStage(Stage stage);

  Teuchos::ParameterList scene_;
  std::vector<Effect<D>> own_;
  State<D> state_;
  Plan<D> plan_;
  std::vector<Stage> order_;
  EnergyWatch energyWatch_;
  double stepFraction_ = 1.0;
};

} // namespace Rhegma
