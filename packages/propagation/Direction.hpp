#pragma once
/// Where a crack goes on.

#include "state/CrackSet.hpp"

namespace Rhegma::propagation
{

enum class DirectionRule
{
  HoopStress,
  EnergyRelease,
  Straight
};

/// Angle [rad] from the front's direction towards its normal at which the energy release rate of a short kink
/// is largest, with the stress intensities at its tip
///
///     k_I = F11 K_I + F12 K_II,   k_II = F21 K_I + F22 K_II
///
/// by the series of Amestoy and Leblond (Int. J. Solids Struct. 29 (1992) 465) in the angle; no more than 80
/// degrees.
double energyReleaseAngle(double modeI, double modeII);

/// Unit vector in which a front advances.
Vector<2> nextDirection(const CrackFront<2>& front, DirectionRule rule);

} // namespace Rhegma::propagation
