#pragma once
/// Gas that flows from one crack into another.

#include "combustion/Gas.hpp"

namespace Rhegma::combustion
{

/// Whether gas of one crack may mix with that of another: the same R, gamma and covolume.
bool mixes(const GasLaw& one, const GasLaw& two);

/// Lets gas flow during a time from the higher pressure to the lower, with its enthalpy, by GasLaw::outflow;
/// its kinetic energy becomes heat. The mass and the energy of both gases together are conserved, and the
/// flow ends at equal pressures, for any volumes and times. \param one, two gases that mix \param volumeOne,
/// volumeTwo that they have [m3] \param area of the opening times the coefficient of discharge [m2] \param
/// time [s]
void exchange(Gas& one, double volumeOne, Gas& two, double volumeTwo, double area, double time);

} // namespace Rhegma::combustion
