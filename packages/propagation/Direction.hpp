#pragma once
/// Direction of crack growth.

#include "state/CrackSet.hpp"

#include <cmath>

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

/// Angle by which a front turns, from its direction towards its normal [rad]. Mode III does not turn the
/// front: it would twist it, which a smooth surface can't follow.
double turningAngle(const DrivingForce& driving, DirectionRule rule);

/// The unit vector at an angle from a direction towards a normal.
template <int D>
Vector<D> turned(const Vector<D>& direction, const Vector<D>& normal, double angle)
{
  const Vector<D> to = std::cos(angle) * direction + std::sin(angle) * normal;
  return (1.0 / norm(to)) * to;
}

} // namespace Rhegma::propagation
