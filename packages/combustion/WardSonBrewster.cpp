#include "combustion/WardSonBrewster.hpp"

#include <cmath>

namespace Rhegma::combustion
{

namespace
{

constexpr double gasConstant = 8.314462618; // [J/(mol K)]

double massFlux(const WardSonBrewster& s, double surface)
{
  const double across = s.capacity * (surface - s.temperature) - 0.5 * s.heatOfSolid;
  return surface * std::sqrt(s.prefactor * gasConstant * s.solidConductivity * s.density *
                             std::exp(-s.activation / (gasConstant * surface)) / (s.activation * across));
}

} // namespace

BurningSurface burningSurface(const WardSonBrewster& s, double pressure)
{
  const double moles = s.molarMass * pressure / gasConstant;
  const double heating = 4.0 * s.gasConductivity * s.gasPrefactor * moles * moles / s.capacity;
  double low = s.temperature + s.heatOfSolid / s.capacity, high = low + s.heatOfGas / s.capacity;
  const double coldest = low;
  // Half an interval of some 1000 K down to the spacing of numbers.
  for (int k = 0; k < 64 && high > low; ++k)
  {
    const double middle = 0.5 * (low + high), m = massFlux(s, middle);
    const double sum = m + std::sqrt(m * m + heating);
    const double fed = sum > 0.0 ? coldest + s.heatOfGas / s.capacity * heating / (sum * sum) : high;
    (middle < fed ? low : high) = middle;
  }
  const double surface = 0.5 * (low + high);
  return {surface, massFlux(s, surface) / s.density};
}

} // namespace Rhegma::combustion
