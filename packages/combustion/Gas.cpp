#include "combustion/Gas.hpp"

#include "checkpoint/Archive.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::combustion
{

void Gas::fill(double pressure, double temperature, double volume)
{
  const double mass = pressure * volume / (law_.constant * temperature + pressure * law_.covolume);
  fillWith(mass, mass * law_.heatCapacity() * temperature);
}

void Gas::fillWith(double mass, double energy)
{
  mass_ = mass;
  energy_ = energy;
  startMass_ = mass_;
  startEnergy_ = energy_;
}

void Gas::burn(double mass, double heat)
{
  mass_ += mass;
  burnt_ += mass;
  energy_ += mass * law_.heatCapacity() * law_.flameTemperature + heat;
  solidHeat_ += heat;
}

void Gas::heatWalls(double heat)
{
  energy_ -= heat;
  wallHeat_ += heat;
}

void Gas::work(double energy)
{
  energy_ -= energy;
  work_ += energy;
}

void Gas::vent(double mass, double volume)
{
  if (!(mass > 0.0))
    return;
  const double enthalpy =
      mass * law_.heatCapacity() * temperature() + mass / mass_ * pressure(volume) * volume;
  takeOut(mass, enthalpy);
}

void Gas::takeOut(double mass, double enthalpy)
{
  mass_ -= mass;
  energy_ -= enthalpy;
  vented_ += mass;
  ventedEnergy_ += enthalpy;
}

void Gas::settle()
{
  if (!law_.constantTemperature)
    return;
  const double kept = mass_ * law_.heatCapacity() * law_.flameTemperature;
  wallHeat_ += energy_ - kept;
  energy_ = kept;
}

double Gas::temperature() const { return mass_ > 0.0 ? energy_ / (mass_ * law_.heatCapacity()) : 0.0; }

double Gas::pressure(double volume) const
{
  return (law_.heatRatio - 1.0) * energy_ / (volume - leastVolume());
}

double GasLaw::outflow(double area, double pressure, double temperature, double outside) const
{
  const double k = heatRatio;
  if (!(area > 0.0) || !(pressure > outside) || !(temperature > 0.0))
    return 0.0;
  const double critical = std::pow(2.0 / (k + 1.0), k / (k - 1.0));
  const double ratio = std::max(outside / pressure, critical);
  const double flux =
      std::sqrt(2.0 * k / (k - 1.0) * (std::pow(ratio, 2.0 / k) - std::pow(ratio, (k + 1.0) / k)));
  return area * pressure / std::sqrt(constant * temperature) * flux;
}

double Gas::outflow(double area, double volume, double outside) const
{
  return law_.outflow(area, pressure(volume), temperature(), outside);
}

void Gas::keep(Archive& archive)
{
  archive("mass", mass_);
  archive("energy", energy_);
  archive("start_mass", startMass_);
  archive("start_energy", startEnergy_);
  archive("burnt", burnt_);
  archive("vented", vented_);
  archive("work", work_);
  archive("vented_energy", ventedEnergy_);
  archive("wall_heat", wallHeat_);
  archive("solid_heat", solidHeat_);
}

} // namespace Rhegma::combustion
