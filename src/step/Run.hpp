#pragma once
/// The time loop of a scene.

#include "base/RunError.hpp"
#include "geometry/Seeds.hpp"
#include "plan/Plan.hpp"
#include "plan/RunOptions.hpp"
#include "step/EnergyWatch.hpp"
#include "step/EquilibriumSteps.hpp"

#include <functional>
#include <optional>
#include <utility>

namespace Rhegma
{

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

  /// Makes this a run of the equilibrium in which a motion starts, which has the laws of that motion. To be
  /// called before initialize().
  void startsMotion(MotionToCome motion) { motion_ = std::move(motion); }

  /// The stable step of the current state [s].
  double stableTimeStep() const;

  /// Fraction of the stable step that is used, 1 at the start; saved with the state.
  double stepFraction() const { return stepFraction_; }
  void setStepFraction(double fraction) { stepFraction_ = fraction; }

  /// One step, not beyond `until`. The step ends with a sample when `sample` is set.
  /// Throws RunError when the run can't go on.
  void step(double until, bool sample);

  /// Of an analysis of equilibrium: solves the first linear system of the next load step, which is not taken,
  /// so that its cost can be measured. Throws RunError. \param onlyLoads solves nothing, and only warns of
  /// loads on free bodies that do not balance \return whether this is such an analysis
  bool trySolve(bool onlyLoads = false);

  /// \sa equilibrium::LastStep::onIteration
  void onIteration(std::function<void(int, double)> iteration)
  {
    equilibrium_.onIteration(std::move(iteration));
  }

  /// Goes on as motion, at rest, from a loaded state of equilibrium.
  void startMotion();

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
  /// \param isDivided of the cells that are refined at the start
  void makeAll(const IsDivided<D>& isDivided);

  /// Makes all anew, with particles at the edges of bodies that suit the cells, which have been refined.
  void makeAllForRefinedCells();
  /// Throws std::invalid_argument with the warnings that need no particles.
  void makeParticles(const std::vector<Field>& extra, const std::vector<Effect<D>>& effects,
                     const IsDivided<D>& isDivided);
  /// Adds warnings of wrong physics. \param step first stable step [s] \param driven whether effects may load
  /// or move bodies \param attempt gets each judgment and calls it
  template <class Attempt>
  void judge(double step, const RunOptions& options, const Attempt& attempt);
  /// The effects of the scene and of the application. \param extra gets their fields of particles
  std::vector<Effect<D>> makeEffects(const RunOptions& options, std::vector<Field>& extra);
  /// Starts in equilibrium. Throws std::invalid_argument.
  void preload(const RunOptions& options);
  void refuseEndless() const;
  /// Sets the end of motion that has followed an equilibrium.
  void limitMotion();
  /// The stable step of motion, by waves alone [s].
  double stepOfWaves() const
  {
    return state_.method.cfl * state_.mesh.stepSpacing() / state_.clock.fastestSpeed;
  }
  /// The first of two passes that strain (USAVG).
  void strainBeforeForces();
  /// A step of the explicit method, but for its sample.
  void explicitStep(double until);
  /// Takes a sample.
  void observe();

  Teuchos::RCP<Teuchos::ParameterList> scene_;
  std::vector<Effect<D>> own_;
  std::optional<MotionToCome> motion_;
  State<D> state_;
  Plan<D> plan_;
  std::vector<Stage> order_;
  EnergyWatch energyWatch_;
  double stepFraction_ = 1.0;
  EquilibriumSteps<D> equilibrium_;
};

} // namespace Rhegma
