#pragma once
/// The linear systems of an equilibrium.

#include "equilibrium/EarlierRows.hpp"
#include "equilibrium/SolverChoice.hpp"
#include "equilibrium/SystemMatrix.hpp"
#include "equilibrium/TangentProduct.hpp"
#include "solver/DirectSolver.hpp"
#include "solver/KrylovSolver.hpp"
#include "solver/Multigrid.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace Rhegma::equilibrium
{

/// How a linear system was solved.
struct LinearAnswer
{
  bool solved = false;
  int iterations = 0; ///< of conjugate gradients or GMRES; 0 for a direct solution
  /// Of the matrix: counted by a direct solution; 1 where conjugate gradients met a direction of negative
  /// stiffness, of which there may be more; nothing where neither says anything.
  std::optional<int> negativeEigenvalues{};
  std::string failure{}; ///< why it is not solved, where that is no property of the matrix; else empty
};

/// When a linear solution is exact enough: as soon as its residual is below one of these.
struct LinearGoal
{
  double force;          ///< [N]
  double fraction = 0.0; ///< of the right side
};

/// Makes blocks of a stiffness. Collective.
using MakeBlocks = std::function<StiffnessBlocks()>;

/// The matrix of all unknowns, of one graph. Rows of unknowns that supports hold are those of the diagonal
/// alone, so that each node keeps its D rows. On several ranks each has the rows that it owns, and all calls
/// but `unknowns` and `method` are collective.
template <int D>
class LinearSystem
{
public:
  /// \param owners of the rows \param positions of the rows' nodes [m] \param held unknowns that supports
  /// hold
  LinearSystem(const RowGraph& graph, const RowOwners& owners, const std::vector<Vector<D>>& positions,
               const Held& held);

  /// Whether this is the system of another graph with its supports, so that its order of unknowns and its
  /// preconditioner serve there too.
  bool fits(const RowGraph& graph, const Held& held) const;

  /// Takes over the preconditioner of a system that has most of the rows of this one; the others get the
  /// diagonal.
  void adopt(LinearSystem& earlier);

  /// Number of unknowns of all ranks that no support holds.
  int unknowns() const { return unknowns_; }

  /// Which solver the scene asks for; from the next system on that is solved for the first time.
  void choose(SolverChoice choice) { choice_ = choice; }

  /// Whether matrices that are not symmetric can be solved: by factorisation, which is used from now on if
  /// the system is not too large, because forces as stiff as those of faces take hundreds of iterations; else
  /// by GMRES with multigrid. With the diagonal alone GMRES would need a longer basis than is stored: then
  /// only the symmetric part of the stiffness of sliding faces can be used, with which Newton's method need
  /// not converge.
  bool takesUnsymmetric();

  /// Solves for the change of the free unknowns, those that are held changing as given.
  /// \param stiffness complete for the rows that this rank owns; released before the system is solved, if the
  /// caller keeps no reference
  /// \param symmetric whether the stiffness is \param right forces on all unknowns
  /// \param goal of conjugate gradients or GMRES \param change on entry of held unknowns, on exit
  /// of all that this rank owns
  LinearAnswer solve(StiffnessBlocks stiffness, bool symmetric, const Values& right, const LinearGoal& goal,
                     const Values& change);

  /// The same with the stiffness of the last call, where no held unknown changes.
  LinearAnswer solveAgain(const Values& right, const LinearGoal& goal, const Values& change);

  /// The same without a matrix, by conjugate gradients or GMRES. \param product with the stiffness
  /// \param approximate makes one of the graph that resembles it, for the multigrid: called where that is not
  /// of an earlier system
  LinearAnswer solve(const TangentProduct<D>& product, const MakeBlocks& approximate, const Values& right,
                     const LinearGoal& goal, const Values& change);

  /// Whether a system of so many rows is too large for direct solutions.
  static bool isLarge(int rows);

  /// What solved the last system, as the summary says it.
  std::string method() const;

private:
  enum class Method
  {
    Unknown,
    Direct,
    Multigrid,
    Diagonal
  };

  void prepare();
  void makeKrylov();
  Method chooseMethod();
  Multigrid::Vectors nearNullSpace() const;
  /// Of the nodes of this rank's rows, along each axis [m].
  Multigrid::Vectors coordinates() const;
  void makeMultigrid();
  void precondition(const View<double*>& diagonal, const BorrowedView<const double*>& x,
                    const BorrowedView<double*>& y) const;
  LinearAnswer solveDirectly(bool symmetric);
  LinearAnswer finish(LinearAnswer answer, bool symmetric, const LinearGoal& goal, const Values& change);
  LinearAnswer take(const LinearAnswer& answer, const Values& change) const;
  LinearAnswer iterate(const LinearGoal& goal);
  void multiply(const BorrowedView<const double*>& x, const BorrowedView<double*>& y) const;
  Values diagonal() const;
  SolveResult runKrylov(const Values& diagonal, int most = 0);

  RowOwners owners_;
  std::vector<Vector<D>> position_;
  View<char*> held_;
  SystemMatrix<D> matrix_;
  std::vector<int> nodes_; ///< of the rows of this rank
  int rowsOfAll_ = 0;      ///< of all ranks
  int unknowns_ = 0;
  Values b_, x_;
  SolverChoice choice_ = SolverChoice::Automatic;
  Method method_ = Method::Unknown;
  DirectSolver direct_, unsymmetric_{false};
  bool unsymmetricAnalysed_ = false;
  bool isTooLarge_ = false;  ///< for any factorisation
  bool symmetric_ = true;    ///< the last matrix
  bool metNegative_ = false; ///< whether conjugate gradients met negative stiffness in the last system
  const TangentProduct<D>* product_ = nullptr; ///< while a system is solved without a matrix
  const MakeBlocks* approximate_ = nullptr;    ///< with it
  Values diagonal_;                            ///< with it, of this rank's rows
  Values all_, force_;                         ///< with it: of all unknowns that this rank knows
  std::unique_ptr<KrylovSolver> krylov_;
  std::unique_ptr<Multigrid> multigrid_;
  EarlierRows earlier_;    ///< where the multigrid is of an earlier system
  double perDecade_ = 0.0; ///< iterations with the multigrid, when it was made, per decade of the residual
};

} // namespace Rhegma::equilibrium
