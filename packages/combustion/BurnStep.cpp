#include "combustion/BurnStep.hpp"

#include "base/Numbers.hpp"
#include "combustion/FlowSteps.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::combustion
{

namespace
{

/// Fraction of the demanded mass that the particles must provide for a crack to go on burning.
constexpr double leastFuel = 0.5;

/// Distance of the faces from which the particles next to them may be too far from the crack line to have
/// stored stencils [finest cells].
constexpr double farApart = 2.0;

/// The highest temperature of the faces of a crack [K].
template <int D>
double hottest(const FacePoints<D>& points, int crack, const View<double* [2]>& temperature)
{
  const View<int*> of = points.crack;
  double highest = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::combustion::hottest", Kokkos::RangePolicy<ExecSpace>(0, points.count()),
      KOKKOS_LAMBDA(const int k, double& most) {
        for (int side = 0; side < 2 && of(k) == crack; ++side)
          most = temperature(k, side) > most ? temperature(k, side) : most;
      },
      Kokkos::Max<double>(highest));
  return highest;
}

/// The mass that each face should lose in this step, and how the gas heats it. \param most that may burn
/// [kg/m2]
template <int D>
void prepareFaces(const State<D>& state, const BurnState<D>& burn, const Burning<D>& b, double most)
{
  if (b.flows)
    return prepareFlow(state, burn.points, b, burn.fire.burning(), most, burn.depth, burn.heating);
  const double middle = std::max(b.pressure + 0.5 * state.clock.dt * b.slope, 0.0);
  const double depth = std::min(b.density * b.rate(middle) * state.clock.dt, most);
  const View<int*> of = burn.points.crack, alight = burn.fire.burning();
  const View<double*> depths = burn.depth;
  const FaceHeating heating = burn.heating;
  const int crack = b.crack;
  const bool burns = !b.spent;
  // Gas between walls without burning approaches their temperature as exp(-h A t / (m c_v)).
  const double capacity = b.gas.mass() * b.gas.law().heatCapacity();
  const double exchange = state.clock.dt * b.transfer * b.faces / capacity;
  const double conductance = exchange > 0.0 ? -std::expm1(-exchange) * capacity / b.faces : 0.0;
  const double temperature = b.gas.temperature();
  Kokkos::parallel_for(
      "rhegma::combustion::prepareFaces", Kokkos::RangePolicy<ExecSpace>(0, burn.points.count()),
      KOKKOS_LAMBDA(const int k) {
        if (of(k) != crack)
          return;
        depths(k) = burns && alight(k) != 0 ? depth : 0.0;
        heating.given(k) = 0.0;
        heating.conductance(k) = conductance;
        heating.gasTemperature(k) = temperature;
      });
}

/// Mass that the faces of a crack are to lose in this step [kg].
template <int D>
double massDemand(const State<D>& state, const BurnState<D>& burn, int crack)
{
  const View<int*> of = burn.points.crack, acts = burn.points.acts;
  const View<double*> depths = burn.depth, size = burn.points.currentSize;
  const double thickness = state.method.thickness;
  double mass = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::combustion::massDemand", Kokkos::RangePolicy<ExecSpace>(0, burn.points.count()),
      KOKKOS_LAMBDA(const int k, double& sum) {
        if (of(k) == crack && acts(k) != 0)
          sum += 2.0 * depths(k) * size(k) * thickness;
      },
      mass);
  return mass;
}

/// Gives the faces their fraction of the heat of the mass that has burnt there, and the heat that flows by
/// the difference of temperatures. \param fraction of the demanded mass that has burnt
template <int D>
void heatFaces(State<D>& state, BurnState<D>& burn, Burning<D>& b, double fraction)
{
  const FacePoints<D> p = burn.points;
  const View<double*> depths = burn.depth, given = burn.heating.given, heatToFaces = burn.heatToFaces;
  const double heat = b.wallFraction * fraction * b.gas.law().heatCapacity() * b.gas.law().flameTemperature;
  const int crack = b.crack;
  Kokkos::parallel_for(
      "rhegma::combustion::givenHeat", Kokkos::RangePolicy<ExecSpace>(0, p.count()),
      KOKKOS_LAMBDA(const int k) {
        if (p.crack(k) == crack)
          given(k) = depths(k) * heat;
      });
  burn.heat.give(state, p, crack, burn.heating, heatToFaces);
  double all = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::combustion::heatToFaces", Kokkos::RangePolicy<ExecSpace>(0, p.count()),
      KOKKOS_LAMBDA(const int k, double& sum) { sum += heatToFaces(k); }, all);
  b.gas.heatWalls(all);
}

/// Finds the faces that burn in this step. The flame spreads at the speed of the pressure in the crack.
template <int D>
void light(const State<D>& state, const BurnState<D>& burn, Burning<D>& b)
{
  const double time = state.clock.time, since = std::max(b.flameTime, b.ignition.time);
  if (time > since)
    b.flameReach += b.ignition.speedAt(b.pressure) * (time - since);
  b.flameTime = time;
  burn.fire.spread(state, burn.points, b.crack, b.ignition, b.flameReach, burn.heat.temperature());
  burn.fire.quench(burn.points, b.crack, b.quenching, b.gap, b.flows ? b.outside : b.pressure,
                   b.flows ? burn.pressure : View<double*>());
}

template <int D>
void warnOfLastFuel(State<D>& state, int crack, double widest)
{
  const double apart = widest / state.mesh.smallestSpacing();
  state.warnings.push_back(
      "Combustion > " + state.cracks.cracks[crack].name +
      (apart > farApart ? ": the faces are " + formatReal(std::round(10.0 * apart) / 10.0) +
                              " finest cells apart, too far to find the solid next to them"
                        : ": the solid next to the faces has burnt away") +
      " at t = " + readableTime(state.clock.time + state.clock.dt) + "; nothing burns from then on");
}

} // namespace

template <int D>
void burnStep(State<D>& state, BurnState<D>& burn, Burning<D>& b)
{
  const double gasBefore = b.gas.mass();
  const bool heated = b.usesFaces();
  if (heated)
    burn.heat.measure(state, burn.points);
  if (heated)
    b.hottestFace = hottest(burn.points, b.crack, burn.heat.temperature());
  light(state, burn, b);
  const Cavity cavity = measureCavity(state, burn.points, b.crack, burn.fire.burning());
  b.burningArea = b.spent ? 0.0 : cavity.burning;
  // The limit of the step does not foresee a first step, or a flame that reaches many faces at once.
  const double most = 2.0 * largestChange * b.gas.mass() / std::max(b.burningArea, 1e-300);
  prepareFaces(state, burn, b, most);
  const double demand = b.burningArea > 0.0 ? massDemand(state, burn, b.crack) : 0.0;
  double mass = 0.0, solidHeat = 0.0;
  if (b.burningArea > 0.0)
  {
    mass = burn.regression.computeLoss(state, burn.points, b.crack, burn.depth);
    sumParts(state, &mass, 1);
  }
  if (b.heatsFaces())
    heatFaces(state, burn, b, demand > 0.0 ? mass / demand : 0.0);
  if (b.burningArea > 0.0)
  {
    const auto lost = burn.regression.apply(state, b.solidTemperature);
    state.energy.combustion -= lost.energy;
    double gained[] = {lost.mass, lost.heat};
    sumParts(state, gained, 2);
    b.gas.burn(gained[0], gained[1]);
    mass = gained[0];
    solidHeat = gained[1];
    if (mass < leastFuel * demand)
    {
      b.spent = true;
      warnOfLastFuel(state, b.crack, cavity.widest);
    }
  }
  const double come = b.gas.mass() - gasBefore;
  double gone = 0.0;
  if (b.flows)
  {
    gone = -b.gas.vented();
    moveFlow(state, burn.points, b, burn.depth, mass, solidHeat, burn.heatToFaces);
    gone += b.gas.vented();
  }
  else if (b.discharge > 0.0)
  {
    gone = state.clock.dt *
           b.gas.outflow(b.discharge * surfaceEndArea(state, b.crack, b.mirrors), b.volume, b.outside);
    gone = std::min(gone, 0.5 * b.gas.mass());
    b.gas.vent(gone, b.volume);
  }
  b.gas.settle();
  const double last = state.clock.dt > 0.0 ? (come + gone) / state.clock.dt : 0.0;
  // All faces may catch fire in the next step.
  const bool lit = !b.spent && state.clock.time + 3.0 * state.clock.dt >= b.ignition.time;
  const double next =
      lit ? b.density * b.rate(b.pressure) * (b.ignition.everywhere ? b.faces : b.burningArea) : 0.0;
  b.massRate = std::max(last, next);
}

template void burnStep(State<2>&, BurnState<2>&, Burning<2>&);
template void burnStep(State<3>&, BurnState<3>&, Burning<3>&);

} // namespace Rhegma::combustion
