#pragma once
/// The state of the springs of nodes, which lasts from step to step.

#include "cracks/CohesiveLaw.hpp"
#include "cracks/NearestFront.hpp"
#include "state/State.hpp"

namespace Rhegma::cracks
{

/// The spring of one node: a row of the nodal field. \tparam Number double, or const double
template <int D, class Number = double>
struct NodalSpring
{
  static constexpr int size = 2 * D + 7; ///< numbers of a row

  Number* row;

  /// Number, from 1, of the last step in which the node had two fields.
  KOKKOS_INLINE_FUNCTION Number& step() const { return row[0]; }
  /// How its fields are joined.
  KOKKOS_INLINE_FUNCTION SpringState state() const
  {
    return static_cast<SpringState>(static_cast<int>(row[1]));
  }
  KOKKOS_INLINE_FUNCTION void setState(SpringState to) const { row[1] = static_cast<double>(to); }
  KOKKOS_INLINE_FUNCTION bool isReleased() const { return state() != SpringState::Bonded; }
  /// Stiffness of its front spring in its last step [N/m].
  KOKKOS_INLINE_FUNCTION Number& stiffness() const { return row[2]; }
  /// Stretch of its spring, from the field of side -1 to that of +1 [m].
  KOKKOS_INLINE_FUNCTION Number& jump(int d) const { return row[3 + d]; }
  KOKKOS_INLINE_FUNCTION CohesiveLaw law() const { return {row[3 + D], row[4 + D], row[5 + D]}; }
  /// Largest opening so far [m].
  KOKKOS_INLINE_FUNCTION Number& largest() const { return row[6 + D]; }
  /// Offset of its opening, T / k [m].
  KOKKOS_INLINE_FUNCTION double offset(int d) const { return isReleased() ? row[7 + D + d] : 0.0; }

  /// Begins to release the node. \param offset T / k [m]
  KOKKOS_INLINE_FUNCTION void release(const CohesiveLaw& law, const Vector<D>& offset) const
  {
    setState(SpringState::Releasing);
    row[3 + D] = law.strength;
    row[4 + D] = law.range;
    row[5 + D] = row[6 + D] = law.onset;
    for (int d = 0; d < D; ++d)
      row[7 + D + d] = offset[d];
  }

  /// Stretch of the spring, or opening that the traction follows [m].
  KOKKOS_INLINE_FUNCTION Vector<D> opening() const
  {
    Vector<D> u;
    for (int d = 0; d < D; ++d)
      u[d] = jump(d) + offset(d);
    return u;
  }

  /// Energy that the node's traction has not yet dissipated, with what it stores [J]. \param opening now [m]
  KOKKOS_INLINE_FUNCTION double pendingEnergy(const Vector<D>& opening) const
  {
    return state() == SpringState::Releasing ? law().pendingEnergy(largest(), dot(opening, opening)) : 0.0;
  }
};

/// The springs of the lattice nodes; they hold for nodes with two fields.
template <int D>
struct NodalSprings
{
  BorrowedView<double * [NodalSpring<D>::size]> rows; ///< the nodal field
  View<int*> front; ///< index of the front that passes each node in this step, or noFront

  KOKKOS_INLINE_FUNCTION NodalSpring<D> operator()(int node) const { return {&rows(node, 0)}; }
  /// Whether a front passes the node in this step, so that it is to be released.
  KOKKOS_INLINE_FUNCTION bool isPassed(int node) const
  {
    return (*this)(node).state() == SpringState::Bonded && front(node) != noFront;
  }
};

/// The nodal field of springs (parallel/NodalFieldTable.hpp).
template <int D>
NodalField springField()
{
  return {{"front springs", NodalSpring<D>::size, "",
           "spring or cohesive traction between the fields of a node behind a crack front: step, state, "
           "stiffness, stretch, law, largest opening, offset"},
          OnRemesh::Keep,
          false,
          true};
}

} // namespace Rhegma::cracks
