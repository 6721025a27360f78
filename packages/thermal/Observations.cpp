#include "thermal/Observations.hpp"

#include "archive/Archive.hpp"
#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"

#include <limits>
#include <utility>

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

/// Where a particle of one rank is now [m], on all ranks. \param here whether it is one of this rank
template <int D>
Vector<D> placeOf(const State<D>& state, int particle, bool here)
{
  Vector<D> where{};
  if (here)
  {
    const auto row = [&](const std::string& field)
    {
      const auto all = state.particles.template real<D>(field);
      return onHost(Kokkos::subview(all, std::make_pair(particle, particle + 1), Kokkos::ALL));
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
  return shared<D>(state.ranks, where, here);
}

/// The highest of sign times the temperatures, times sign. \param where of that particle [m]
template <int D>
double extreme(const State<D>& state, double sign, Vector<D>& where)
{
  const auto T = state.particles.scalar(fields::temperature);
  using Most = Kokkos::MaxLoc<double, int>;
  Most::value_type most;
  Kokkos::parallel_reduce(
      "rhegma::thermal::extreme", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, Most::value_type& top) {
        if (sign * T(p) > top.val)
        {
          top.val = sign * T(p);
          top.loc = p;
        }
      },
      Most(most));
  const double found = state.ranks.max(most.val);
  // There is none if none is a number.
  const bool here = most.loc >= 0 && most.loc < state.particles.size() && most.val == found;
  where = placeOf(state, most.loc, here);
  return sign * found;
}

/// Highest temperature of each body, then its lowest times -1 [K]; of one without particles the lowest
/// number.
template <int D>
std::vector<double> rangesOfBodies(const State<D>& state)
{
  const int count = static_cast<int>(state.bodies.info.size());
  const View<double*> most("rhegma::thermal::most", 2 * count);
  Kokkos::deep_copy(most, std::numeric_limits<double>::lowest());
  const auto T = state.particles.scalar(fields::temperature);
  const auto body = state.particles.integer(fields::body);
  Kokkos::parallel_for(
      "rhegma::thermal::rangesOfBodies", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p) {
        const int b = body(p);
        if (T(p) > most(b)) // so that most particles write nothing
          Kokkos::atomic_fetch_max(&most(b), T(p));
        if (-T(p) > most(count + b))
          Kokkos::atomic_fetch_max(&most(count + b), -T(p));
      });
  const auto host = onHost(most);
  return {host.data(), host.data() + 2 * count};
}

/// Sets the largest difference within a body.
template <int D>
void findDifference(const State<D>& state, Extremes<D>& found)
{
  const std::size_t count = state.bodies.info.size();
  if (count <= 1)
  {
    found.difference = found.highest - found.lowest;
    return;
  }
  std::vector<double> most = rangesOfBodies(state);
  state.ranks.max(most.data(), static_cast<int>(most.size()));
  for (std::size_t b = 0; b < count; ++b)
  {
    const double difference = most[b] + most[count + b];
    if (difference > found.difference)
    {
      found.difference = difference;
      found.body = static_cast<int>(b);
    }
  }
}

/// Position and time of an extreme, as text.
template <int D>
std::string placeAndTime(const ExtremeTemperature<D>& extreme)
{
  std::string text;
  for (int d = 0; d < D; ++d)
    text += formatShort(extreme.where[d]) + (d + 1 < D ? ", " : " m");
  return text + ", t = " + readableTime(extreme.time);
}

} // namespace

template <int D>
Extremes<D> extremes(const State<D>& state)
{
  Extremes<D> found;
  found.highest = extreme(state, 1.0, found.hottest);
  found.lowest = extreme(state, -1.0, found.coldest);
  findDifference(state, found);
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
void ExtremeTemperature<D>::sample(double temperature, const Vector<D>& position, double at, double sign)
{
  if (!(temperature > 0.0) || (value > 0.0 && !(sign * (temperature - value) > 0.0)))
    return;
  value = temperature;
  where = position;
  time = at;
}

template <int D>
nlohmann::json ExtremeTemperature<D>::asJson() const
{
  return {{"value", value}, {"time", time}, {"where", std::vector<double>(where.c, where.c + D)}};
}

template <int D>
void ExtremeTemperature<D>::serialize(Archive& archive)
{
  archive("value", value);
  archive("where", where);
  archive("time", time);
}

template <int D>
void TemperatureRecord<D>::sample(const Extremes<D>& now, double at)
{
  highest.sample(now.highest, now.hottest, at, 1.0);
  lowest.sample(now.lowest, now.coldest, at, -1.0);
  if (!(now.difference > difference))
    return;
  difference = now.difference;
  body = now.body;
  time = at;
}

template <int D>
std::vector<std::string> TemperatureRecord<D>::asText(const State<D>& state, double initial,
                                                      const Extremes<D>& last) const
{
  constexpr double little =
      0.02; // of the other one: conduction overshoots by half of it (docs/explanation/heat.md)
  const double rise = highest.value - initial, fall = initial - lowest.value;
  std::vector<std::string> lines;
  if (rise > little * fall || !(fall > 0.0))
    lines.push_back("peak temperature " + formatShort(highest.value) + " K (rise " + formatShort(rise) +
                    " K) at " + placeAndTime(highest) +
                    (last.highest < highest.value ? "; " + formatShort(last.highest) + " K at the end" : ""));
  if (fall > little * rise && fall > 0.0)
    lines.push_back("lowest temperature " + formatShort(lowest.value) + " K (fall " + formatShort(fall) +
                    " K) at " + placeAndTime(lowest) +
                    (last.lowest > lowest.value ? "; " + formatShort(last.lowest) + " K at the end" : ""));
  if (difference > 0.0)
    lines.push_back(
        "largest difference of temperature within a body " + formatShort(difference) + " K (" +
        state.bodies.info[body].name + ") at t = " + readableTime(time) +
        (last.difference < difference ? "; " + formatShort(last.difference) + " K at the end" : ""));
  return lines;
}

template <int D>
void TemperatureRecord<D>::report(const State<D>& state, nlohmann::json& temperature) const
{
  temperature["highest"] = highest.asJson();
  temperature["coldest"] = lowest.asJson();
  temperature["largest_difference"] = {
      {"value", difference}, {"time", time}, {"body", state.bodies.info[body].name}};
}

template <int D>
void TemperatureRecord<D>::serialize(Archive& archive)
{
  {
    const Archive::Group group(archive, "peak");
    highest.serialize(archive);
  }
  {
    const Archive::Group group(archive, "coldest");
    lowest.serialize(archive);
  }
  const Archive::Group group(archive, "largest difference");
  archive("value", difference);
  archive("body", body);
  archive("time", time);
}

template struct ExtremeTemperature<2>;
template struct ExtremeTemperature<3>;
template struct TemperatureRecord<2>;
template struct TemperatureRecord<3>;
template Extremes<2> extremes(const State<2>&);
template Extremes<3> extremes(const State<3>&);
template double temperatureAt(const State<2>&, const Vector<2>&);
template double temperatureAt(const State<3>&, const Vector<3>&);

} // namespace Rhegma::thermal
