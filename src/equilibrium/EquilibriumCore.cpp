#include "equilibrium/EquilibriumCore.hpp"

#include "archive/Archive.hpp"
#include "base/Counted.hpp"
#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "equilibrium/Newton.hpp"
#include "state/ContactAdvice.hpp"
#include "state/FaceLoads.hpp"
#include "state/Subdomain.hpp"
#include "transfer/Gather.hpp"
#include "transfer/Scatter.hpp"
#include "transfer/Stencils.hpp"
#include "transfer/StressInBlocks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <stdexcept>

namespace Rhegma::equilibrium
{

namespace
{

/// Fraction of the loads on a free body that inertia forces may balance without a warning.
constexpr double noticeableResultant = 0.01;

/// Fraction of the forces that may act on unsupported pieces without a warning: their weight, at most.
constexpr double noticeableLoad = 1e-3;

/// A number of the matrix in blocks, its copy with its column for the solver.
constexpr double bytesPerEntry = 2 * sizeof(double) + 2 * sizeof(int);

template <int D>
void toNodes(State<D>& state)
{
  storeStencils(state);
  clearNodes(state);
  Kokkos::deep_copy(state.mesh.nodes.motion, 0.0);
  scatter(state, ScatterWhat::MassAndMomentum);
  sumOverRanks(state, SharedSums::MassAndMomentum);
}

/// Leaves the displacement as a velocity, and the forces of supports in place of those on nodes.
template <int D>
void toMotion(const NewtonStep<D>& step, State<D>& state)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const RowGraph& graph = step.graph();
  const Values &displacement = step.displacement(), &reaction = step.reaction();
  const double perTime = 1.0 / state.clock.dt;
  Kokkos::parallel_for(
      "rhegma::equilibrium::motion", Kokkos::RangePolicy<ExecSpace>(0, graph.rows),
      KOKKOS_LAMBDA(const int r) {
        const int n = graph.nodeOf(r);
        for (int d = 0; d < D; ++d)
        {
          nodes.motion(n, d) = nodes.projection(n, d) = perTime * displacement(D * r + d);
          nodes.motion(n, Nodes<D>::accelerationAt + d) = 0.0;
          nodes.sums(n, Nodes<D>::forceAt + d) = reaction(D * r + d);
        }
      });
}

/// Largest displacement of a node along an axis [smallest cells]: by so much particles move through cells.
template <int D>
double largestMotion(const NewtonStep<D>& step, const State<D>& state)
{
  // In undeformed cells only forces on faces depend on where these are now.
  if (state.method.totalLagrangian && !loadsFollowFaces(state))
    return 0.0;
  const Values& u = step.displacement();
  double largest = 0.0;
  for (std::size_t k = 0; k < u.extent(0); ++k)
    largest = std::max(largest, std::fabs(u(k)));
  return state.ranks.max(largest) / state.mesh.smallestSpacing();
}

/// What the effect stores between steps, for its report and for the next step.
template <int D>
struct Account
{
  long iterations = 0, linearIterations = 0;
  int unsupportedFields = 0;
  double largestForces = 0.0; ///< of the run: norm of the loads or of the supports' forces [N]
  bool warned = false, warnedOfPieces = false;
  bool started = false;                    ///< not stored: used in the first step only
  bool warnedOfCut = false;                ///< not stored: a run that continues says it again
  bool warnedOfRounding = false;           ///< not stored either
  bool warnedOfInstability = false;        ///< not stored either
  std::shared_ptr<LinearSystem<D>> system; ///< of the last step
};

/// Solves a step. Other steps than those in place begin anew, so that a restarted run has the same ones.
template <int D>
StepReport solveOnce(State<D>& state, Account<D>& account, const LastStep& last, Boxes boxes,
                     std::unique_ptr<NewtonStep<D>>& step)
{
  step.reset(); // large: not two of them
  step = std::make_unique<NewtonStep<D>>(state, last.inPlace ? account.system : nullptr, boxes,
                                         last.solverChoice);
  account.system = step->system();
  step->onIteration(last.onIteration);
  const int most = last.onlyLoads ? 0 : last.trial ? 1 : mostIterations;
  return step->solve(state, account.largestForces, most, last.enough);
}

/// Why pieces that have come free have no equilibrium; empty if they have one.
template <class IsNew>
std::string failureOfFreePieces(const StepReport& report, const IsNew& isNew)
{
  for (const FreePiece& piece : report.freePieces)
    if (isNew(piece) && piece.imbalance.fraction() > noticeableResultant)
      return piece.name() + " has come off its supports and " + piece.motions +
             ", and its loads do not balance: " + piece.imbalance.asText(noticeableResultant) +
             " remains, so there is no equilibrium; support this part (Boundaries), end the run before (Time "
             "> "
             "Final Time), or compute its motion with Time > Analysis = Dynamic";
  return {};
}

/// Whether contact of crack faces could hold pieces, and is not there.
template <int D>
bool lacksContact(const State<D>& state)
{
  return !state.cracks.empty() && !state.cracks.contactEnergy;
}

/// What of the loads on a free piece does not balance, under all of them where they rise in proportion.
template <int D>
std::string imbalanceAsText(const FreePiece& piece, const State<D>& state)
{
  const Clock& clock = state.clock;
  const bool hasFactor = state.method.analysis == Analysis::LoadFactor;
  const bool inProportion = hasFactor || state.method.analysis == Analysis::Static;
  const double part = hasFactor ? clock.factor.end : (clock.time + clock.dt) / clock.finalTime;
  Imbalance all = piece.imbalance;
  if (!inProportion || !(part > 0.0))
    return all.asText(noticeableResultant) + " at t = " + readableTime(clock.time + clock.dt);
  all.force /= part;
  all.moment /= part;
  return all.asText(noticeableResultant) + " under the loads of Time > Final Time";
}

/// Warns, once, of an equilibrium that is known no better than rounding of the stress allows.
template <int D>
void warnOfRounding(const StepReport& report, State<D>& state, Account<D>& account)
{
  if (report.residuals.back() > roundingOfForces && !account.warnedOfRounding)
  {
    account.warnedOfRounding = true;
    state.warnings.push_back(
        "Time > Analysis: the residual of an equilibrium stays at " + formatShort(report.residuals.back()) +
        " of the forces, because they are hardly larger than rounding of the stress; displacements, stress, "
        "K "
        "and G are no better known than that, and may be known much worse: use larger loads (results of a "
        "linear body are in proportion to them) or supports that move the bodies less");
  }
}

/// Warns, once, of an equilibrium in which bodies do not stay.
template <int D>
void warnOfInstability(const StepReport& report, const std::string& solver, State<D>& state,
                       Account<D>& account)
{
  if (report.negativeEigenvalues.value_or(0) == 0 || account.warnedOfInstability)
    return;
  const bool counts = solver.rfind("direct", 0) == 0;
  account.warnedOfInstability = true;
  state.warnings.push_back(
      "Time > Analysis: the equilibrium at t = " + readableTime(state.clock.time + state.clock.dt) +
      " is unstable: the stiffness has " + (counts ? "" : "at least ") +
      counted(*report.negativeEigenvalues, "negative eigenvalue") +
      "; under smaller loads than these a body buckles, or its law softens, and a real "
      "one does not stay in this state: use smaller loads, or compute the motion with "
      "Time > Analysis = Dynamic");
}

template <int D, class IsNew>
void warnOfFreePieces(const StepReport& report, const IsNew& isNew, State<D>& state, Account<D>& account)
{
  for (const FreePiece& piece : report.freePieces)
    if (isNew(piece) && !account.warnedOfCut)
    {
      account.warnedOfCut = true;
      state.warnings.push_back(
          "Time > Analysis: " + piece.name() + " has come off its supports at t = " +
          readableTime(state.clock.time + state.clock.dt) + " and " + piece.motions +
          "; its loads balance, so it is in equilibrium wherever it is: what is computed "
          "of its position has no meaning, its stress and the other parts are right");
    }
    else if (!isNew(piece) && piece.imbalance.fraction() > noticeableResultant && !account.warned)
    {
      account.warned = true;
      const bool moves = piece.imbalance.fractionOfForce > noticeableResultant,
                 turns = piece.imbalance.fractionOfMoment > noticeableResultant;
      state.warnings.push_back(
          "Time > Rigid Modes: the loads on " + piece.name() + ", which is free, do not " +
          "balance: inertia forces of a uniform " + (turns && !moves ? "angular " : "") +
          "acceleration balance " + imbalanceAsText(piece, state) + "; check " +
          (moves ? "directions and sizes" : "positions and directions") + " of the loads, or support " +
          (piece.isPart && lacksContact(state)
               ? "this part, or, if only a crack parts it from the rest, " + contactAdvice(state, true, false)
               : std::string("the body")));
    }
}

/// What the loop of load steps and the summary know of a solution.
template <int D>
void reportToLoop(const StepReport& report, const NewtonStep<D>& step, LastStep& last)
{
  last.converged = report.converged;
  last.iterations = std::max(0, static_cast<int>(report.residuals.size()) - 1);
  last.residuals = report.residuals;
  last.unknowns = step.unknowns();
  last.negativeEigenvalues = report.negativeEigenvalues;
  last.unsolvable = report.unsolvable;
  last.solver = step.solver();
  last.reason = report.reason;
}

/// Whether a part bends by so much in one step that its work, taken as if forces rose in proportion to the
/// displacement, and the directions in which its particles move are wrong by more than some thousandths: a
/// bar of four cells whose end moves by a tenth of its length, 10 cells, in one step stores 0.5 % too much
/// energy, with the error in proportion to the square of the step.
template <int D>
bool bendsTooFar(const StepReport& report, const NewtonStep<D>& step, const State<D>& state, LastStep& last)
{
  constexpr double mostCells = 2.0, leastPart = 1.0 / 64.0;
  if (!report.bends || last.trial || last.inPlace || state.method.analysis == Analysis::LoadFactor)
    return false;
  const double motion = largestMotion(step, state);
  // Loads that are there at once, and stress at the start, move the part as far in a shorter step.
  constexpr double falls = 0.9;
  if (!(motion > mostCells) || (last.bentMotion > 0.0 && motion > falls * last.bentMotion))
    return false;
  last.bentMotion = motion;
  last.shorter = std::clamp(0.9 * mostCells / motion, leastPart, 0.5);
  return true;
}

template <int D>
void solveStep(State<D>& state, Account<D>& account, LastStep& last)
{
  sumOverRanks(state, SharedSums::Force);
  setTimeOfLaws(state);
  std::unique_ptr<NewtonStep<D>> solved;
  StepReport report = solveOnce(state, account, last, Boxes::MayBeClipped, solved);
  // Clipped boxes may be too far from the stiffness, or from what multigrid needs.
  if (!report.converged && !last.trial &&
      (solved->hasClippedStiffness() || (solved->hasClippedBoxes() && !report.unsolvable.empty())))
    report = solveOnce(state, account, last, Boxes::AsTheyAre, solved);
  const NewtonStep<D>& step = *solved;
  // The loop tries again with a part of the loads.
  last.shorter = 0.5;
  report.converged = report.converged && !bendsTooFar(report, step, state, last);
  reportToLoop(report, step, last);
  account.iterations += last.iterations;
  account.linearIterations += report.linearIterations;
  account.unsupportedFields = step.unsupportedFields();
  const auto isNew = [&](const FreePiece& piece)
  { return last.freePiecesAreNew || (piece.isPart && state.cracks.growth.area > 0.0); };
  if (!last.trial && state.failure.empty())
    state.failure = failureOfFreePieces(report, isNew);
  if (last.trial)
    warnOfFreePieces(
        report, [](const FreePiece&) { return false; }, state, account);
  if (last.trial || !report.converged || !state.failure.empty())
    return;
  if (!report.freeMotion.empty())
  {
    state.failure =
        report.freeMotion + ": neither supports nor closed crack faces prevent this; add a support";
    return;
  }
  account.largestForces = report.forces;
  toMotion(step, state);
  last.motion = largestMotion(step, state);
  last.workOfSupports = step.workOfSupports();
  state.energy.externalWork += last.workOfSupports;
  // Bodies that begin with stress out of balance, such as a misfit of temperatures, begin with the energy of
  // their equilibrium.
  if (state.clock.step == 0 && !last.inPlace && state.method.analysis != Analysis::Preload &&
      !account.started)
  {
    account.started = true;
    state.energy.start += state.ranks.sum(step.workOfStart());
    state.energy.externalWork += step.workOfLoadsOnStart();
  }
  state.energy.stabilised += step.ghostEnergy();
  if (report.unsupportedLoad > noticeableLoad * report.forces && !account.warnedOfPieces)
  {
    account.warnedOfPieces = true;
    char text[256];
    std::snprintf(text, sizeof text,
                  "Time > Analysis: loads of %.3g N act on %s of unsupported pieces of at most one "
                  "cell, which are held fixed; these loads do not act on the rest of the body",
                  report.unsupportedLoad, counted(step.unsupportedFields(), "node").c_str());
    state.warnings.push_back(text);
  }
  if (!(last.enough > 0.0))
    warnOfRounding(report, state, account);
  warnOfInstability(report, last.solver, state, account);
  warnOfFreePieces(report, isNew, state, account);
}

template <int D>
void toParticles(State<D>& state)
{
  state.clock.strainPass = {1.0, false};
  const double fastest = strainAndMove(state, StrainVelocity::Projection, true, true);
  if (!std::isfinite(fastest) && state.failure.empty())
    state.failure = "a particle is inverted in equilibrium; use smaller cells or more Time > Load Steps";
  state.clock.settled = true;
}

} // namespace

template <int D>
Effect<D> makeEquilibrium(const std::shared_ptr<LastStep>& last)
{
  const auto account = std::make_shared<Account<D>>();
  Effect<D> core;
  core.name = "Equilibrium";
  core.provides = {quantity::energyBalance, quantity::particleVelocity};
  core.balance = {"stabilised"};
  core.call(Stage::Scatter, "mass to nodes", {},
            {quantity::stencils, quantity::enrichedFields, quantity::nodalMass, quantity::nodalMomentum}, {},
            [](State<D>& s) { toNodes(s); });
  core.call(Stage::Solve, "equilibrium",
            {quantity::nodalMass, ifWritten(quantity::nodalForce), ifWritten(quantity::prescribedMotion),
             ifWritten(quantity::springStiffness)},
            {quantity::nodalMotion, quantity::projection, quantity::internalForce}, {},
            [=](State<D>& s) { solveStep(s, *account, *last); });
  core.call(Stage::OnParticles, "strain, stress and position of particles",
            {quantity::nodalMotion, quantity::projection}, {quantity::particleStress}, {},
            [](State<D>& s) { toParticles(s); });
  core.memory = [account, last](State<D>&, Archive& archive)
  {
    archive("iterations", account->iterations);
    archive("linear_iterations", account->linearIterations);
    archive("unsupported_fields", account->unsupportedFields);
    archive("largest_forces", account->largestForces);
    archive("warned", account->warned);
    archive("warned_of_pieces", account->warnedOfPieces);
    archive("unknowns", last->unknowns);
    archive("residuals", last->residuals);
    archive("solver", last->solver);
    int eigenvalues = last->negativeEigenvalues.value_or(-1);
    archive("negative_eigenvalues", eigenvalues);
    last->negativeEigenvalues = eigenvalues < 0 ? std::nullopt : std::optional<int>(eigenvalues);
  };
  core.report = [account, last](const State<D>& state, nlohmann::json& summary)
  {
    summary["equilibrium"] = {{"unknowns", last->unknowns},
                              {"solver", last->solver},
                              {"negative_eigenvalues", nullptr},
                              {"matrix_bytes", last->matrixBytes},
                              {"load_steps", state.clock.step},
                              {"iterations", account->iterations},
                              {"linear_iterations", account->linearIterations},
                              {"residuals", last->residuals},
                              {"unsupported_fields", account->unsupportedFields},
                              {"last_step_complete", state.failure.empty()}};
    if (last->negativeEigenvalues)
      summary["equilibrium"]["negative_eigenvalues"] = *last->negativeEigenvalues;
  };
  return core;
}

template <int D>
void inspect(const Teuchos::ParameterList& scene, const State<D>& state, LastStep& last)
{
  const NewtonStep<D> step(state, nullptr, Boxes::MayBeClipped, last.solverChoice);
  last.unknowns = step.unknowns();
  last.matrixBytes = bytesPerEntry * step.matrixEntries(); // before the particles are divided: of all ranks
  last.freePiecesAreNew = scene.sublist("Time").get<std::string>("Rigid Modes") == "Refuse";
  if (last.freePiecesAreNew)
  {
    std::string wrong;
    std::set<std::string> named;
    std::set<int> advised;
    for (const RigidMode<D>& mode : step.freeMotions())
    {
      const FreePiece piece = step.pieceOfMotion(state, mode);
      const bool apart = piece.isPart && lacksContact(state) && advised.insert(mode.piece).second;
      const std::string line =
          piece.name() + " " + mode.asText() + ": support it, or write Time > Rigid Modes = Remove" +
          (apart ? ", or, if only a crack parts it from the rest, " + contactAdvice(state, true, false)
                 : std::string());
      if (named.insert(line).second)
        wrong += (wrong.empty() ? "" : "\n") + line;
    }
    if (!wrong.empty())
      throw std::invalid_argument(wrong);
  }
}

template Effect<2> makeEquilibrium(const std::shared_ptr<LastStep>&);
template Effect<3> makeEquilibrium(const std::shared_ptr<LastStep>&);
template void inspect(const Teuchos::ParameterList&, const State<2>&, LastStep&);
template void inspect(const Teuchos::ParameterList&, const State<3>&, LastStep&);

} // namespace Rhegma::equilibrium
