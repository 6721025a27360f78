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

/// Square of the stress intensities of a kink at an angle, k_I^2 + k_II^2, in proportion to its energy
/// release rate.
double kinkedRelease(double angle, double modeI, double modeII);

/// Largest angle by which a front turns [rad].
constexpr double mostTurn = 80.0 * 3.14159265358979323846 / 180.0;

/// Where a function of an angle is largest in an interval, to 1e-9 [rad]: the best of points a degree apart,
/// from `first` on, and between its neighbours by thirds.
template <class Function>
double largestIn(double first, double last, const Function& function)
{
  constexpr double coarse = 3.14159265358979323846 / 180.0, tolerance = 1e-9;
  double best = first, value = function(first);
  for (double angle = first + coarse; angle <= last; angle += coarse)
    if (const double now = function(angle); now > value)
    {
      best = angle;
      value = now;
    }
  double low = best - coarse > first ? best - coarse : first,
         high = best + coarse < last ? best + coarse : last;
  while (high - low > tolerance)
  {
    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
    if (function(a) < function(b))
      low = a;
    else
      high = b;
  }
  return 0.5 * (low + high);
}

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
