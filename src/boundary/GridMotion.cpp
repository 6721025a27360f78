#include "boundary/GridMotion.hpp"

#include "state/AtRest.hpp"

#include <limits>
#include <stdexcept>

namespace Rhegma
{

namespace
{

template <int D>
std::string pathOf(const TimedConstraint<D>& timed)
{
  return "Boundaries > " + timed.name;
}

template <int D>
bool moves(const TimedConstraint<D>& timed, int axis)
{
  return timed.constraint.holds[axis] && timed.value[axis] != 0.0;
}

/// Whether a box reaches through the whole domain along an axis.
template <int D>
bool spans(const TimedConstraint<D>& timed, const Grid<D>& lattice, int axis)
{
  return timed.constraint.lower[axis] <= lattice.lower[axis] &&
         timed.constraint.upper[axis] >= lattice.upper[axis];
}

/// Checks one of the other supports against the motion along an axis.
template <int D>
void prepareOther(TimedConstraint<D>& other, const TimedConstraint<D>& leader, const Grid<D>& lattice,
                  int axis)
{
  const bool alike = other.boxMoves && moves(other, axis) && other.value[axis] == leader.value[axis] &&
                     other.history.isSameAs(leader.history);
  if (alike)
    return;
  if (!spans(other, lattice, axis) || other.field)
    throw std::invalid_argument(
        pathOf(leader) + " > Box Motion: the grid can't move along " + "xyz"[axis] + " past " +
        pathOf(other) + ", whose nodes would change; set Box Motion to With Material" +
        (other.field ? "" : ", or let that box span the domain along " + std::string(1, "xyz"[axis])));
  other.constraint.lower[axis] = -std::numeric_limits<double>::max();
  other.constraint.upper[axis] = std::numeric_limits<double>::max();
}

} // namespace

template <int D>
void prepareGridMotion(std::vector<TimedConstraint<D>>& constraints, const State<D>& state, bool cellsChange)
{
  const TimedConstraint<D>* leader = nullptr;
  for (const TimedConstraint<D>& timed : constraints)
    if (timed.gridMoves && leader != nullptr)
      throw std::invalid_argument(pathOf(timed) + " > Box Motion: the grid moves with " + pathOf(*leader) +
                                  " already; set one of them to With Material");
    else if (timed.gridMoves)
      leader = &timed;
  if (leader == nullptr)
    return;
  if (staysAtRest(state) || state.method.handsOver)
    throw std::invalid_argument(pathOf(*leader) + " > Box Motion: the grid moves only in dynamic analyses; "
                                                  "set it to With Material, or Time > Analysis to Dynamic");
  if (cellsChange)
    throw std::invalid_argument(pathOf(*leader) + " > Box Motion: refined cells can't move; set it to With "
                                                  "Material, or remove the section Adaptivity");
  for (TimedConstraint<D>& other : constraints)
    for (int d = 0; d < D; ++d)
      if (&other != leader && moves(*leader, d))
        prepareOther(other, *leader, state.mesh.grid, d);
}

template void prepareGridMotion(std::vector<TimedConstraint<2>>&, const State<2>&, bool);
template void prepareGridMotion(std::vector<TimedConstraint<3>>&, const State<3>&, bool);

} // namespace Rhegma
