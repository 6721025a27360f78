#pragma once
/// What the ties of nodes remember from step to step.

#include "state/State.hpp"

namespace Rhegma
{
class Archive;
}

namespace Rhegma::cracks
{

/// Jumps, stiffnesses and cohesive forces of the nodes with two fields, kept at their places where cells are
/// refined or divided anew among ranks.
template <int D>
class TieMemory
{
public:
  /// \param grows whether fronts may grow
  explicit TieMemory(bool grows) : grows_(grows) {}

  /// Has a row for each lattice node as they are now, and one in state.cracks.tie. Collective.
  void makeRoom(State<D>& state);

  /// Saves or loads what the nodes have that had two fields in the last step. \param step its number, from 1
  void keep(State<D>& state, int step, Archive& archive);

  /// From the field of side -1 to that of +1 [m].
  const View<double* [D]>& jump() const { return jump_; }
  /// Of each node's tie in its last step [N/m].
  const View<double*>& stiffness() const
  {
    return stiffness_;
  }
  /// Number, from 1, of the last step in which a node had two fields.
  const View<int*>& step() const { return step_; }
  /// Rows of Cohesion.hpp; none unless fronts may grow.
  const View<double* [D + 4]>& cohesion() const { return cohesion_; }

  private :
      /// Moves what nodes of refined cells have to the numbers that they have now. What cohesive forces of
      /// nodes that are no more would yet have taken goes back to their fronts, for the nodes that come next.
      void carryOver(State<D>& state);
  /// Moves all to the nodes that this rank has now, from those that all ranks had. Collective.
  void moveToNewNodes(State<D>& state);

  bool grows_;
  View<double* [D]> jump_;
  View<double*> stiffness_;
  View<int*> step_;
  View<double * [D + 4]> cohesion_;
  int generation_ = 0;          ///< of the refined cells and of this rank's nodes
  Grid<D> grid_{};              ///< this rank's nodes to which these belong; empty where there is one rank
  View<char*> foreign_;         ///< which of them are other ranks' too
  View<double* [D]> finePlace_; ///< of the nodes of refined cells to which these belong [m]
};

} // namespace Rhegma::cracks
