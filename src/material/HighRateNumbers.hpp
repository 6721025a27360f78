#pragma once
/// Numbers of the law High-Rate Solid, which its parts share.

namespace Rhegma::HighRateNumber
{

/// Indices in Properties::own.
enum
{
  yield,             ///< A of Johnson and Cook; 0: no flow [Pa]
  hardening,         ///< B [Pa]
  exponent,          ///< n [-]
  rate,              ///< C [-]
  referenceRate,     ///< strain rate at which C has no effect [1/s]
  softening,         ///< m; 0: no thermal softening [-]
  transition,        ///< below which the metal does not soften [K]
  meltTemperature,   ///< [K]
  saturation,        ///< by how much Voce hardening raises the yield stress in the end [Pa]
  saturationRate,    ///< exponent of Voce hardening [-]
  heatFraction,      ///< of plastic work, in scenes without heat [-]
  heatCapacity,      ///< rho c; 0: the law does not warm [J/(m3 K)]
  hugoniotSlope,     ///< s [-]
  grueneisen,        ///< Gamma_0 [-]
  linearViscosity,   ///< coefficient of artificial viscosity [-]
  quadraticViscosity ///< [-]
};

} // namespace Rhegma::HighRateNumber
