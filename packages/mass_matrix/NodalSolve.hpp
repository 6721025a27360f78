#pragma once
/// Motion of the nodes with a mass matrix that couples them.

#include "mass_matrix/ConjugateGradients.hpp"
#include "mass_matrix/MassSystem.hpp"

#include <string>

namespace Rhegma::mass_matrix
{

/// What the solves of a run have cost.
struct SolveCount
{
  long solves = 0;
  long iterations = 0;
  int mostIterations = 0;
  double worstResidual = 0.0;
};

/// Solves M x = b for the coupled nodes, with prescribed values where boundaries hold a node:
/// free rows of M x = b, held rows of x given. The sum of M x over the free nodes is that of b to round-off
/// where nothing is held, whatever the tolerance: the constant vector is an eigenvector of the preconditioned
/// matrix, so that once the first guess has the right sum every iterate has it.
template <int D>
class NodalSolve
{
public:
  NodalSolve(double tolerance, int maximumIterations) : gradients_(tolerance, maximumIterations) {}

  /// Takes the rows as they are now and the nodes that boundaries hold.
  void begin(const State<D>& state, const MassSystem<D>& system);

  /// Velocity and acceleration of the coupled nodes from momentum and force; those of held nodes from the
  /// boundaries, whose impulses go to the state.
  void solveMotion(State<D>& state, const MassSystem<D>& system);

  /// Velocity that strains the particles from the projected momentum, which arrives as a velocity of the
  /// lumped mass.
  void solveProjection(State<D>& state, const MassSystem<D>& system);

  const SolveCount& count() const { return count_; }

  // Parts of the above; public because compilers for devices want kernels in public functions.

  /// Solves M x = right from the guess in x. \param held 1 where x is given by `prescribed`; empty if nowhere
  void solve(State<D>& state, const MassSystem<D>& system, const View<int*>& held, const View<double*>& x,
             const std::string& what);

  /// y = M x.
  void applyMass(const State<D>& state, const MassSystem<D>& system, const BorrowedView<const double*>& x,
                 const BorrowedView<double*>& y) const;

  /// Shifts x by a constant so that the residual sums to zero along an axis.
  void matchSums(const MassSystem<D>& system, int axis, const View<double*>& residual,
                 const View<double*>& x);

private:
  void reserve(int unknowns);

  ConjugateGradients gradients_;
  SolveCount count_;
  int room_ = 0;
  bool heldAxis_[D] = {}; ///< whether any boundary holds motion along the axis
  View<int*> heldRoom_;
  View<int*> held_; ///< 1 where a boundary holds the unknown; empty where there are no such boundaries
  View<double*> heldVelocity_, inverseDiagonal_;
  View<double*> right_, prescribed_, residual_, correction_;
  View<double*> velocity_, acceleration_;
  View<double* [D]> lastAcceleration_; ///< of every node: where the next solve starts
};

} // namespace Rhegma::mass_matrix
