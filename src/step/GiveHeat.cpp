#include "step/GiveHeat.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Rhegma
{

namespace
{

template <int D>
void refuse(const State<D>& state, const std::vector<double>& joules)
{
  if (state.materials.thermo.empty())
    throw std::invalid_argument("heat can't be added: the scene has no section Thermal");
  if (static_cast<int>(joules.size()) != state.particles.size())
    throw std::invalid_argument("heat can't be added: there are " + std::to_string(joules.size()) +
                                " numbers for " + std::to_string(state.particles.size()) + " particles");
  if (!std::all_of(joules.begin(), joules.end(), [](double heat) { return std::isfinite(heat); }))
    throw std::invalid_argument("heat can't be added: that of a particle is not finite");
}

/// Whether a particle would cool to zero kelvin or below, by its present capacity.
template <int D>
bool freezes(const State<D>& state, const View<double*>& heat)
{
  const ThermoTables tables = state.materials.thermo;
  const auto volume = state.particles.scalar(fields::volume);
  const auto temperature = state.particles.scalar(fields::temperature);
  const auto material = state.particles.integer(fields::material);
  int cold = 0;
  Kokkos::parallel_reduce(
      "rhegma::lookForFrost", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, int& count) {
        const double capacity = ThermoPoint(tables, material(p), temperature(p)).capacity();
        count += temperature(p) + heat(p) / volume(p) / capacity > 0.0 ? 0 : 1;
      },
      cold);
  return cold > 0;
}

/// \return the added heat [J]
template <int D>
double giveToParticles(State<D>& state, const View<double*>& heat)
{
  const ThermoTables tables = state.materials.thermo;
  const bool mechanics = state.method.mechanics;
  const auto volume = state.particles.scalar(fields::volume);
  const auto temperature = state.particles.scalar(fields::temperature);
  const auto internal = state.particles.scalar(fields::internalEnergy);
  const auto material = state.particles.integer(fields::material);
  double given = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::giveHeat", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& sum) {
        const double density = heat(p) / volume(p);
        internal(p) += density;
        // In scenes with motion the temperature follows from the internal energy, with the stress.
        temperature(p) =
            mechanics ? temperature(p) + density / ThermoPoint(tables, material(p), temperature(p)).capacity()
                      : temperatureOfHeat(tables, material(p), internal(p));
        sum += heat(p);
      },
      given);
  return given;
}

} // namespace

template <int D>
void giveHeat(State<D>& state, const std::vector<double>& joules)
{
  refuse(state, joules);
  const View<double*> heat("rhegma::givenHeat", joules.size());
  const auto host = Kokkos::create_mirror_view(heat);
  std::copy(joules.begin(), joules.end(), host.data());
  Kokkos::deep_copy(heat, host);
  if (freezes(state, heat))
    throw std::invalid_argument("heat can't be added: a particle would reach zero kelvin or below");
  state.energy.heat += giveToParticles(state, heat);
}

template void giveHeat(State<2>&, const std::vector<double>&);
template void giveHeat(State<3>&, const std::vector<double>&);

} // namespace Rhegma
