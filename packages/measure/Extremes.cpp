#include "measure/Extremes.hpp"

#include "state/ParticleDamage.hpp"
#include "state/ParticlePlace.hpp"
#include "state/ParticleStress.hpp"

#include <limits>
#include <stdexcept>

namespace Rhegma::measure
{

namespace
{

template <int D>
struct VonMisesOf
{
  ParticleStress<D> stress;
  KOKKOS_INLINE_FUNCTION double operator()(int p) const { return stress.vonMises(p); }
};

/// Length of a vector of particles, or of the difference of two.
template <int D>
struct LengthOf
{
  BorrowedView<double* [D]> vector;
  KOKKOS_INLINE_FUNCTION double operator()(int p) const
  {
    double square = 0.0;
    for (int d = 0; d < D; ++d)
      square += vector(p, d) * vector(p, d);
    return std::sqrt(square);
  }
};

template <int D>
struct DisplacementOf
{
  ParticlePlace<D> place;
  KOKKOS_INLINE_FUNCTION double operator()(int p) const
  {
    double square = 0.0;
    for (int d = 0; d < D; ++d)
      square += place.moved(p, d) * place.moved(p, d);
    return std::sqrt(square);
  }
};

struct TemperatureOf
{
  BorrowedView<double*> temperature;
  KOKKOS_INLINE_FUNCTION double operator()(int p) const { return temperature(p); }
};

/// The position of a particle that one or several ranks found: that of the first of these ranks.
template <int D>
Vector<D> positionOf(const State<D>& state, int particle, bool here)
{
  Vector<D> where{};
  if (here)
  {
    const auto row = [&](const std::string& field)
    {
      const auto all = state.particles.template real<D>(field);
      const auto one = onHost(Kokkos::subview(all, std::make_pair(particle, particle + 1), Kokkos::ALL));
      Vector<D> values;
      for (int d = 0; d < D; ++d)
        values[d] = one(0, d);
      return values;
    };
    where = row(fields::position);
    if (state.particles.has(fields::displacement))
      where = where + row(fields::displacement);
  }
  if (!state.ranks.many())
    return where;
  const double first = -state.ranks.max(here ? -state.ranks.rank() : -1e9);
  if (!here || first != state.ranks.rank())
    where = Vector<D>{};
  state.ranks.sum(where.c, D);
  return where;
}

/// The largest of sign times the values.
template <int D, class Value>
Extreme<D> extremeWith(const State<D>& state, int body, double sign, const Value& value)
{
  using Most = Kokkos::MaxLoc<double, int>;
  Most::value_type most;
  const auto bodyOf = state.particles.integer(fields::body);
  Kokkos::parallel_reduce(
      "rhegma::measure::extreme", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, Most::value_type& top) {
        if (body >= 0 && bodyOf(p) != body)
          return;
        const double here = sign * value(p);
        if (here > top.val)
        {
          top.val = here;
          top.loc = p;
        }
      },
      Most(most));
  const bool any = most.loc >= 0 && most.loc < state.particles.size();
  constexpr double none = std::numeric_limits<double>::lowest();
  const double best = state.ranks.max(any ? most.val : none);
  Extreme<D> found;
  found.value = best > none ? sign * best : std::numeric_limits<double>::quiet_NaN();
  found.where = positionOf(state, most.loc, any && most.val == best);
  return found;
}

template <int D, class Value>
Extremes<D> extremesWith(const State<D>& state, int body, const Value& value)
{
  return {extremeWith(state, body, 1.0, value), extremeWith(state, body, -1.0, value)};
}

} // namespace

const std::vector<std::string>& measurableFields()
{
  static const std::vector<std::string> names = {
      "Principal Stress", "Von Mises Stress", "Energy Density", "Damage", "Speed",
      "Displacement",     "Temperature"};
  return names;
}

template <int D>
Extremes<D> extremesOf(const State<D>& state, const std::string& field, int body)
{
  const FieldTable& particles = state.particles;
  if (field == "Principal Stress")
    return extremesWith(state, body, PrincipalStressOf<D>{ParticleStress<D>(particles)});
  if (field == "Von Mises Stress")
    return extremesWith(state, body, VonMisesOf<D>{ParticleStress<D>(particles)});
  if (field == "Energy Density")
    return extremesWith(state, body, EnergyDensityOf<D>{ParticleEnergy<D>(state)});
  if (field == "Damage")
    return extremesWith(state, body, DamageOf<D>(state));
  if (field == "Speed")
    return extremesWith(state, body, LengthOf<D>{particles.template real<D>(fields::velocity)});
  if (field == "Displacement")
    return extremesWith(state, body, DisplacementOf<D>{ParticlePlace<D>(particles)});
  if (field == "Temperature")
    return extremesWith(state, body, TemperatureOf{particles.scalar(fields::temperature)});
  throw std::invalid_argument("no field \"" + field + "\" can be measured");
}

template Extremes<2> extremesOf(const State<2>&, const std::string&, int);
template Extremes<3> extremesOf(const State<3>&, const std::string&, int);

} // namespace Rhegma::measure
