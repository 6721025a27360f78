#pragma once
/// Equilibrium as calls of the stages.

#include "equilibrium/SolverChoice.hpp"
#include "plan/Effect.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Rhegma::equilibrium
{

/// What the calls of a step leave for the loop.
struct LastStep
{
  bool inPlace = false; ///< set by the loop: the step adds no load to the one before, whose matrix serves it
  bool freePiecesAreNew = false; ///< whether all pieces that are free were held or joined when the run began
  bool trial = false;            ///< set by the loop: one iteration is done, to learn what it costs
  bool onlyLoads = false;        ///< of a trial: no iteration is done, to learn whether the loads balance
  /// Set by the loop: forces out of balance, as a fraction of all, that need no iteration.
  double enough = 0.0;
  /// Set by the loop: gets number and residual of an iteration before it, as NewtonStep::onIteration.
  std::function<void(int, double)> onIteration;
  SolverChoice solverChoice = SolverChoice::Automatic; ///< set by the loop: what the scene asks for
  bool converged = false;
  int iterations = 0;
  std::vector<double> residuals; ///< fractions of the forces, before each iteration and after the last
  int unknowns = 0;
  std::optional<int> negativeEigenvalues{}; ///< of the last matrix (LinearAnswer)
  std::string unsolvable;      ///< why a linear system of the step was not solved, where smaller loads do not
                               ///< help; else empty
  std::string solver = "none"; ///< of the linear systems
  std::string reason;          ///< what keeps the step from equilibrium, where that is known; else empty
  double matrixBytes = 0.0;
  double workOfSupports = 0.0; ///< over the step, this rank's part [J]
  double motion = 0.0;         ///< largest displacement of a node over the step [smallest cells]
  double shorter = 0.5;        ///< part of a step that was not solved with which to try again
  double bentMotion = 0.0;     ///< of the last try of a step that bends too far [smallest cells]; 0: none
};

/// The calls of a step of equilibrium: the nodes' displacement over the step is solved for by Newton's method
/// with the consistent tangents of the particles' laws, and goes to the particles as a velocity, displacement
/// over length of the step, through the same transfer as in dynamics. Momentum and kinetic energy are zero.
/// The displacement of a step is from the configuration at its start (updated Lagrangian).
template <int D>
Effect<D> makeEquilibrium(const std::shared_ptr<LastStep>& last);

/// Numbers the unknowns of a state with stencils and supports. Throws std::invalid_argument where bodies can
/// move freely and the scene refuses that, with their names and motions.
/// \param last gets the number of unknowns and the memory of their matrix
template <int D>
void inspect(const Teuchos::ParameterList& scene, const State<D>& state, LastStep& last);

} // namespace Rhegma::equilibrium
