#pragma once
/// What the springs of nodes remember from step to step.

#include "cracks/CohesiveLaw.hpp"
#include "cracks/NearestFront.hpp"
#include "state/State.hpp"

#include <vector>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::cracks
{

/// The springs of the lattice nodes. Rows are those of nodes; they hold for nodes with two fields.
template <int D, class Space = MemorySpace>
struct NodalSprings
{
  template <class Data>
  using Of = Kokkos::View<Data, Kokkos::LayoutRight, Space>;

  Of<int*> step;             ///< number, from 1, of the last step in which the node had two fields
  Of<SpringState*> state;    ///< how its fields are joined
  Of<int*> front;            ///< index of the front that passes it in this step, or noFront
  Of<double*> stiffness;     ///< of its front spring in its last step [N/m]
  Of<double* [D]> jump;      ///< stretch of its spring, from the field of side -1 to that of +1 [m]
  Of<double * [D + 4]> rows; ///< where fronts may grow: CohesiveLaw, largest opening, T / k [N, m]

  NodalSprings() = default;
  /// \param grows whether fronts may grow
  NodalSprings(int nodes, bool grows)
      : step("rhegma::springStep", nodes),
        state("rhegma::springState", nodes),
        front("rhegma::springFront", nodes),
        stiffness("rhegma::springStiffness", nodes),
        jump("rhegma::springJump", nodes),
        rows("rhegma::springRows", grows ? nodes : 0)
  {
    Kokkos::deep_copy(front, noFront);
  }

  int size() const { return static_cast<int>(step.extent(0)); }

  KOKKOS_INLINE_FUNCTION bool isReleased(int n) const { return state(n) != SpringState::Bonded; }
  /// A front has passed the node in this step: it is to be released.
  KOKKOS_INLINE_FUNCTION bool isPassed(int n) const
  {
    return state(n) == SpringState::Bonded && front(n) != noFront;
  }
  KOKKOS_INLINE_FUNCTION CohesiveLaw law(int n) const { return {rows(n, 0), rows(n, 1), rows(n, 2)}; }
  KOKKOS_INLINE_FUNCTION double& largest(int n) const { return rows(n, 3); } ///< opening so far [m]

  /// Begins to release a node. \param offset T / k, from which its opening counts [m]
  KOKKOS_INLINE_FUNCTION void release(int n, const CohesiveLaw& law, const Vector<D>& offset) const
  {
    state(n) = SpringState::Releasing;
    rows(n, 0) = law.strength;
    rows(n, 1) = law.range;
    rows(n, 2) = rows(n, 3) = law.onset;
    for (int d = 0; d < D; ++d)
      rows(n, 4 + d) = offset[d];
  }

  /// From what the opening counts along an axis [m].
  KOKKOS_INLINE_FUNCTION double offset(int n, int d) const { return isReleased(n) ? rows(n, 4 + d) : 0.0; }

  /// Stretch of the spring, or opening that the traction follows [m].
  KOKKOS_INLINE_FUNCTION Vector<D> opening(int n) const
  {
    Vector<D> u;
    for (int d = 0; d < D; ++d)
      u[d] = jump(n, d) + offset(n, d);
    return u;
  }

  /// Energy that the node's traction has not yet dissipated, with what it stores [J]. \param opening now [m]
  KOKKOS_INLINE_FUNCTION double pendingEnergyAt(int n, const Vector<D>& opening) const
  {
    return state(n) == SpringState::Releasing ? law(n).pendingEnergy(largest(n), dot(opening, opening)) : 0.0;
  }
  KOKKOS_INLINE_FUNCTION double pendingEnergy(int n) const { return pendingEnergyAt(n, opening(n)); }
};

/// The springs of nodes, kept at their positions where cells are refined or divided anew among ranks.
/// The energy that is pending at nodes that are no more returns to the nearest front that has grown.
template <int D>
class SpringMemory
{
public:
  /// \param grows whether fronts may grow
  explicit SpringMemory(bool grows) : grows_(grows) {}

  /// Has a row for each lattice node as they are now, and one in state.cracks.springs. Collective.
  void fitToNodes(State<D>& state);

  /// Saves or loads the springs of the nodes that had two fields in the last step. \param step its number,
  /// from 1
  void keep(State<D>& state, int step, Archive& archive);

  const NodalSprings<D>& springs() const { return springs_; }

private:
  /// The springs of the nodes that had two fields in the last step, a row of numbers each: the node's name,
  /// its energy that is pending, then its spring.
  std::vector<double> packed(const State<D>& state) const;
  /// Gives the springs of such rows to nodes as they are now. \return of each row whether there is such a
  /// node
  std::vector<double> unpack(const State<D>& state, const std::vector<double>& rows);
  /// How many numbers a row has.
  int width() const { return 2 * D + 4 + (grows_ ? D + 4 : 0); }

  bool grows_;
  NodalSprings<D> springs_;
  int generation_ = 0;          ///< of the refined cells and of this rank's nodes
  Grid<D> grid_{};              ///< this rank's nodes to which these belong
  View<char*> foreign_;         ///< which of them are other ranks' too
  View<double* [D]> finePlace_; ///< of the nodes of refined cells to which these belong [m]
};

} // namespace Rhegma::cracks
