#include "boundary/Contradictions.hpp"

#include "scene/Numbers.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace Rhegma
{

namespace
{

/// Times of a run at which velocities are compared; histories are tables and simple functions.
constexpr int times = 257;

/// Velocities are one if they are apart by less than this share of the largest velocity of either support:
/// two spellings of one motion differ by roundings of that size, also where both are small. Places of nodes
/// are known to this share of a cell.
constexpr double roundOff = 1e-9;

/// Where two supports disagree.
template <int D>
struct Quarrel
{
  Vector<D> place;
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
  double largest = 0.0; ///< size of a component of velocity at any time and place [m/s]

  Motion(const TimedConstraint<D>& support, double finalTime) : timed(support), factor(times)
  {
    for (int k = 0; k < times; ++k)
    {
      factor[k] = timed.history(finalTime * k / (times - 1));
      largestFactor = std::max(largestFactor, std::fabs(factor[k]));
    }
  }

  Vector<D> amplitude(const Vector<D>& place) const
  {
    return timed.field ? (*timed.field)(place) : timed.value;
  }

  /// By how much a component of the velocity varies about a place within what is known of the place.
  double uncertainty(const Vector<D>& place, int component, double spacing) const
  {
    double sum = 0.0;
    for (int d = 0; d < D && timed.field; ++d)
    {
      Vector<D> below = place, above = place;
      below[d] -= roundOff * spacing;
      above[d] += roundOff * spacing;
      sum += std::fabs(amplitude(above)[component] - amplitude(below)[component]);
    }
    return largestFactor * sum;
  }
};

/// Finds the time at which they disagree most. \return whether they disagree at all at a place that both hold
template <int D>
bool disagree(const Motion<D>& a, const Motion<D>& b, const Vector<D>& place, double spacing,
              double finalTime, Quarrel<D>& quarrel)
{
  const Vector<D> ofA = a.amplitude(place), ofB = b.amplitude(place);
  double most = 0.0;
  for (int d = 0; d < D; ++d)
  {
    if (!a.timed.constraint.holds[d] || !b.timed.constraint.holds[d] || (ofA[d] == 0.0 && ofB[d] == 0.0))
      continue;
    const double slack = roundOff * std::max(a.largest, b.largest) + a.uncertainty(place, d, spacing) +
                         b.uncertainty(place, d, spacing);
    for (int k = 0; k < times; ++k)
    {
      const double one = a.factor[k] * ofA[d], two = b.factor[k] * ofB[d];
      const double apart = std::fabs(one - two);
      if (apart > most && apart > slack)
      {
        most = apart;
        quarrel = {place, d, finalTime * k / (times - 1), one, two};
      }
    }
  }
  return most > 0.0;
}

/// Places of the nodes near the particles of this rank.
template <int D>
std::vector<Vector<D>> nodesNearParticles(const State<D>& state)
{
  const Grid<D>& grid = state.grid;
  const auto position = Kokkos::create_mirror_view_and_copy(
      Kokkos::HostSpace{}, state.particles.template real<D>(fields::position));
  const auto edge = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                        state.particles.template real<D>(fields::edge));
  std::vector<Vector<D>> places;
  std::vector<char> seen(grid.numNodes, 0);
  for (std::size_t p = 0; p < position.extent(0); ++p)
  {
    int first[D], count[D], all = 1;
    for (int d = 0; d < D; ++d)
    {
      // Functions that are averaged over the particle's box reach by half of it further.
      const double half = (grid.spacing + 0.5 * edge(p, d)) * (1.0 - 1e-9);
      first[d] = static_cast<int>(std::ceil(grid.inCells(position(p, d) - half, d)));
      count[d] = static_cast<int>(std::floor(grid.inCells(position(p, d) + half, d))) - first[d] + 1;
      all *= count[d];
    }
    for (int k = 0; k < all; ++k)
    {
      Vector<D> place;
      int rest = k, node = 0;
      for (int d = 0; d < D; ++d)
      {
        const int index = first[d] + rest % count[d];
        place[d] = grid.origin[d] + index * grid.spacing;
        node += index * grid.stride[d];
        rest /= count[d];
      }
      if (node < 0 || node >= grid.numNodes || seen[node] != 0)
        continue;
      seen[node] = 1;
      places.push_back(place);
    }
  }
  return places;
}

/// Largest size of a component of a support's velocity at the places that it holds. Collective.
template <int D>
double largestVelocity(const Motion<D>& motion, const std::vector<Vector<D>>& places, const Ranks& ranks)
{
  double largest = 0.0;
  const auto look = [&](const Vector<D>& amplitude)
  {
    for (int d = 0; d < D; ++d)
      if (motion.timed.constraint.holds[d] && std::isfinite(amplitude[d]))
        largest = std::max(largest, std::fabs(amplitude[d]));
  };
  if (!motion.timed.field)
    look(motion.timed.value);
  else
    for (const Vector<D>& place : places)
      if (motion.timed.constraint.appliesAt(place))
        look(motion.amplitude(place));
  return motion.largestFactor * ranks.max(largest);
}

/// Looks at the nodes of one pair.
template <int D>
bool findQuarrel(const Motion<D>& one, const Motion<D>& two, const std::vector<Vector<D>>& places,
                 double spacing, double finalTime, Quarrel<D>& quarrel)
{
  const TimedConstraint<D>&a = one.timed, &b = two.timed;
  bool both = false; // hold an axis, and not both at rest
  for (int d = 0; d < D; ++d)
    both = both || (a.constraint.holds[d] && b.constraint.holds[d] &&
                    (a.field || b.field || a.value[d] != 0.0 || b.value[d] != 0.0));
  if (!both)
    return false;
  for (int d = 0; d < D; ++d)
    if (!a.constraint.outside && !b.constraint.outside &&
        std::max(a.constraint.lower[d], b.constraint.lower[d]) >
            std::min(a.constraint.upper[d], b.constraint.upper[d]))
      return false;
  for (const Vector<D>& place : places)
    if (a.constraint.appliesAt(place) && b.constraint.appliesAt(place) &&
        disagree(one, two, place, spacing, finalTime, quarrel))
      return true;
  return false;
}

template <int D>
std::string inWords(const TimedConstraint<D>& a, const TimedConstraint<D>& b, const Quarrel<D>& quarrel)
{
  std::string place = formatReal(quarrel.place[0]);
  for (int d = 1; d < D; ++d)
    place += ", " + formatReal(quarrel.place[d]);
  return "Boundaries > " + a.name + ": this and Boundaries > " + b.name + " both hold the node {" + place +
         "} along " + "xyz"[quarrel.axis] + ", at " + formatReal(quarrel.first) + " and " +
         formatReal(quarrel.second) + " m/s (at " + formatReal(quarrel.time) +
         " s); give them one velocity there or let one of their boxes end a cell before it";
}

} // namespace

template <int D>
std::string contradictions(const std::vector<TimedConstraint<D>>& constraints, const State<D>& state,
                           double finalTime)
{
  std::string sentences;
  if (constraints.size() < 2)
    return sentences;
  const std::vector<Vector<D>> places = nodesNearParticles(state);
  std::vector<Motion<D>> motions;
  for (const TimedConstraint<D>& constraint : constraints)
  {
    motions.emplace_back(constraint, finalTime);
    motions.back().largest = largestVelocity(motions.back(), places, state.ranks);
  }
  for (std::size_t a = 0; a < constraints.size(); ++a)
    for (std::size_t b = a + 1; b < constraints.size(); ++b)
    {
      Quarrel<D> quarrel;
      const bool here = findQuarrel(motions[a], motions[b], places, state.grid.spacing, finalTime, quarrel);
      const std::string sentence =
          state.ranks.firstText(here ? inWords(constraints[a], constraints[b], quarrel) : "");
      if (!sentence.empty())
        sentences += (sentences.empty() ? "" : "\n") + sentence;
    }
  return sentences;
}

template std::string contradictions(const std::vector<TimedConstraint<2>>&, const State<2>&, double);
template std::string contradictions(const std::vector<TimedConstraint<3>>&, const State<3>&, double);

} // namespace Rhegma
