#pragma once
/// Newton's method for the displacement of a step of equilibrium.

#include "equilibrium/FreePieces.hpp"
#include "equilibrium/LinearSystem.hpp"
#include "equilibrium/Resistances.hpp"
#include "equilibrium/RigidModes.hpp"
#include "equilibrium/SecantMixing.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace Rhegma::equilibrium
{

/// Residual of the forces, as a fraction of the forces, at which a step is in equilibrium.
constexpr double forceTolerance = 1e-9;

/// Iterations after which a step counts as failed; a quadratic rate needs a handful.
constexpr int mostIterations = 20;

/// The same where forces choose between branches: each choice takes an iteration.
constexpr int mostIterationsWithBranches = 60;

/// A residual that no longer falls is rounding if it is no larger a fraction of the forces.
constexpr double roundingOfForces = 1e-6;

/// How a step was solved.
struct StepReport
{
  bool converged = false;
  bool bends = false;            ///< whether the residual rose on the way, as that of a part that bends does
  std::vector<double> residuals; ///< before each iteration and after the last, as fractions of the forces
  int linearIterations = 0;      ///< of all linear solves
  std::optional<int> negativeEigenvalues{}; ///< of the last matrix (LinearAnswer)
  std::string unsolvable;                   ///< why a linear system was not solved (LinearAnswer::failure)
  std::vector<FreePiece> freePieces; ///< whose loads inertia forces have balanced, if they do not balance
  double forces = 0.0; ///< largest norm so far of loads, forces of supports or forces out of balance at the
                       ///< start of a step [N]
  double unsupportedLoad = 0.0; ///< sum of the loads on pieces that are held as nothing supports them [N]
  std::string freeMotion;       ///< of pieces that only forces of the step hold; else empty
  std::string reason;           ///< what keeps it from equilibrium, where that is known; else empty
};

/// Whose stiffness is assembled.
enum class Boxes
{
  MayBeClipped, ///< in large systems (ClippedBoxes)
  AsTheyAre
};

/// The unknowns of a step and the forces between them. On several ranks the rows are those of the rank's
/// window, with the same values on all ranks that have them, and what the rank's particles, jumps and forces
/// exert is summed over the ranks. The constructor and all calls that get a state are collective.
template <int D>
class NewtonStep
{
public:
  /// Numbers the unknowns. \param state with stencils, masses and prescribed motion of the step
  /// \param earlier system of an earlier step, which is used where it fits; may be null
  /// \param boxes whether the stiffness of a large system may be that of clipped boxes \param choice of the
  /// scene
  explicit NewtonStep(const State<D>& state, std::shared_ptr<LinearSystem<D>> earlier = nullptr,
                      Boxes boxes = Boxes::MayBeClipped, SolverChoice choice = SolverChoice::Automatic);

  /// Whether clipped boxes are used: for the stiffness, or for the multigrid alone.
  bool hasClippedBoxes() const { return boxes_.any(); }
  /// Whether the stiffness by which Newton's method goes on is that of clipped boxes. Products without a
  /// matrix are those of the boxes as they are.
  bool hasClippedStiffness() const { return boxes_.any() && !byProducts_; }

  int unknowns() const { return system_ ? system_->unknowns() : 0; }
  std::string solver() const { return system_ ? system_->method() : "none"; }
  const std::shared_ptr<LinearSystem<D>>& system() const { return system_; }
  double matrixEntries() const { return static_cast<double>(D) * D * graph_.column.extent(0); }
  const std::vector<RigidMode<D>>& freeMotions() const { return modes_; }
  /// The piece that a free motion moves.
  FreePiece pieceOfMotion(const State<D>& state, const RigidMode<D>& mode) const;
  /// Fields of all ranks that hang on nothing, and stay where they are.
  int unsupportedFields() const { return unsupportedFields_; }

  /// Finds the displacement under the nodal forces of the state. \return how; `displacement` then holds it
  /// \param largestForces of earlier steps [N]: residuals are fractions of the largest forces of the run
  /// \param most iterations after which the step counts as failed; 0: only the loads are looked at, without
  /// works \param enoughAtStart fraction of the forces that may be out of balance before the first iteration
  StepReport solve(const State<D>& state, double largestForces, int most = mostIterations,
                   double enoughAtStart = 0.0);

  /// Makes solve() call a function before each iteration. \param iteration gets its number, from 0, and the
  /// residual as a fraction of the forces
  void onIteration(std::function<void(int, double)> iteration) { onIteration_ = std::move(iteration); }

  const Values& displacement() const { return displacement_; }
  /// Forces of supports on the body [N]; zero on other unknowns.
  const Values& reaction() const { return reaction_; }
  /// Work of the supports over the step [J], and energy of the ghost penalty: this rank's part.
  double workOfSupports() const { return workOfSupports_; }
  double ghostEnergy() const;
  /// Half of the work that forces of the stress at the start of a step with heat do on all that is not held
  /// [J]: this rank's part. In the first step that is what a body whose stress is out of balance, such as
  /// that of a misfit of temperatures, releases (negative) until it is in equilibrium, with
  /// `workOfBentPath`: over the displacement that this stress causes alone.
  double workOfStart() const { return workOfStart_; }
  /// The same over the displacement that loads and supports cause [J]: this rank's part. By reciprocity it
  /// is, with the other sign, half of the work that these do over the displacement of the stress: added to
  /// their work, it leaves that over the displacement that they cause themselves.
  double workOfLoadsOnStart() const { return workOfLoadsOnStart_; }
  const RowGraph& graph() const { return graph_; }

private:
  /// The pieces that can move freely, once cracks have grown also those that no material holds.
  /// \param converged whether the displacement is an equilibrium
  std::vector<FreePiece> freePieces(const State<D>& state, bool converged) const;
  void findFreeMotions(const State<D>& state);
  /// In axisymmetric scenes hoop strain resists the radial motion of each row, and so a rotation.
  std::vector<HeldDirection<D>> resistanceOfHoops(const State<D>& state) const;
  std::vector<char> piecesThatResistRotation(const std::vector<int>& pieceOf, int pieces) const;
  /// Forces minus resistance at a trial displacement. \return false, on all ranks, where a particle is
  /// inverted
  bool residual(const State<D>& state, const Values& u, const Values& r) const;
  /// \return whether the stiffness is that of a trial displacement that exists, on all ranks
  bool assemble(const State<D>& state);
  /// Solves for a change with the last stiffness. \param again where that has been used before
  LinearAnswer solveWithLast(const State<D>& state, const Values& right, const LinearGoal& goal, bool again,
                             const Values& change);
  /// Forces of the stress at the start of the step; zero without heat. \param atStart residual there, which
  /// becomes that with this stress: the temperatures of a step change during the step, not before it
  Values forcesOfStart(const State<D>& state, const Values& atStart) const;
  /// Reactions, work of supports and of the start. \param atStart residual at the start of the step
  void findWork(const State<D>& state, const Values& atStart);
  /// Splits the work of the stress at the start between `workOfStart` and `workOfLoadsOnStart`, by another
  /// linear solution, where loads or supports act. \param ofStress its forces
  void splitWork(const State<D>& state, const Values& ofStress);
  /// Work of the stress along the straight path to the displacement, less that of the mean of its forces at
  /// both ends, which misses what rotations do (in a bar of two metals that bends, 1.3 % of all that is
  /// released). This rank's part [J]; collective.
  double workOfBentPath(const State<D>& state) const;
  /// Takes the nodal forces of the state as loads. \return sum of those on unsupported pieces [N]
  double takeLoads(const State<D>& state);
  /// Whether a residual that falls no further is rounding [N]. Collective.
  bool isRounding(const State<D>& state, double residual, double forces) const;
  /// Lets the step's forces learn from an accepted displacement, and finds the residual that then remains.
  void updateForces(const State<D>& state);
  /// Which pieces are no larger with the forces of the step that join pieces.
  std::vector<int> piecesThatStayWhole() const;
  /// Free motions of pieces that forces of the step join, as they are now, as a message; empty if none. Free
  /// motions of all that is joined are those of Time > Rigid Modes.
  std::string motionsBetweenPieces(const State<D>& state) const;
  int iterationsFor(int most) const;
  /// Whether held unknowns have the displacement of their supports.
  bool supportsAreInPlace() const;
  /// Whether the next iteration uses the stiffness of the last: where that is expected to end the step, or
  /// where the rate is that of clipped boxes. \param before residual before the last iteration \param now
  /// after
  bool keepsStiffness(double before, double now, double forces) const;
  /// Says in a report what keeps the step from equilibrium, and what is free to move.
  void explain(const State<D>& state, StepReport& report) const;
  /// Takes the mean motion and rotation from the change of free pieces: loads do not turn with a body, so
  /// that the stiffness of a body's rotation is that of its stress, which is as small and may be negative.
  void removeRigidMotion(const Values& change) const;
  /// What makes up for that. A body under stress resists its rotation, so that a solution with few unknowns
  /// held, less its rotation, is none of the same system: it converges like a series, in as many directions
  /// as there are free motions.
  SecantMixing mixingOfFreeMotions() const;
  /// Number of rows of each piece.
  std::vector<int> sizesOf(const std::vector<int>& pieceOf, int pieces) const;
  /// Part of a residual on unknowns of all ranks that are held (true) or free (false), as 2-norm.
  double norm(const Values& r, bool held) const;
  /// The change of all unknowns for the present residual. \param keeps the stiffness of the last call
  LinearAnswer solveLinear(const State<D>& state, const LinearGoal& goal, bool keeps, const Values& change);
  /// Minus the slope of the energy along a change of what is free [J]: the work of the residual.
  double slopeAlong(const Values& change) const;
  /// Moves along the change, halving it until the residual falls or, where the forces have an energy, its
  /// slope does. \return false where neither does
  bool search(const State<D>& state, const Values& change, double before, double enough);
  /// The same with secants, unless `mixing` is null; along the change itself where they lead nowhere.
  bool searchWith(SecantMixing* mixing, const State<D>& state, const Values& change, double before,
                  double enough);

  RowGraph graph_;
  RowOwners owners_;
  ClippedBoxes<D> boxes_;
  bool byProducts_ = false; ///< whether only the multigrid has a matrix: that of boxes in one cell
  Resistances<D> resistances_;
  std::vector<Vector<D>> position_;
  std::vector<double> mass_;
  std::vector<int> pieceOf_;
  int pieces_ = 0;
  std::vector<RigidMode<D>> modes_;
  Held held_;
  std::vector<int> unsupported_; ///< rows
  int unsupportedFields_ = 0;
  std::vector<int>
      apart_; ///< piece of each row, without the forces that join pieces; empty if there are none
  int piecesApart_ = 0;
  std::vector<int> solid_; ///< piece of each row by Couplings::OfMaterial, once cracks have grown; else empty
  int solidPieces_ = 0;
  std::function<void(int, double)> onIteration_;
  std::shared_ptr<LinearSystem<D>> system_;
  Stiffness stiffness_;                        ///< the last; without blocks once the system has them
  std::unique_ptr<TangentProduct<D>> product_; ///< in its place, where no matrix is made
  Values load_, displacement_, residual_, reaction_;
  Values diagonal_; ///< of the last stiffness, of the rows that this rank owns [N/m]
  double workOfSupports_ = 0.0, workOfStart_ = 0.0, workOfLoadsOnStart_ = 0.0;
};

} // namespace Rhegma::equilibrium
