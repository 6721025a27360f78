#include "boundary/Contradictions.hpp"

#include "base/Numbers.hpp"
#include "boundary/TouchedNodes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace Rhegma
{

namespace
{

/// Times of a run at which values are compared; histories are tables and simple functions.
constexpr int times = 257;

/// Values are equal if they differ by less than this fraction of the largest value of the supports: two
/// expressions of the same motion differ by rounding of that size, also where both are small. Positions of
/// nodes are known to this fraction of a cell.
constexpr double roundOff = 1e-9;

/// A contradiction of two supports.
template <int D>
struct Conflict
{
  Vector<D> position{};
  int axis = 0;
  double time = 0.0, first = 0.0, second = 0.0;
};

/// A support over the run.
template <int D>
struct Motion
{
  const TimedConstraint<D>& timed;
  std::vector<double> factor; ///< at each of the times
  double largestFactor = 0.0;
  double largest = 0.0;         ///< size of a component of the value at any time and position
  std::vector<Vector<D>> shift; ///< of a box that moves, at each of the times [m]; else empty

  Motion(const TimedConstraint<D>& support, double finalTime) : timed(support), factor(times)
  {
    for (int k = 0; k < times; ++k)
    {
      factor[k] = timed.history(finalTime * k / (times - 1));
      largestFactor = std::max(largestFactor, std::fabs(factor[k]));
    }
    if (timed.boxMoves)
      follow(finalTime / (times - 1));
  }

  /// How far the box is from where it was at the start, at one of the times [m].
  Vector<D> shiftAt(int k) const { return shift.empty() ? Vector<D>{} : shift[k]; }

  bool holds(int k, const Vector<D>& x) const { return timed.constraint.appliesAt(x - shiftAt(k)); }

  Vector<D> amplitude(const Vector<D>& position) const
  {
    return timed.field ? (*timed.field)(position) : timed.value;
  }

  /// Variation of a component of the value within the uncertainty of a position.
  double uncertainty(const Vector<D>& position, int component, double spacing) const
  {
    double sum = 0.0;
    for (int d = 0; d < D && timed.field; ++d)
    {
      Vector<D> below = position, above = position;
      below[d] -= roundOff * spacing;
      above[d] += roundOff * spacing;
      sum += std::fabs(amplitude(above)[component] - amplitude(below)[component]);
    }
    return largestFactor * sum;
  }

private:
  /// By the trapezoidal rule. \param interval between the times [s]
  void follow(double interval)
  {
    shift.assign(times, {});
    for (int k = 1; k < times; ++k)
      for (int d = 0; d < D; ++d)
        shift[k][d] =
            shift[k - 1][d] +
            (timed.constraint.holds[d] ? 0.5 * interval * (factor[k - 1] + factor[k]) * timed.value[d] : 0.0);
  }
};

/// Finds the time at which they disagree most. \param first \param last of the times to look at \return
/// whether they disagree at all at a position that both hold
template <int D>
bool disagree(const Motion<D>& a, const Motion<D>& b, const Vector<D>& position, double spacing,
              double finalTime, int first, int last, Conflict<D>& conflict)
{
  const Vector<D> ofA = a.amplitude(position), ofB = b.amplitude(position);
  double most = 0.0;
  for (int d = 0; d < D; ++d)
  {
    if (!a.timed.constraint.holds[d] || !b.timed.constraint.holds[d] || (ofA[d] == 0.0 && ofB[d] == 0.0))
      continue;
    const double slack = roundOff * std::max(a.largest, b.largest) + a.uncertainty(position, d, spacing) +
                         b.uncertainty(position, d, spacing);
    for (int k = first; k <= last; ++k)
    {
      const double one = a.factor[k] * ofA[d], two = b.factor[k] * ofB[d];
      const double apart = std::fabs(one - two);
      if (apart > most && apart > slack)
      {
        most = apart;
        conflict = {position, d, finalTime * k / (times - 1), one, two};
      }
    }
  }
  return most > 0.0;
}

/// Largest size of a component of a support's value at the positions that it holds. Collective.
template <int D>
double largestValue(const Motion<D>& motion, const std::vector<Vector<D>>& positions, const Ranks& ranks)
{
  double largest = 0.0;
  const auto include = [&](const Vector<D>& amplitude)
  {
    for (int d = 0; d < D; ++d)
      if (motion.timed.constraint.holds[d] && std::isfinite(amplitude[d]))
        largest = std::max(largest, std::fabs(amplitude[d]));
  };
  if (!motion.timed.field)
    include(motion.timed.value);
  else
    for (const Vector<D>& position : positions)
      if (motion.timed.constraint.appliesAt(position))
        include(motion.amplitude(position));
  return motion.largestFactor * ranks.max(largest);
}

/// Whether two supports may hold a node along one axis: most pairs need no comparison of nodes.
template <int D>
bool mayMeet(const TimedConstraint<D>& a, const TimedConstraint<D>& b)
{
  bool both = false; // both hold an axis, and not both with velocity zero
  for (int d = 0; d < D; ++d)
    both = both || (a.constraint.holds[d] && b.constraint.holds[d] &&
                    (a.field || b.field || a.value[d] != 0.0 || b.value[d] != 0.0));
  if (!both)
    return false;
  for (int d = 0; d < D; ++d)
    if (!a.constraint.outside && !b.constraint.outside && !a.boxMoves && !b.boxMoves &&
        std::max(a.constraint.lower[d], b.constraint.lower[d]) >
            std::min(a.constraint.upper[d], b.constraint.upper[d]))
      return false;
  return true;
}

/// Whether boxes of which one moves overlap at one of the times.
template <int D>
bool overlap(const Motion<D>& a, const Motion<D>& b, int k)
{
  const NodeConstraint<D>&one = a.timed.constraint, &two = b.timed.constraint;
  for (int d = 0; d < D && !one.outside && !two.outside; ++d)
    if (std::max(one.lower[d] + a.shiftAt(k)[d], two.lower[d] + b.shiftAt(k)[d]) >
        std::min(one.upper[d] + a.shiftAt(k)[d], two.upper[d] + b.shiftAt(k)[d]))
      return false;
  return true;
}

/// The same as findConflict where a box moves: of the material that one of them holds, which moves with it.
template <int D>
bool findMeeting(const Motion<D>& one, const Motion<D>& two, const std::vector<Vector<D>>& positions,
                 double spacing, double finalTime, Conflict<D>& conflict)
{
  for (int k = 0; k < times; ++k)
  {
    if (!overlap(one, two, k))
      continue;
    for (const Motion<D>* const carrier : {&one, &two})
      for (const Vector<D>& position : positions)
      {
        const Vector<D> x =
            position +
            (carrier->shift.empty() ? Vector<D>{} : carrier->shift[k] - carrier->timed.displacement);
        if (one.holds(k, x) && two.holds(k, x) && disagree(one, two, x, spacing, finalTime, k, k, conflict))
          return true;
      }
  }
  return false;
}

/// Checks the nodes of one pair.
template <int D>
bool findConflict(const Motion<D>& one, const Motion<D>& two, const std::vector<Vector<D>>& positions,
                  double spacing, double finalTime, Conflict<D>& conflict)
{
  if (!one.shift.empty() || !two.shift.empty())
    return findMeeting(one, two, positions, spacing, finalTime, conflict);
  for (const Vector<D>& position : positions)
    if (one.timed.constraint.appliesAt(position) && two.timed.constraint.appliesAt(position) &&
        disagree(one, two, position, spacing, finalTime, 0, times - 1, conflict))
      return true;
  return false;
}

template <int D>
std::string asText(const TimedConstraint<D>& a, const TimedConstraint<D>& b, const Conflict<D>& conflict,
                   const Prescribed& what)
{
  std::string position = formatReal(conflict.position[0]);
  for (int d = 1; d < D; ++d)
    position += ", " + formatReal(conflict.position[d]);
  const std::string along = what.hasAxes ? std::string(" along ") + "xyz"[conflict.axis] : "";
  return "Boundaries > " + a.name + ": this and Boundaries > " + b.name + " both prescribe the node {" +
         position + "}" + along + ", at " + formatReal(conflict.first) + " and " +
         formatReal(conflict.second) + " " + what.unit + " (at t = " + readableTime(conflict.time) +
         "); give them one " + what.name + " there, or end one of the boxes a cell before this node";
}

} // namespace

template <int D>
std::string contradictions(const std::vector<TimedConstraint<D>>& constraints, const State<D>& state,
                           double finalTime, const Prescribed& what)
{
  std::string messages;
  bool any = false;
  for (std::size_t a = 0; a < constraints.size(); ++a)
    for (std::size_t b = a + 1; b < constraints.size(); ++b)
      any = any || mayMeet(constraints[a], constraints[b]);
  if (!any)
    return messages;
  const std::vector<Vector<D>> positions = touchedNodes(state);
  std::vector<Motion<D>> motions;
  for (const TimedConstraint<D>& constraint : constraints)
  {
    motions.emplace_back(constraint, finalTime);
    motions.back().largest = largestValue(motions.back(), positions, state.ranks);
  }
  for (std::size_t a = 0; a < constraints.size(); ++a)
    for (std::size_t b = a + 1; b < constraints.size(); ++b)
    {
      if (!mayMeet(constraints[a], constraints[b]))
        continue;
      Conflict<D> conflict;
      const bool here =
          findConflict(motions[a], motions[b], positions, state.mesh.grid.spacing, finalTime, conflict);
      const std::string message =
          state.ranks.firstText(here ? asText(constraints[a], constraints[b], conflict, what) : "");
      if (!message.empty())
        messages += (messages.empty() ? "" : "\n") + message;
    }
  return messages;
}

template std::string contradictions(const std::vector<TimedConstraint<2>>&, const State<2>&, double,
                                    const Prescribed&);
template std::string contradictions(const std::vector<TimedConstraint<3>>&, const State<3>&, double,
                                    const Prescribed&);

} // namespace Rhegma
