#include "combustion/GasReport.hpp"

#include "base/Numbers.hpp"
#include "material/ThermoTables.hpp"
#include "state/Subdomain.hpp"
#include "transfer/PressureReport.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::combustion
{

namespace
{

/// Of each cell, from the first end of the crack to its last [Pa].
std::vector<double> pressuresAlong(const Channel& channel)
{
  std::vector<double> all;
  all.reserve(channel.size());
  for (int k = 0; k < channel.size(); ++k)
    all.push_back(channel.pressure(k));
  return all;
}

/// Depth to which heat has gone into faces since the start, of an erfc profile the root of D t [m]
/// (Carslaw and Jaeger, Conduction of Heat in Solids, 2.5), where it is deepest. Collective.
template <int D>
double heatedDepth(const State<D>& state)
{
  const ThermoTables tables = state.materials.thermo;
  const auto material = state.particles.integer(fields::material);
  const auto temperature = state.particles.scalar(fields::temperature);
  double diffusivity = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::combustion::diffusivity", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& most) {
        const ThermoPoint point(tables, material(p), temperature(p));
        const double now = point.conductivity() / point.capacity();
        most = now > most ? now : most;
      },
      Kokkos::Max<double>(diffusivity));
  diffusivity = std::max(diffusivity, 0.0);
  maxParts(state, &diffusivity, 1);
  return std::sqrt(diffusivity * state.clock.time);
}

/// Warns where cells are too coarse to resolve the temperature of the faces.
template <int D>
void warnOfThinSkin(const State<D>& state, const Burning<D>& b, nlohmann::json& summary)
{
  if (!b.usesFaces() || state.clock.step == 0 || b.hottestFace == 0.0)
    return;
  const double depth = heatedDepth(state), cell = state.mesh.smallestSpacing();
  if (depth >= cell)
    return;
  summary["warnings"].push_back("Combustion > " + state.cracks.cracks[b.crack].name +
                                ": heat has penetrated at most " + readableLength(depth) +
                                " into the faces, less than the finest cells of " + readableLength(cell) +
                                ": face_temperature is a mean over a cell, and the faces are hotter");
}

} // namespace

template <int D>
double massOfParticles(const State<D>& state)
{
  const auto mass = state.particles.scalar(fields::mass);
  double sum = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::combustion::massOfParticles", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& all) { all += mass(p); }, sum);
  sumParts(state, &sum, 1);
  return sum;
}

template <int D>
void sampleGas(State<D>& state, const BurnState<D>& burn)
{
  for (const Burning<D>& b : burn.cracks)
  {
    const std::string& name = state.cracks.cracks[b.crack].name;
    samplePressure(state, b.crack, b.pressure);
    state.sample.row.emplace_back(name + ".burnt_mass", b.gas.burnt());
    state.sample.row.emplace_back(name + ".gas_temperature", b.gas.temperature());
    if (b.flows)
    {
      const std::vector<double> along = pressuresAlong(b.flow.channel());
      const auto ends = std::minmax_element(along.begin(), along.end());
      state.sample.row.emplace_back(name + ".pressure_lowest", along.empty() ? 0.0 : *ends.first);
      state.sample.row.emplace_back(name + ".pressure_highest", along.empty() ? 0.0 : *ends.second);
    }
    if (b.usesFaces())
      state.sample.row.emplace_back(name + ".face_temperature", b.hottestFace);
  }
}

template <int D>
void reportGas(const State<D>& state, const BurnState<D>& burn, nlohmann::json& summary)
{
  double solid = massOfParticles(state), total = burn.startMass, now = solid;
  for (const Burning<D>& b : burn.cracks)
  {
    const Gas& gas = b.gas;
    nlohmann::json& entry = summary["cracks"][b.crack];
    reportPressure(summary, b.crack, b.pressure);
    entry["burnt_mass"] = gas.burnt();
    const double released = gas.burnt() * gas.law().heatCapacity() * gas.law().flameTemperature;
    const double supplied = gas.startEnergy() + released + gas.solidHeat() + gas.passedEnergy();
    // Flowing gas has its mass and energy in its cells; that these agree with the balance is checked here.
    const double mass = b.flows ? b.flow.channel().allMass() : gas.mass();
    const double energy = b.flows ? b.flow.channel().allEnergy() : gas.energy();
    const double removed = gas.workDone() + gas.ventedEnergy() + gas.wallHeat();
    entry["gas"] = {{"mass", mass},
                    {"vented_mass", gas.vented()},
                    {"passed_mass", gas.passed()},
                    {"passed_energy", gas.passedEnergy()},
                    {"temperature", gas.temperature()},
                    {"volume", b.volume},
                    {"energy", energy},
                    {"work", gas.workDone()},
                    {"vented_energy", gas.ventedEnergy()},
                    {"released", released},
                    {"wall_heat", gas.wallHeat()},
                    {"solid_heat", gas.solidHeat()},
                    {"burning_area", b.burningArea},
                    {"energy_kept", supplied > 0.0 ? (energy + removed) / supplied : 1.0}};
    if (b.flows)
      entry["gas"]["pressures"] = pressuresAlong(b.flow.channel());
    if (b.usesFaces())
      entry["gas"]["hottest_face"] = b.hottestFace;
    warnOfThinSkin(state, b, summary);
    total += gas.startMass();
    now += mass + gas.vented();
  }
  summary["combustion"] = {{"solid_mass", solid}, {"mass_kept", now / total}};
}

template double massOfParticles(const State<2>&);
template double massOfParticles(const State<3>&);
template void sampleGas(State<2>&, const BurnState<2>&);
template void sampleGas(State<3>&, const BurnState<3>&);
template void reportGas(const State<2>&, const BurnState<2>&, nlohmann::json&);
template void reportGas(const State<3>&, const BurnState<3>&, nlohmann::json&);

} // namespace Rhegma::combustion
