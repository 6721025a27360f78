#pragma once
/// Artificial bulk viscosity, which spreads shocks over some cells.

#include "material/AcousticBound.hpp"

namespace Rhegma
{

/// q = rho l |d| (C1 c + C2 l |d|) in compression, with d the rate of volume, l the cell size and c the speed
/// of sound (von Neumann and Richtmyer, J. Appl. Phys. 21 (1950) 232). rho is that of the undeformed
/// material.
struct ArtificialViscosity
{
  double linear, quadratic; ///< C1, C2 [-]
  double density, length;   ///< [kg/m3], [m]

  /// Part of -tr tau / 3 [Pa]. The forces on nodes do its work by the trapezoidal rule, which is what is
  /// dissipated; the heat is by the new value, so that it is never negative. Over a shock both are the same.
  /// \param sound speed of sound in the volume [m/s] \param q of the last step; out: now \param dissipated
  /// gains the dissipation, and \param heat the heat [J/m3]
  KOKKOS_INLINE_FUNCTION double pressure(double dt, double J, double before, double sound, double& q,
                                         double& dissipated, double& heat) const
  {
    if (!(dt > 0.0))
      return q;
    const double strain = compression(before, J);
    double now = 0.0;
    if (strain > 0.0)
    {
      const double closing = length * strain / dt;
      now = density * closing * (linear * sound + quadratic * closing);
    }
    dissipated += 0.5 * (q + now) * strain;
    heat += now * strain;
    q = now;
    return now;
  }

  /// V = C1 c + C2 l |d|, which follows from q: the stable step of a viscous wave is that of the speed
  /// V + sqrt(V^2 + c^2) [m/s].
  KOKKOS_INLINE_FUNCTION double speed(double sound, double q) const
  {
    const double slow = linear * sound;
    return 0.5 * (slow + std::sqrt(slow * slow + 4.0 * quadratic * q / density));
  }

private:
  /// ln(before / J), by its series where a step changes the volume little; the first term left out is 1e-17.
  KOKKOS_INLINE_FUNCTION static double compression(double before, double J)
  {
    const double z = (before - J) / (before + J), square = z * z;
    if (square > 1.0e-4)
      return std::log(before / J);
    return 2.0 * z * (1.0 + square * (1.0 / 3.0 + square * (1.0 / 5.0 + square / 7.0)));
  }
};

} // namespace Rhegma
