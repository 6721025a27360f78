#include "combustion/GasStep.hpp"

#include "combustion/FlowSteps.hpp"
#include "state/Subdomain.hpp"
#include "transfer/FacePush.hpp"

#include <cmath>

namespace Rhegma::combustion
{

namespace
{

/// Largest opening behind a front [cells]: beyond it the volume of the cavity is more than 15 % off (unit
/// test Cavity).
constexpr double wideOpen = 2.0;

template <int D>
void warnOfWideOpening(State<D>& state, Burning<D>& b, double opening)
{
  bool ends = false; // halves that fly apart sweep what they move
  for (const CrackFront<D>& front : state.cracks.fronts)
    ends = ends || (front.crack == b.crack && !front.ended);
  if (b.wide || !ends || opening < wideOpen * state.mesh.smallestSpacing())
    return;
  b.wide = true;
  state.warnings.push_back("Combustion > " + state.cracks.cracks[b.crack].name +
                           ": its faces are more than two of the finest cells apart; from there on its gas "
                           "volume may be more than 15 % too large; use smaller cells");
}

} // namespace

template <int D>
void pushByGas(State<D>& state, const BurnState<D>& burn, Burning<D>& b)
{
  const FacePoints<D>& points = burn.points;
  const Cavity capacity = measureCavity(state, points, b.crack, burn.fire.burning());
  const std::string& name = state.cracks.cracks[b.crack].name;
  b.faces = 2.0 * capacity.felt;
  b.felt = b.felt || capacity.felt > 0.0;
  if (!b.felt)
    state.failure = "Combustion > " + name +
                    ": no face of this crack lies in a body, so nothing can burn; move the crack into a body";
  warnOfWideOpening(state, b, capacity.widest);
  if (b.flows)
  {
    if (state.failure.empty())
      pushByFlow(state, points, b, burn.pressure);
    return;
  }
  b.volume = b.cavity + b.gap * capacity.area + b.swept + b.gas.burnt() / b.density;
  const double before = b.pressure;
  if (!b.filled)
    b.gas.fill(b.startPressure, b.startTemperature, b.volume);
  if (!(b.volume > b.gas.leastVolume()))
    state.failure = "Combustion > " + name +
                    ": there is no gas volume left, because the faces are too close; raise Initial Gap or "
                    "Cavity Volume, or add the section Contact";
  b.pressure = b.gas.pressure(b.volume);
  if (!std::isfinite(b.pressure))
    state.failure = "Combustion > " + name + ": the pressure is not finite";
  if (!state.failure.empty())
    return;
  b.slope = b.filled && state.clock.dt > 0.0 ? (b.pressure - before) / state.clock.dt : 0.0;
  b.filled = true;
  publishPressure("rhegma::combustion::publish", state.cracks, b.crack, b.pressure - b.outside);
  pushFaces("rhegma::combustion::push", state, points, b.crack, b.pressure - b.outside);
}

template <int D>
void recordGasWork(State<D>& state, const BurnState<D>& burn, Burning<D>& b)
{
  const FacePoints<D>& points = burn.points;
  if (b.flows)
    return recordFlow(state, points, b, burn.pressure, burn.swept);
  // Each rank records its own part.
  state.energy.combustion +=
      workOnFaces("rhegma::combustion::work", state, points, b.crack, b.pressure - b.outside);
  sweptVolumes("rhegma::combustion::sweep", state, points, b.crack, burn.swept);
  const View<double*> volumes = burn.swept;
  const View<int*> of = points.crack;
  const int crack = b.crack;
  double swept = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::combustion::swept", Kokkos::RangePolicy<ExecSpace>(0, points.count()),
      KOKKOS_LAMBDA(const int k, double& sum) { sum += of(k) == crack ? volumes(k) : 0.0; }, swept);
  sumParts(state, &swept, 1);
  b.gas.doWork(b.pressure * swept);
  b.swept += swept;
  b.volumeRate = state.clock.dt > 0.0 ? swept / state.clock.dt : 0.0;
  if (!(b.gas.energy() > 0.0))
    state.failure = "Combustion > " + state.cracks.cracks[b.crack].name +
                    ": the gas has done more work than it has energy; lower Time > CFL";
}

template void pushByGas(State<2>&, const BurnState<2>&, Burning<2>&);
template void pushByGas(State<3>&, const BurnState<3>&, Burning<3>&);
template void recordGasWork(State<2>&, const BurnState<2>&, Burning<2>&);
template void recordGasWork(State<3>&, const BurnState<3>&, Burning<3>&);

} // namespace Rhegma::combustion
