#pragma once
/// When and where to a crack starts under mixed modes: by the largest hoop stress, and by the energy release
/// rate of the modes that open or slide it.

#include "material/MaterialTable.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma
{

/// Angle [rad] from the front's direction towards its normal in which the hoop stress is largest.
/// Source: Erdogan and Sih, J. Basic Eng. 85 (1963) 519.
inline double hoopStressAngle(double modeI, double modeII)
{
  if (modeII == 0.0)
    return 0.0;
  const double ratio = modeI / modeII;
  return 2.0 * std::atan(0.25 * (ratio - std::copysign(std::sqrt(ratio * ratio + 8.0), modeII)));
}

/// Load at which the largest hoop stress makes a front start and turn, over that at which G of a straight
/// extension reaches the toughness (Erdogan and Sih). \param turn angle by which it turns, of either sign, at
/// most that of shear alone, 70.5 degrees [rad]
inline double hoopStressLoad(double turn)
{
  const double t = std::min(std::fabs(turn), std::acos(1.0 / 3.0) - 1e-6);
  const double shear = std::sin(t) / (3.0 * std::cos(t) - 1.0); // K_II / K_I, where the shear stress is zero
  const double half = std::cos(0.5 * t);
  return std::sqrt(1.0 + shear * shear) / (half * half * half + 1.5 * shear * half * std::sin(t));
}

/// Energy release rate of a unit of stress intensity of each mode [1/Pa]: G is the sum of K^2 times these,
/// and of what couples modes in anisotropic materials.
struct ModeRelease
{
  double opening = 0.0, sliding = 0.0, tearing = 0.0;
};

/// Of an isotropic material (Irwin).
inline ModeRelease modeRelease(const Elasticity& e)
{
  return {1.0 / e.effectiveModulus, 1.0 / e.effectiveModulus, 1.0 / (2.0 * e.shear)};
}

/// The part of an energy release rate that drives a crack [J/m2]: all of it, or, where K_I closes the faces,
/// the share of the sliding modes. \param release G [J/m2] \param modeI, modeII, modeIII K [Pa m^0.5]
/// Where K is not known (not a number) it is all of it. \param modes of the material at the front
inline double openingRelease(double release, double modeI, double modeII, double modeIII,
                             const ModeRelease& modes)
{
  if (!(modeI < 0.0))
    return release;
  const double closing = modes.opening * modeI * modeI;
  const double sliding = modes.sliding * modeII * modeII + modes.tearing * modeIII * modeIII;
  return release * sliding / (closing + sliding);
}

} // namespace Rhegma
