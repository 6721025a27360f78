#pragma once
/// The linear systems of an equilibrium, in the unknowns that no support holds.

#include "equilibrium/Particles.hpp"
#include "solver/ConjugateGradients.hpp"

namespace Rhegma::equilibrium
{

/// How a linear system was solved.
struct LinearAnswer
{
  bool solved = false;
  int iterations = 0;
};

/// The matrix of the free unknowns, of one graph.
template <int D>
class LinearSystem
{
public:
  /// \param held unknowns that are eliminated
  LinearSystem(const State<D>& state, const RowGraph& graph, const Held& held);

  int unknowns() const { return unknowns_; }

  /// Solves for the change of the free unknowns, those that are held changing as given.
  /// \param right forces on all unknowns \param change on entry of held unknowns, on exit of all
  LinearAnswer solve(const StiffnessBlocks& stiffness, const Values& right, const Values& change);

private:
  RowGraph graph_;
  std::vector<int> free_;           ///< number of each unknown among the free ones, or -1
  std::vector<int> first_, column_; ///< rows of the matrix
  std::vector<int> entry_;          ///< of each number in `value_`, its number in the blocks
  std::vector<double> value_;
  int unknowns_ = 0;
  ConjugateGradients gradients_;
};

} // namespace Rhegma::equilibrium
