#pragma once
/// Motion of the nodes with a mass matrix that couples them.

#include "mass_matrix/Chebyshev.hpp"
#include "mass_matrix/MassSystem.hpp"
#include "solver/KrylovSolver.hpp"

#include <string>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::mass_matrix
{

/// Cost of the solves of a run.
struct SolveCount
{
  long solves = 0;
  long iterations = 0;
  int mostIterations = 0;
  double worstResidual = 0.0;
};

/// Nodal fields of the last solutions, from which the next solves start.
inline const std::string velocityGuess = "first guess of velocity";         ///< [m/s]
inline const std::string accelerationGuess = "first guess of acceleration"; ///< [m/s2]

/// Accuracy of a solve.
enum class Accuracy
{
  Solved, ///< to the tolerance
  Near    ///< one application of the polynomial to the residual of the first guess; not counted as a solve
};

/// Solves M x = b for the coupled nodes, with prescribed values where boundaries hold a node:
/// free rows of M x = b, held rows of x given. The sum of M x over the free nodes is that of b to round-off
/// where nothing is held, whatever the tolerance: the constant vector is an eigenvector of the preconditioned
/// matrix, so that once the first guess has the right sum every iterate has it.
template <int D>
class NodalSolve
{
public:
  /// \param lumpedFraction eps of M_eps, the least eigenvalue of the lumped mass' inverse times M
  NodalSolve(double tolerance, int maximumIterations, double lumpedFraction);

  /// Prepares for the present rows and held nodes.
  void begin(const State<D>& state, const MassSystem<D>& system);

  /// Velocity and acceleration of the coupled nodes from momentum and force; those of held nodes from the
  /// boundaries, whose impulses go to the state.
  void solveMotion(State<D>& state, const MassSystem<D>& system);

  /// Velocity that strains the particles from the projected momentum, which arrives as a velocity of the
  /// lumped mass.
  void solveProjection(State<D>& state, const MassSystem<D>& system);

  const SolveCount& count() const { return count_; }

  /// Saves or loads the count.
  void serialize(Archive& archive);

  // Parts of the above; public because compilers for devices want kernels in public functions.

  /// Solves M x = right from the guess in x. \param held whether x is given by `prescribed` where supports
  /// are
  void solve(State<D>& state, const MassSystem<D>& system, bool held, const View<double*>& x,
             const std::string& what, Accuracy accuracy);

  /// Where a solve starts: at `multiple` times the guess, shifted by a constant.
  struct Start
  {
    double scale = 0.0;    ///< scale of residuals
    double multiple = 0.0; ///< of the guess
    Vector<D> shift{};     ///< along each axis
  };
  /// Sets x where supports prescribe it, and finds where to start from the guess in x.
  Start findStart(const State<D>& state, const MassSystem<D>& system, bool masked, const View<double*>& x);
  /// Takes x to the start and leaves the residual, by its scale, to the solver. \return its norm
  double findResidual(const State<D>& state, const MassSystem<D>& system, bool masked, const Start& start,
                      const View<double*>& x);

  /// Finds rows that boundaries hold, and the inverse of the lumped mass elsewhere.
  void holdRows(const State<D>& state, const MassSystem<D>& system);

private:
  void reserve(const State<D>& state, const MassSystem<D>& system);
  void record(State<D>& state, const SolveResult& result, double scale, const std::string& what);

  KrylovSolver gradients_;
  Chebyshev<D> chebyshev_;
  SolveCount count_;
  bool renewed_ = false;   ///< whether cells have changed since the last step, so that no guesses exist
  bool masked_ = false;    ///< whether any boundary holds a motion
  bool heldAxis_[D] = {};  ///< whether any boundary holds motion along the axis
  View<double*> inverse_;  ///< 1/L
  View<double*> freeOnly_; ///< 1/L, 0 where a boundary holds the unknown
  View<double*> heldVelocity_;
  View<double*> right_, prescribed_, image_;
  View<double*> velocity_, acceleration_;
  View<double*> plain_; ///< a vector of the solver as the matrix takes it, where there are several ranks
};

} // namespace Rhegma::mass_matrix
