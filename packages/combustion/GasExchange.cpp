#include "combustion/GasExchange.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace Rhegma::combustion
{

namespace
{

/// Fraction of the remaining mass that flows in one step, with the rate and the enthalpy at mid-step.
constexpr double stepFraction = 0.05;
/// Difference of the pressures over the larger below which the rate is proportional to the root of the
/// difference, as in incompressible flow.
constexpr double small = 1e-3;

/// Gas in its volume.
struct Filled
{
  Gas gas;
  double volume;
  double pressure() const { return gas.pressure(volume); }
};

/// \param enthalpy of what flows [J/kg]
void move(Filled& from, Filled& to, double mass, double enthalpy)
{
  from.gas.pass(-mass, -mass * enthalpy);
  to.gas.pass(mass, mass * enthalpy);
  from.gas.settle();
  to.gas.settle();
}

/// Energy that gas loses or gains per mass that flows [J/kg]: the enthalpy of the flow or, where walls keep
/// the temperature constant, its own internal energy.
double energyPerMass(const Filled& gas, double enthalpy)
{
  const GasLaw& law = gas.gas.law();
  return law.constantTemperature ? law.heatCapacity() * law.flameTemperature : enthalpy;
}

/// Mass m [kg] that must flow for the pressures to be equal. With A = V - b m, equal U / A are
/// (U1 - m h1) / (A1 + b m) = (U2 + m h2) / (A2 - b m): b (h1 - h2) m^2 - B m + C = 0, with
/// B = h1 A2 + h2 A1 + b (U1 + U2) and C = U1 A2 - U2 A1. \param enthalpy of what flows [J/kg]
double massToEqual(const Filled& from, const Filled& to, double enthalpy)
{
  const double free = from.volume - from.gas.leastVolume(), freeThere = to.volume - to.gas.leastVolume();
  const double energy = from.gas.energy(), energyThere = to.gas.energy();
  const double less = energyPerMass(from, enthalpy), more = energyPerMass(to, enthalpy);
  const double covolume = from.gas.law().covolume, square = covolume * (less - more),
               linear = less * freeThere + more * free + covolume * (energy + energyThere),
               constant = energy * freeThere - energyThere * free;
  return 2.0 * constant / (linear + std::sqrt(std::fmax(linear * linear - 4.0 * square * constant, 0.0)));
}

} // namespace

bool mixes(const GasLaw& one, const GasLaw& two)
{
  return one.constant == two.constant && one.heatRatio == two.heatRatio && one.covolume == two.covolume;
}

void exchange(Gas& one, double volumeOne, Gas& two, double volumeTwo, double area, double time)
{
  Filled from{one, volumeOne}, to{two, volumeTwo};
  const bool turned = from.pressure() < to.pressure();
  if (turned)
    std::swap(from, to);
  while (time > 0.0)
  {
    const double enthalpy = from.gas.enthalpy(from.volume);
    const double rate = from.gas.outflow(area, from.volume, to.pressure()),
                 left = massToEqual(from, to, enthalpy);
    if (!(rate > 0.0) || !(left > 0.0))
      break;
    if (from.pressure() - to.pressure() < small * from.pressure())
    {
      // Of dx/dt = - q (x / x0)^(1/2), which ends after 2 x0 / q.
      const double fraction = std::max(1.0 - 0.5 * rate * time / left, 0.0);
      move(from, to, left * (1.0 - fraction * fraction), enthalpy);
      break;
    }
    const double step = std::min(time, stepFraction * left / rate);
    Filled fromThen = from, toThen = to;
    move(fromThen, toThen, 0.5 * step * rate, enthalpy);
    move(from, to, step * fromThen.gas.outflow(area, from.volume, toThen.pressure()),
         fromThen.gas.enthalpy(from.volume));
    time -= step;
  }
  if (turned)
    std::swap(from, to);
  one = from.gas;
  two = to.gas;
}

} // namespace Rhegma::combustion
