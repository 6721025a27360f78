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

/// Where two supports disagree.
template <int D>
struct Quarrel
{
  Vector<D> place;
  int axis = 0;
  double time = 0.0, first = 0.0, second = 0.0;
};

/// A support's factor over the run.
template <int D>
std::vector<double> factors(const TimedConstraint<D>& timed, double finalTime)
{
  std::vector<double> values(times);
  for (int k = 0; k < times; ++k)
    values[k] = timed.history(finalTime * k / (times - 1));
  return values;
}

template <int D>
Vector<D> amplitude(const TimedConstraint<D>& timed, const Vector<D>& place)
{
  return timed.field ? (*timed.field)(place) : timed.value;
}

/// Finds the time at which they disagree most. \return whether they disagree at all at a place that both hold
template <int D>
bool disagree(const TimedConstraint<D>& a, const TimedConstraint<D>& b, const std::vector<double>& factorOfA,
              const std::vector<double>& factorOfB, const Vector<D>& place, double finalTime,
              Quarrel<D>& quarrel)
{
  const Vector<D> ofA = amplitude(a, place), ofB = amplitude(b, place);
  double most = 0.0;
  for (int d = 0; d < D; ++d)
  {
    if (!a.constraint.holds[d] || !b.constraint.holds[d] || (ofA[d] == 0.0 && ofB[d] == 0.0))
      continue;
    for (int k = 0; k < times; ++k)
    {
      const double one = factorOfA[k] * ofA[d], two = factorOfB[k] * ofB[d];
      const double apart = std::fabs(one - two);
      if (apart > most && apart > 1e-12 * std::max(std::fabs(one), std::fabs(two)))
      {
        most = apart;
        quarrel = {place, d, finalTime * k / (times - 1), one, two};
      }
    }
  }
  return most > 0.0;
}

/// Looks at the nodes of one pair near the particles of this rank.
template <int D, class Places, class Boxes>
bool findQuarrel(const TimedConstraint<D>& a, const TimedConstraint<D>& b, const Grid<D>& grid,
                 const Places& position, const Boxes& edge, double finalTime, Quarrel<D>& quarrel)
{
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
  const std::vector<double> factorOfA = factors(a, finalTime), factorOfB = factors(b, finalTime);
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
      if (a.constraint.appliesAt(place) && b.constraint.appliesAt(place) &&
          disagree(a, b, factorOfA, factorOfB, place, finalTime, quarrel))
        return true;
    }
  }
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
  const auto position = Kokkos::create_mirror_view_and_copy(
      Kokkos::HostSpace{}, state.particles.template real<D>(fields::position));
  const auto edge = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                        state.particles.template real<D>(fields::edge));
  for (std::size_t a = 0; a < constraints.size(); ++a)
    for (std::size_t b = a + 1; b < constraints.size(); ++b)
    {
      Quarrel<D> quarrel;
      const bool here =
          findQuarrel(constraints[a], constraints[b], state.grid, position, edge, finalTime, quarrel);
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
