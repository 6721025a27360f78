#include "body_contact/PressedPairs.hpp"

#include "base/SmallLoops.hpp"

#include <algorithm>

namespace Rhegma::body_contact
{

namespace
{

std::string nameOf(int k)
{
  return "last step of pressing on each other" + (k == 0 ? "" : ", pair " + std::to_string(k + 1));
}

/// Stores the pairs of a shared node that press.
template <int D>
struct KeepPressed
{
  NodalPairs<D> pairs;
  PressedPairs pressed;
  double now; ///< number of this step, from 1 on

  KOKKOS_INLINE_FUNCTION void operator()(const int s) const
  {
    int kept = 0;
    for (int q = pairs.first(s); q < pairs.first(s + 1); ++q)
      if (presses(q))
        kept = keep(pairs.node(q), pressed.codeOf(now, pairs.group(q, 0), pairs.group(q, 1)), kept);
  }

  KOKKOS_INLINE_FUNCTION bool presses(int q) const
  {
    bool any = false;
    for (int d = 0; d < D; ++d)
      any = any || pairs.impulse(q, d) != 0.0;
    return any && !pairs.springs.join(q);
  }

  /// Two groups have two pairs of fields next to a crack. \return number of codes of the node now
  KOKKOS_INLINE_FUNCTION int keep(int node, double code, int kept) const
  {
    for (int k = 0; k < kept; ++k)
      if (pressed.code[k](node) == code)
        return kept;
    pressed.code[kept](node) = code;
    return kept + 1;
  }
};

} // namespace

std::vector<NodalField> pressedPairsFields(int groups)
{
  std::vector<NodalField> fields;
  for (int k = 0; k < std::min(pairsOf(groups), mostPressed); ++k)
    fields.push_back(
        {{nameOf(k), 1, "", "number of the step, from 1 on, times that of pairs of groups, and the pair"},
         OnRemesh::Keep});
  return fields;
}

template <int D>
PressedPairs pressedPairs(const State<D>& state, int groups)
{
  PressedPairs pressed;
  pressed.pairs = pairsOf(groups);
  pressed.count = std::min(pressed.pairs, mostPressed);
  pressed.step = static_cast<double>(state.clock.step);
  for (int k = 0; k < pressed.count; ++k)
    pressed.code[k] = state.mesh.nodalFields.scalar(nameOf(k));
  return pressed;
}

template <int D>
void keepPressedPairs(const State<D>& state, int groups, const SharedNodes<D>& shared,
                      const NodalPairs<D>& pairs)
{
  const PressedPairs pressed = pressedPairs(state, groups);
  const KeepPressed<D> keep{pairs, pressed, pressed.step + 1.0};
  parallelForSmall("rhegma::keepPressedPairs", shared.count, keep);
}

template PressedPairs pressedPairs(const State<2>&, int);
template PressedPairs pressedPairs(const State<3>&, int);
template void keepPressedPairs(const State<2>&, int, const SharedNodes<2>&, const NodalPairs<2>&);
template void keepPressedPairs(const State<3>&, int, const SharedNodes<3>&, const NodalPairs<3>&);

} // namespace Rhegma::body_contact
