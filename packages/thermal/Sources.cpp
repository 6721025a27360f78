#include "thermal/Sources.hpp"

#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "material/Tensors.hpp"

namespace Rhegma::thermal
{

namespace
{

/// Fraction of a particle that lies in a ball, from the distance of its middle: all inside, none outside, and
/// in between over the width of the particle.
template <int D>
struct BallFraction
{
  BorrowedView<double*[D]> position, edge;
  Vector<D> centre;
  double radius;

  KOKKOS_INLINE_FUNCTION double operator()(int p) const
  {
    double square = 0.0;
    for (int d = 0; d < D; ++d)
      square += (position(p, d) - centre[d]) * (position(p, d) - centre[d]);
    const double fraction = 0.5 + (radius - std::sqrt(square)) / edge(p, 0);
    return fraction < 0.0 ? 0.0 : fraction > 1.0 ? 1.0 : fraction;
  }
};

template <int D>
double addBox(const State<D>& state, const Source<D>& source, double density, const View<double*>& supply)
{
  const auto position = state.particles.template real<D>(fields::position);
  const auto volume = state.particles.scalar(fields::volume);
  const Vector<D> lower = source.lower, upper = source.upper;
  double added = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::thermal::addBox", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& sum) {
        for (int d = 0; d < D; ++d)
          if (position(p, d) < lower[d] || position(p, d) > upper[d])
            return;
        supply(p) += density * volume(p);
        sum += density * volume(p);
      },
      added);
  return state.ranks.sum(added);
}

} // namespace

template <int D>
std::vector<Source<D>> readSources(const Teuchos::ParameterList& list)
{
  std::vector<Source<D>> sources;
  for (const std::string& name : sublistNames(list))
  {
    const Teuchos::ParameterList& one = list.sublist(name);
    Source<D> source;
    source.name = name;
    source.ball = one.get<std::string>("Type") == "Ball";
    if (source.ball)
    {
      source.centre = readVector<D>(one, "Centre");
      source.velocity = readVector<D>(one, "Velocity");
      source.radius = one.get<double>("Radius");
      source.power = one.get<double>("Power");
    }
    else
    {
      source.lower = readVector<D>(one, "Lower Corner");
      source.upper = readVector<D>(one, "Upper Corner");
      source.density = one.get<double>("Power Density");
    }
    source.history = TimeFunction::parse(one.get<std::string>("History"));
    sources.push_back(source);
  }
  return sources;
}

template <int D>
double addBall(const State<D>& state, const Vector<D>& centre, double radius, double power,
               const View<double*>& supply)
{
  const BallFraction<D> fraction{state.particles.template real<D>(fields::position),
                                 state.particles.template real<D>(fields::edge), centre, radius};
  const auto volume = state.particles.scalar(fields::volume);
  const Kokkos::RangePolicy<ExecSpace> all(0, state.particles.size());
  double inside = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::thermal::volumeOfBall", all,
      KOKKOS_LAMBDA(const int p, double& sum) { sum += fraction(p) * volume(p); }, inside);
  inside = state.ranks.sum(inside);
  if (!(inside > 0.0))
    return 0.0;
  const double density = power / inside;
  Kokkos::parallel_for(
      "rhegma::thermal::addBall", all,
      KOKKOS_LAMBDA(const int p) { supply(p) += density * fraction(p) * volume(p); });
  return power;
}

template <int D>
double addSource(const State<D>& state, const Source<D>& source, double begin, double dt,
                 const View<double*>& supply)
{
  const double now = source.history.overStep(begin, begin + dt), time = begin + 0.5 * dt;
  if (!source.ball)
    return addBox(state, source, now * source.density, supply);
  return addBall<D>(state, source.centre + time * source.velocity,
                    std::max(source.radius, smallestRadius(state)), now * source.power, supply);
}

std::string unresolved(const std::string& what, double radius, double edge)
{
  if (!(radius < edge))
    return {};
  return what + ": the radius " + formatReal(radius) + " m is smaller than the finest cells of " +
         formatReal(edge) + " m, so the heat is spread over a cell; use cells of " +
         formatReal(0.5 * radius) + " m to resolve it";
}

template struct Source<2>;
template struct Source<3>;
template std::vector<Source<2>> readSources(const Teuchos::ParameterList&);
template std::vector<Source<3>> readSources(const Teuchos::ParameterList&);
template double addBall(const State<2>&, const Vector<2>&, double, double, const View<double*>&);
template double addBall(const State<3>&, const Vector<3>&, double, double, const View<double*>&);
template double addSource(const State<2>&, const Source<2>&, double, double, const View<double*>&);
template double addSource(const State<3>&, const Source<3>&, double, double, const View<double*>&);

} // namespace Rhegma::thermal
