#include "step/HeatFailure.hpp"

#include "base/Numbers.hpp"

namespace Rhegma
{

template <int D>
std::string heatFailure(const State<D>& state)
{
  if (state.materials.thermo.empty() || !state.particles.has(fields::temperature))
    return {};
  const auto temperature = state.particles.scalar(fields::temperature);
  const auto material = state.particles.integer(fields::material);
  const ThermoTables tables = state.materials.thermo;
  double coldest = 1e300, smallest = 1e300;
  Kokkos::parallel_reduce(
      "rhegma::findColdest", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& T, double& theta) {
        T = temperature(p) < T ? temperature(p) : T;
        const double here = ThermoPoint(tables, material(p), temperature(p)).stretch();
        theta = here < theta ? here : theta;
      },
      Kokkos::Min<double>(coldest), Kokkos::Min<double>(smallest));
  if (!(coldest > 0.0))
    return "the temperature of a particle is " + formatReal(coldest) +
           " K, and it is absolute; check the heat sources, the outgoing heat fluxes and Specific Heat";
  if (!(smallest > 0.0))
    return "thermal strain shortens a particle to " + formatReal(smallest) +
           " of its length; check Thermal Expansion and the temperatures";
  return {};
}

template std::string heatFailure(const State<2>&);
template std::string heatFailure(const State<3>&);

} // namespace Rhegma
