#include "thermal/Observations.hpp"

#include "archive/Archive.hpp"
#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"

namespace Rhegma::thermal
{

namespace
{

/// Broadcasts a vector from the one rank that has it.
template <int D>
Vector<D> shared(const Ranks& ranks, const Vector<D>& own, bool here)
{
  Vector<D> value = own;
  if (!ranks.many())
    return value;
  // The first of those that have it.
  const double first = -ranks.max(here ? -ranks.rank() : -1e9);
  for (int d = 0; d < D; ++d)
    value[d] = here && first == ranks.rank() ? own[d] : 0.0;
  ranks.sum(&value[0], D);
  return value;
}

} // namespace

template <int D>
Extremes<D> extremes(const State<D>& state)
{
  const auto T = state.particles.scalar(fields::temperature);
  using Most = Kokkos::MaxLoc<double, int>;
  Most::value_type most;
  double least = 0.0;
  const Kokkos::RangePolicy<ExecSpace> every(0, state.particles.size());
  Kokkos::parallel_reduce(
      "rhegma::thermal::highest", every,
      KOKKOS_LAMBDA(const int p, Most::value_type& top) {
        if (T(p) > top.val)
        {
          top.val = T(p);
          top.loc = p;
        }
      },
      Most(most));
  Kokkos::parallel_reduce(
      "rhegma::thermal::lowest", every,
      KOKKOS_LAMBDA(const int p, double& bottom) { bottom = T(p) < bottom ? T(p) : bottom; },
      Kokkos::Min<double>(least));
  Extremes<D> found;
  found.highest = state.ranks.max(most.val);
  found.lowest = -state.ranks.max(-least);
  Vector<D> where{};
  // There is no highest temperature if none is a number.
  const bool here = most.loc >= 0 && most.loc < state.particles.size() && most.val == found.highest;
  if (here)
  {
    const auto row = [&](const std::string& field)
    {
      const auto all = state.particles.template real<D>(field);
      return onHost(Kokkos::subview(all, std::make_pair(most.loc, most.loc + 1), Kokkos::ALL));
    };
    const auto at = row(fields::position);
    for (int d = 0; d < D; ++d)
      where[d] = at(0, d);
    if (state.particles.has(fields::displacement))
    {
      const auto moved = row(fields::displacement);
      for (int d = 0; d < D; ++d)
        where[d] += moved(0, d);
    }
  }
  found.where = shared<D>(state.ranks, where, here);
  return found;
}

template <int D>
double temperatureAt(const State<D>& state, const Vector<D>& position)
{
  const auto T = state.particles.scalar(fields::temperature);
  const auto g = state.particles.template real<D>(fields::temperatureGradient);
  const auto x = state.particles.template real<D>(fields::position);
  using Nearest = Kokkos::MinLoc<double, int>;
  Nearest::value_type nearest;
  constexpr double farthest = 1e300; // the square of a larger distance may be no number
  Kokkos::parallel_reduce(
      "rhegma::thermal::nearest", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, Nearest::value_type& best) {
        double square = 0.0;
        for (int d = 0; d < D; ++d)
          square += (x(p, d) - position[d]) * (x(p, d) - position[d]);
        square = square < farthest ? square : farthest;
        if (square < best.val)
        {
          best.val = square;
          best.loc = p;
        }
      },
      Nearest(nearest));
  Vector<1> value{};
  const bool any = state.particles.size() > 0;
  if (any)
  {
    const int at = nearest.loc;
    double found = 0.0;
    Kokkos::parallel_reduce(
        "rhegma::thermal::probe", Kokkos::RangePolicy<ExecSpace>(at, at + 1),
        KOKKOS_LAMBDA(const int p, double& sum) {
          sum += T(p);
          for (int d = 0; d < D; ++d)
            sum += g(p, d) * (position[d] - x(p, d));
        },
        found);
    value[0] = found;
  }
  const double least = -state.ranks.max(any ? -nearest.val : -1e300);
  return shared<1>(state.ranks, value, any && nearest.val == least)[0];
}

template <int D>
void PeakTemperature<D>::sample(const Extremes<D>& now, double at)
{
  if (!(now.highest > value))
    return;
  value = now.highest;
  where = now.where;
  time = at;
}

template <int D>
std::string PeakTemperature<D>::asText(double initial, double last) const
{
  std::string text =
      "peak temperature " + formatShort(value) + " K (rise " + formatShort(value - initial) + " K) at ";
  for (int d = 0; d < D; ++d)
    text += formatShort(where[d]) + (d + 1 < D ? ", " : " m");
  text += ", t = " + readableTime(time);
  return last < value ? text + "; " + formatShort(last) + " K at the end" : text;
}

template <int D>
void PeakTemperature<D>::serialize(Archive& archive)
{
  archive("value", value);
  archive("where", where);
  archive("time", time);
}

template struct PeakTemperature<2>;
template struct PeakTemperature<3>;
template Extremes<2> extremes(const State<2>&);
template Extremes<3> extremes(const State<3>&);
template double temperatureAt(const State<2>&, const Vector<2>&);
template double temperatureAt(const State<3>&, const Vector<3>&);

} // namespace Rhegma::thermal
