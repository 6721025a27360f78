#include "combustion/FlowSteps.hpp"

#include "state/Subdomain.hpp"
#include "transfer/FacePush.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::combustion
{

namespace
{

/// Reports a gas with which the run can't go on.
template <int D>
void findFailure(State<D>& state, const Burning<D>& b)
{
  if (!b.flow.channel().sound() && state.failure.empty())
    state.failure =
        "Combustion > " + state.cracks.cracks[b.crack].name +
        ": the flowing gas has no volume or no energy left somewhere; raise Initial Gap or lower Time > CFL";
}

} // namespace

template <int D>
void pushByFlow(State<D>& state, const FacePoints<D>& points, Burning<D>& b, const View<double*>& pressure)
{
  Channel& channel = b.flow.channel();
  b.flow.updateCells(points, b.crack, b.cavity, b.gap, b.density);
  if (!b.filled)
  {
    channel.fill(b.startPressure, b.startTemperature);
    b.gas.fillWith(channel.allMass(), channel.allEnergy());
  }
  const double before = b.pressure;
  const bool first = !b.filled;
  b.filled = true;
  b.volume = channel.allVolume();
  findFailure(state, b);
  if (!state.failure.empty())
    return;
  const auto host = onHost(pressure);
  b.pressure = 0.0;
  for (int k = 0; k < channel.size(); ++k)
  {
    const double p = channel.pressure(k);
    host(b.flow.first() + k) = p - b.outside;
    b.pressure += p * channel.volume(k) / b.volume;
  }
  b.slope = !first && state.clock.dt > 0.0 ? (b.pressure - before) / state.clock.dt : 0.0;
  Kokkos::deep_copy(pressure, host);
  publishPressure("rhegma::combustion::publish", state.cracks, points, b.crack, pressure);
  pushFaces("rhegma::combustion::push", state, points, b.crack, pressure);
}

template <int D>
void recordFlow(State<D>& state, const FacePoints<D>& points, Burning<D>& b, const View<double*>& pressure,
                const View<double*>& swept)
{
  // Each rank records its own part.
  state.energy.combustion += workOnFaces("rhegma::combustion::work", state, points, b.crack, pressure);
  Kokkos::deep_copy(swept, 0.0);
  sweptVolumes("rhegma::combustion::sweep", state, points, b.crack, swept);
  const auto p = onHost(pressure);
  const int first = b.flow.first(), count = b.flow.channel().size();
  sumParts(state, swept);
  const auto all = onHost(swept);
  b.supply.opened.resize(count);
  double work = 0.0, volume = 0.0;
  for (int k = 0; k < count; ++k)
  {
    b.supply.opened[k] = all(first + k);
    volume += all(first + k);
    work += (p(first + k) + b.outside) * all(first + k);
  }
  b.supply.work = work;
  b.gas.doWork(work);
  b.swept += volume;
  b.volumeRate = state.clock.dt > 0.0 ? volume / state.clock.dt : 0.0;
}

template <int D>
void prepareFlow(const State<D>& state, const FacePoints<D>& points, const Burning<D>& b,
                 const View<int*>& lit, double most, const View<double*>& depth, const FaceHeating& heating)
{
  const Channel& channel = b.flow.channel();
  const auto burns = onHost(lit);
  const auto size = onHost(points.currentSize);
  const auto depths = onHost(depth), given = onHost(heating.given), conductance = onHost(heating.conductance),
             temperature = onHost(heating.gasTemperature);
  for (int k = 0; k < channel.size(); ++k)
  {
    const int at = b.flow.first() + k;
    const double middle = std::max(channel.pressure(k) + 0.5 * state.clock.dt * b.slope, 0.0);
    depths(at) =
        !b.spent && burns(at) != 0 ? std::min(b.density * b.rate(middle) * state.clock.dt, most) : 0.0;
    given(at) = 0.0;
    // As in a gas of one pressure, of the gas in this cell.
    const double area = 2.0 * size(at) * state.method.thickness;
    const double capacity = channel.mass(k) * b.gas.law().heatCapacity();
    conductance(at) = b.transfer > 0.0
                          ? -std::expm1(-state.clock.dt * b.transfer * area / capacity) * capacity / area
                          : 0.0;
    temperature(at) = channel.temperature(k);
  }
  Kokkos::deep_copy(depth, depths);
  Kokkos::deep_copy(heating.given, given);
  Kokkos::deep_copy(heating.conductance, conductance);
  Kokkos::deep_copy(heating.gasTemperature, temperature);
}

template <int D>
void moveFlow(State<D>& state, const FacePoints<D>& points, Burning<D>& b, const View<double*>& depth,
              double mass, double heat, const View<double*>& heatToFaces)
{
  Channel& channel = b.flow.channel();
  const int first = b.flow.first(), count = channel.size();
  const auto depths = onHost(depth);
  const auto size = onHost(points.currentSize);
  const auto acts = onHost(points.acts);
  const auto gone = onHost(heatToFaces);
  double demand = 0.0;
  for (int k = first; k < first + count; ++k)
    demand += acts(k) != 0 ? depths(k) * size(k) : 0.0;
  b.supply.burnt.assign(count, 0.0);
  b.supply.heat.assign(count, 0.0);
  for (int k = 0; k < count; ++k)
  {
    const double fraction =
        demand > 0.0 && acts(first + k) != 0 ? depths(first + k) * size(first + k) / demand : 0.0;
    b.supply.burnt[k] = fraction * mass;
    b.supply.heat[k] = fraction * heat - (b.heatsFaces() ? gone(first + k) : 0.0);
  }
  if (b.discharge > 0.0)
  {
    const std::array<double, 2> surfaceEnd = surfaceEndAreas(state, b.crack, b.mirrors);
    b.supply.first = {b.discharge * surfaceEnd[0], b.outside};
    b.supply.last = {b.discharge * surfaceEnd[1], b.outside};
  }
  const ChannelLoss loss = channel.advance(state.clock.dt, b.supply, b.density);
  b.gas.recordOutflow(loss.mass, loss.energy);
  b.gas.heatWalls(loss.walls);
  findFailure(state, b);
  if (loss.left > 0.0 && state.failure.empty())
    state.failure = "Combustion > " + state.cracks.cracks[b.crack].name +
                    ": the gas flows so fast that a time step would need more than " +
                    std::to_string(loss.substeps) + " substeps; raise Initial Gap or lower Time > CFL";
}

template void pushByFlow(State<2>&, const FacePoints<2>&, Burning<2>&, const View<double*>&);
template void pushByFlow(State<3>&, const FacePoints<3>&, Burning<3>&, const View<double*>&);
template void recordFlow(State<2>&, const FacePoints<2>&, Burning<2>&, const View<double*>&,
                         const View<double*>&);
template void recordFlow(State<3>&, const FacePoints<3>&, Burning<3>&, const View<double*>&,
                         const View<double*>&);
template void prepareFlow(const State<2>&, const FacePoints<2>&, const Burning<2>&, const View<int*>&, double,
                          const View<double*>&, const FaceHeating&);
template void prepareFlow(const State<3>&, const FacePoints<3>&, const Burning<3>&, const View<int*>&, double,
                          const View<double*>&, const FaceHeating&);
template void moveFlow(State<2>&, const FacePoints<2>&, Burning<2>&, const View<double*>&, double, double,
                       const View<double*>&);
template void moveFlow(State<3>&, const FacePoints<3>&, Burning<3>&, const View<double*>&, double, double,
                       const View<double*>&);

} // namespace Rhegma::combustion
