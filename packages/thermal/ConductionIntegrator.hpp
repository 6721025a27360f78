#pragma once
/// Time integration of conduction with steps far longer than explicit ones.

#include "solver/KrylovSolver.hpp"
#include "thermal/CrackConduction.hpp"
#include "thermal/HeatBoundaries.hpp"

namespace Rhegma
{
class Archive;
} // namespace Rhegma

namespace Rhegma::thermal
{

/// How conduction steps in time.
enum class Method
{
  Explicit,
  SuperTimeStepping,
  Implicit,
  Steady ///< a single implicit step that is so long that the heat of the nodes no longer matters
};

/// Whether a method solves for the temperatures at the end of its step.
inline bool isImplicit(Method method) { return method == Method::Implicit || method == Method::Steady; }

/// Finds the mean heat flow of a step. Heat leaves and enters nodes only as flow from node to node or through
/// surfaces, so that heat is conserved to round-off with any number of stages and any solver tolerance.
///
/// Both start from the flow Q at the beginning of the step and take conductivities at its temperatures; a
/// change theta of the nodes' temperature changes the flow by -K theta.
///
/// Super time stepping: the s stages of RKL2 (Meyer, Balsara and Aslam, J. Comput. Phys. 257 (2014) 594,
/// equations 16 to 18), second order, stable up to (s^2 + s - 2) / 4 explicit steps. Nodes with so little
/// material that they would be unstable are treated as if they had more; all heat that flows into them goes
/// to the particles.
///
/// Implicit: backward Euler, (C + dt K) theta = dt Q, by conjugate gradients; the flow is then Q - K theta.
/// Steady: the same, (C / dt + K) theta = Q with a time far longer than that in which heat crosses the
/// bodies. What remains of C keeps bodies whose temperature nothing prescribes at their mean temperature.
/// Where faces conduct, the unknowns of a node with two fields are the change of its mean temperature, by
/// capacities, and its jump at the end: any conductance, however large, is then on the diagonal.
template <int D>
class ConductionIntegrator
{
public:
  /// Changes the nodes' rate from that at the beginning of the step to the mean over it, and renews the
  /// particles' temperature gradient. Temperatures of held nodes are those at the end already. Collective.
  /// \param explicitLimit longest explicit step [s] \return heat [J] that surfaces take in on top of dt times
  /// their power at the beginning, of this rank
  double findRate(State<D>& state, const HeatNodes<D>& nodes, const HeatBoundaries<D>& boundaries,
                  const CrackConduction<D>& faces, double dt, double explicitLimit);

  /// Gives the nodes the change that a steady step has found, in place of that by their rate. \return the
  /// heat [J] that the nodes of this rank take up
  double takeSteadyChange(const State<D>& state, const HeatNodes<D>& nodes) const;

  /// Stages of super time stepping for steps of dt.
  static int stages(double dt, double explicitLimit);

  Method method = Method::Explicit;
  double stepRatio = 20.0; ///< longest step over the longest explicit one
  long products = 0;       ///< evaluations of the flow of all particles, in addition to one per step

  void serialize(Archive& archive);

  /// Parts of `findRate`; public because compilers for devices want kernels in public functions.
  double superTimeStep(State<D>& state, const HeatNodes<D>& nodes, const HeatBoundaries<D>& boundaries,
                       double dt, double explicitLimit);
  double implicitStep(State<D>& state, const HeatNodes<D>& nodes, const HeatBoundaries<D>& boundaries,
                      const CrackConduction<D>& faces, double dt);
  double findFlow(const State<D>& state, const HeatBoundaries<D>& boundaries);
  void addGradient(const State<D>& state, const HeatNodes<D>& nodes);
  void findDiagonal(const State<D>& state, const HeatBoundaries<D>& boundaries);
  void numberUnknowns(const State<D>& state, const HeatNodes<D>& nodes);
  void findPairs(const State<D>& state, const HeatNodes<D>& nodes, const CrackConduction<D>& faces,
                 double dt);
  void spread(const State<D>& state, double jump);
  void residual(const State<D>& state, const HeatNodes<D>& nodes, double dt, const BorrowedView<double*>& to);
  void passThroughFaces(const State<D>& state, const HeatNodes<D>& nodes, double dt);
  void precondition(const State<D>& state, const HeatNodes<D>& nodes, double dt,
                    const BorrowedView<const double*>& from, const BorrowedView<double*>& to);

private:
  void reserveRows(const State<D>& state);
  KrylovSolver& gradients() { return method == Method::Steady ? ofSteady_ : ofSteps_; }

  /// Columns of pairs_: fractions a and b of the jump of the two fields, jump at the beginning [K], dt times
  /// conductance [J/K], unknown jump [K]; a = b = 0 where nothing passes or both are held.
  static constexpr int pairWidth = 5;

  View<double* [2]> change_;        ///< theta [K]; the second column is not used
  View<double* [2]> flow_;          ///< -K theta [W]; the second column is not used
  View<double*> diagonal_;          ///< of K [W/K]
  View<double* [4]> stage_;         ///< heat that has flowed in by three stages, and Q [J, W]
  View<char*> held_;                ///< not 0 for nodes whose temperature is prescribed
  View<char*> unknown_;             ///< not 0 for nodes of this rank whose temperature is to be found
  View<double* [pairWidth]> pairs_; ///< of each enriched field
  int numPairs_ = 0;                ///< enriched fields while faces conduct, else 0
  KrylovSolver ofSteps_{1e-8, 1000};
  /// The error of temperatures is the residual's times the square of the number of cells across a body.
  KrylovSolver ofSteady_{1e-12, 20000};
  int capacity_ = 0; ///< number of unknowns that fit
};

} // namespace Rhegma::thermal
