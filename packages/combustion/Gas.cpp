#include "combustion/Gas.hpp"

#include "archive/Archive.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::combustion
{

namespace
{

// The isentrope of p (v - b) = R T with constant c_v, v = 1 / rho: c_v dT = - p dv gives p (v - b)^gamma
// constant, as d(v - b) = dv. The enthalpy is c_v T + p v = c_p T + b p. So from rest at p0 and T0, with
// r = p / p0, beta = b p0 / (R T0) and v in units of R T0 / p0,
//
//     v = r^(-1/gamma) + beta,   c^2 = gamma p v^2 / (v - b),   flux = u / v,
//     u^2 = 2 R T0 (gamma / (gamma - 1) (1 - r^((gamma - 1)/gamma)) + beta (1 - r)).
//
// The flux is largest where u = c.

/// Ratio of pressures at which the flow is choked.
double criticalRatio(double k, double beta)
{
  const double ideal = std::pow(2.0 / (k + 1.0), k / (k - 1.0));
  if (beta == 0.0)
    return ideal;
  // (u^2 - c^2) / (R T0) falls from a positive value at r = 0 to a negative one at r = 1.
  const auto excess = [&](double r)
  {
    const double v = std::pow(r, -1.0 / k) + beta;
    return 2.0 * (k / (k - 1.0) * (1.0 - std::pow(r, (k - 1.0) / k)) + beta * (1.0 - r)) -
           k * std::pow(r, 1.0 + 1.0 / k) * v * v;
  };
  double low = 0.0, high = 1.0;
  constexpr int halvings = 60; // to the last digit; the flux is flat there
  for (int n = 0; n < halvings; ++n)
  {
    const double middle = 0.5 * (low + high);
    (excess(middle) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

} // namespace

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

void Gas::doWork(double energy)
{
  energy_ -= energy;
  work_ += energy;
}

void Gas::vent(double mass, double volume)
{
  if (!(mass > 0.0))
    return;
  recordOutflow(mass, mass * enthalpy(volume));
}

void Gas::recordOutflow(double mass, double enthalpy)
{
  mass_ -= mass;
  energy_ -= enthalpy;
  vented_ += mass;
  ventedEnergy_ += enthalpy;
}

void Gas::pass(double mass, double enthalpy)
{
  mass_ += mass;
  energy_ += enthalpy;
  passed_ += mass;
  passedEnergy_ += enthalpy;
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

double Gas::enthalpy(double volume) const
{
  return law_.heatCapacity() * temperature() + pressure(volume) * volume / mass_;
}

double GasLaw::outflow(double area, double pressure, double temperature, double outside) const
{
  const double k = heatRatio;
  if (!(area > 0.0) || !(pressure > outside) || !(temperature > 0.0))
    return 0.0;
  const double beta = covolume * pressure / (constant * temperature);
  const double ratio = std::max(outside / pressure, criticalRatio(k, beta));
  const double dense = std::pow(ratio, 1.0 / k), square = std::pow(ratio, 2.0 / k);
  const double flux = std::sqrt(2.0 * k / (k - 1.0) * (square - std::pow(ratio, (k + 1.0) / k)) +
                                2.0 * beta * (1.0 - ratio) * square) /
                      (1.0 + beta * dense);
  return area * pressure / std::sqrt(constant * temperature) * flux;
}

void GasLaw::stagnate(double& pressure, double& temperature, double speed) const
{
  const double cp = heatRatio * heatCapacity(), power = heatRatio / (heatRatio - 1.0);
  const double energy = 0.5 * speed * speed, pushed = covolume * pressure;
  // c_p T0 + b p0 = c_p T + b p + u^2 / 2 with p0 = p (T0 / T)^power, in T0 / T. Newton's method comes down
  // from the ideal gas, as the left side is convex.
  double ratio = 1.0 + energy / (cp * temperature);
  constexpr int most = 50;
  for (int n = 0; n < most && pushed > 0.0; ++n)
  {
    const double grown = std::pow(ratio, power);
    const double change = (cp * temperature * (ratio - 1.0) + pushed * (grown - 1.0) - energy) /
                          (cp * temperature + pushed * power * grown / ratio);
    ratio -= change;
    if (std::fabs(change) <= 1e-15 * ratio)
      break;
  }
  temperature *= ratio;
  pressure *= std::pow(ratio, power);
}

double Gas::outflow(double area, double volume, double outside) const
{
  return law_.outflow(area, pressure(volume), temperature(), outside);
}

void Gas::serialize(Archive& archive)
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
  archive("passed", passed_);
  archive("passed_energy", passedEnergy_);
}

} // namespace Rhegma::combustion
