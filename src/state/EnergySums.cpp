#include "state/EnergySums.hpp"

#include "state/ParticleEnergy.hpp"

#include <cmath>

namespace Rhegma
{

namespace
{

/// Heat is accurate to the rounding of absolute temperatures, accumulated by conduction: this fraction of
/// capacity times temperature.
constexpr double roundingOfHeat = 1e-12;

/// Strains of rounding: forces that cancel leave such strains, whose energy per volume is their square times
/// the modulus.
constexpr double roundingOfStrain = 1e-15;

/// Sums of all particles: kinetic, strain, plastic and internal energy, the rounding error of energies,
/// momentum. An array reduction in a single pass.
template <int D>
struct ParticleSums
{
  using value_type = double[];
  using size_type = int;
  using execution_space = ExecSpace;

  static constexpr int momentumAt = 5, size = momentumAt + D;
  int value_count = size;
  ParticleEnergy<D> energy;
  BorrowedView<double*> internal; ///< empty without heat
  double smallest;                ///< energy per mass of strains of rounding [J/kg]

  KOKKOS_INLINE_FUNCTION void operator()(const int p, double* sum) const
  {
    sum[0] += energy.kinetic(p);
    sum[1] += energy.strain(p);
    sum[2] += energy.dissipated(p);
    if (internal.extent(0) > 0)
    {
      sum[3] += energy.volume(p) * internal(p);
      const double T = energy.temperature(p);
      const double heat = ThermoPoint(energy.thermo, energy.material(p), T).capacity() * T;
      // 1e-10: of sums over many particles.
      sum[4] += energy.volume(p) * (1e-10 * std::fabs(internal(p)) + roundingOfHeat * heat);
    }
    sum[4] += energy.mechanics ? smallest * energy.mass(p) : 0.0;
    for (int d = 0; d < D; ++d)
      sum[momentumAt + d] += energy.mechanics ? energy.mass(p) * energy.velocity(p, d) : 0.0;
  }

  explicit ParticleSums(const State<D>& state)
      : energy(state), smallest(std::pow(roundingOfStrain * state.clock.fastestSpeed, 2))
  {
    if (!state.materials.thermo.empty())
      internal = state.particles.scalar(fields::internalEnergy);
  }
};

} // namespace

template <int D>
void measureEnergy(State<D>& state)
{
  using Sums = ParticleSums<D>;
  double sum[Sums::size] = {};
  Kokkos::parallel_reduce("rhegma::measureEnergy", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
                          Sums(state), sum);
  state.ranks.sum(sum, Sums::size);
  state.energy.kinetic = sum[0];
  state.energy.strain = sum[1] + state.ranks.sum(state.energy.springs);
  state.energy.plastic = sum[2];
  if (!state.materials.thermo.empty())
    state.energy.thermal = sum[3] - sum[1] - sum[2] - state.energy.thermalStart;
  state.energy.roundOff = std::isfinite(sum[4]) ? sum[4] : 0.0;
  for (int d = 0; d < D; ++d)
    state.sample.momentum[d] = sum[Sums::momentumAt + d];
  state.sample.step = state.clock.step;
}

template <int D>
double errorOfThermalPath(const State<D>& state)
{
  if (state.materials.thermo.empty() || !state.method.mechanics)
    return 0.0;
  const ThermoTables tables = state.materials.thermo;
  const auto volume = state.particles.scalar(fields::volume);
  const auto temperature = state.particles.scalar(fields::temperature);
  const auto material = state.particles.integer(fields::material);
  double energy = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::errorOfThermalPath", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& sum) {
        const ThermoPoint at(tables, material(p), temperature(p));
        const double strain = at.stretch() - 1.0;
        sum += volume(p) * 4.5 * at.properties().bulk * strain * strain * std::fabs(strain);
      },
      energy);
  energy = state.ranks.sum(energy);
  return std::isfinite(energy) ? energy : 0.0;
}

template <int D>
EnergyBalance energyOfAllRanks(const State<D>& state)
{
  constexpr double EnergyBalance::*recorded[] = {
      &EnergyBalance::externalWork, &EnergyBalance::damped,     &EnergyBalance::contact,
      &EnergyBalance::fracture,     &EnergyBalance::merged,     &EnergyBalance::combustion,
      &EnergyBalance::heat,         &EnergyBalance::stabilised, &EnergyBalance::filtered};
  constexpr int count = sizeof(recorded) / sizeof(*recorded);
  EnergyBalance all = state.energy;
  if (!state.ranks.many())
    return all;
  double since[count];
  for (int k = 0; k < count; ++k)
    since[k] = state.energy.*recorded[k] - state.sample.energy.*recorded[k];
  state.ranks.sum(since, count);
  for (int k = 0; k < count; ++k)
    all.*recorded[k] = state.sample.energy.*recorded[k] + since[k];
  return all;
}

template <int D>
void sumEnergyBalance(State<D>& state)
{
  if (state.ranks.many())
    state.sample.energy = state.energy = energyOfAllRanks(state);
}

template void measureEnergy(State<2>&);
template void measureEnergy(State<3>&);
template double errorOfThermalPath(const State<2>&);
template double errorOfThermalPath(const State<3>&);
template EnergyBalance energyOfAllRanks(const State<2>&);
template EnergyBalance energyOfAllRanks(const State<3>&);
template void sumEnergyBalance(State<2>&);
template void sumEnergyBalance(State<3>&);

} // namespace Rhegma
