#pragma once
/// The steps of an analysis of equilibrium.

#include "equilibrium/EquilibriumCore.hpp"
#include "plan/Plan.hpp"
#include "step/FollowPath.hpp"

#include <functional>
#include <memory>
#include <utility>

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

/// Takes the steps of equilibrium of a run: calls the stages of its plan as often as a step needs. Throws
/// RunError where there is no equilibrium.
template <int D>
class EquilibriumSteps
{
public:
  /// What the last solution was, which the core's call of the plan writes.
  const std::shared_ptr<equilibrium::LastStep>& last() const { return last_; }

  /// \sa equilibrium::LastStep::onIteration
  void onIteration(std::function<void(int, double)> iteration) { last_->onIteration = std::move(iteration); }

  /// Sets the lengths of steps, and the solver.
  void start(const Teuchos::ParameterList& scene);

  /// Length of the next step [s]; saved with the run.
  double& next() { return steps_.next; }
  double next() const { return steps_.next; }

  /// Refuses what has no equilibrium. Throws std::invalid_argument.
  void inspect(const Teuchos::ParameterList& scene, Plan<D>& plan, State<D>& state);

  /// Solves the first linear system of the next step, which is not taken.
  /// \param onlyLoads solves nothing, and only warns of loads on free bodies that do not balance
  void trySolve(Plan<D>& plan, State<D>& state, bool onlyLoads = false);

  /// Takes a step, not beyond `until`, but for its sample. Where that finds unstable growth which motion
  /// follows (EquilibriumGrowth::unstable), the state is of no use afterwards. Throws StopRequested where the
  /// process is asked to stop meanwhile: time and number of the step are then those at its start, and the
  /// particles are anywhere.
  void take(Plan<D>& plan, State<D>& state, double until);

private:
  /// The stages of a step, for those that solve several times.
  EquilibriumCalls calls(Plan<D>& plan, State<D>& state);
  /// Takes a step to its end.
  void takeWhole(Plan<D>& plan, State<D>& state, double until);
  /// Solves for an increment of at most the remaining time, a shorter one where that fails.
  void solve(Plan<D>& plan, State<D>& state, double left);
  /// Warns once where steps have become so short that the run may seem to stand still.
  void warnOfShortSteps(State<D>& state);
  /// EquilibriumCalls::settle.
  bool settleWhereNeeded(Plan<D>& plan, State<D>& state);
  /// Solves once more without a new load, from the configuration that the last step has led to, so that the
  /// end does not depend on the cells that the particles were in before. Where that fails nothing changes.
  void settleInPlace(const EquilibriumCalls& calls, State<D>& state);
  /// Runs a function while the clock stands a tiny step before the end of the last one, which adds no load.
  void withoutNewLoads(State<D>& state, const std::function<void()>& solve);

  LoadSteps<D> steps_;
  double largestEnergy_ = 0.0;      ///< strain energy and work of loads, of this part of the run [J]
  bool warnedOfSettling_ = false;   ///< not stored: a run that continues says it again
  bool warnedOfShortSteps_ = false; ///< as before
  std::shared_ptr<equilibrium::LastStep> last_ = std::make_shared<equilibrium::LastStep>();
};

} // namespace Rhegma
