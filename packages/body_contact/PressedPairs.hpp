#pragma once
/// Pairs of groups that pressed on each other at a node in the last step.

#include "body_contact/NodalContact.hpp"

namespace Rhegma::body_contact
{

/// Pairs of groups that may meet at a node.
constexpr int mostPressed = pairsOf(mostGroups);

/// The nodal fields in which they are stored, so that runs can be continued. \param groups number of them in
/// the scene
std::vector<NodalField> pressedPairsFields(int groups);

/// The pairs that pressed in the step before, each by one number: the step, from 1 on, times the number of
/// pairs in the scene, and the pair.
struct PressedPairs
{
  BorrowedView<double*> code[mostPressed]; ///< of each node, in no order; older ones of earlier steps
  int count = 0;                           ///< number of these in use
  int pairs = 0;                           ///< number of pairs of groups in the scene
  double step = 0.0;                       ///< number of the step before, from 1 on; 0: there was none

  /// The number of a pair in a step. \param one, other groups from 0 on, the lower number first
  KOKKOS_INLINE_FUNCTION double codeOf(double inStep, int one, int other) const
  {
    return inStep * pairs + (pairsOf(other) + one);
  }

  /// Whether two groups pressed on each other at a node.
  KOKKOS_INLINE_FUNCTION bool operator()(int node, int one, int other) const
  {
    const double wanted = codeOf(step, one, other);
    bool found = false;
    for (int k = 0; k < count; ++k)
      found = found || code[k](node) == wanted;
    return found && step > 0.0;
  }
};

/// Those of the step before. \param groups number of them in the scene
template <int D>
PressedPairs pressedPairs(const State<D>& state, int groups);

/// Stores the pairs that press in this step for the next one. Springs of an interface are no pressure.
template <int D>
void keepPressedPairs(const State<D>& state, int groups, const SharedNodes<D>& shared,
                      const NodalPairs<D>& pairs);

} // namespace Rhegma::body_contact
