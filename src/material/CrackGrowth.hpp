#pragma once
/// Growth of many small cracks under stress, as in statistical crack mechanics.

#include "base/Types.hpp"

namespace Rhegma
{

/// What drives the cracks: true stress.
struct CrackDrive
{
  double shear; ///< s:s of its deviator s [Pa2]
  double mean;  ///< its mean, positive in tension [Pa]
};

/// Speed of the mean radius c of penny-shaped cracks of all orientations. With K = sqrt(pi c) sigma,
///
///     sigma^2 = 3/2 s:s, in tension 3/2 (s:s + 3 mean^2),
///     dc/dt = v (K / K1)^m below K', v (1 - (K0' / K)^2) above,
///     K' = K0' sqrt(1 + 2/m),    K1 = K' (1 + m/2)^(1/m),
///     K0'^2 = K0^2 (1 + pi x (1 + x)),    x = mu' p sqrt(c) / K0,    mu' = sqrt(45 / (2 (3 - 2 mu^2))) mu,
///
/// p the pressure, zero in tension. K' and K1 make dc/dt and its slope continuous. Sources: Bennett,
/// Haberman, Johnson, Asay, Henson, J. Mech. Phys. Solids 46 (1998) 2303; Hackett, Bennett, Int. J. Numer.
/// Methods Eng. 49 (2000) 1191; the friction: Addessio, Johnson, J. Appl. Phys. 67 (1990) 3275.
struct CrackGrowth
{
  double toughness; ///< K0 [Pa m^0.5]
  double friction;  ///< mu'
  double exponent;  ///< m
  double speed;     ///< v [m/s]

  /// dc/dt [m/s], never negative, at most v. \param radius c [m]
  KOKKOS_INLINE_FUNCTION double rate(double radius, const CrackDrive& drive) const
  {
    constexpr double pi = 3.14159265358979323846;
    const bool open = drive.mean > 0.0;
    const double tension = open ? 3.0 * drive.mean * drive.mean : 0.0;
    const double x = open ? 0.0 : -friction * drive.mean * std::sqrt(radius) / toughness;
    const double resistance = toughness * toughness * (1.0 + pi * x * (1.0 + x));
    const double ratio = 1.5 * pi * radius * (drive.shear + tension) / resistance; // (K / K0')^2
    const double change = 1.0 + 2.0 / exponent;                                    // (K' / K0')^2
    if (ratio >= change)
      return speed * (1.0 - 1.0 / ratio);
    return speed * std::pow(ratio / change, 0.5 * exponent) / (1.0 + 0.5 * exponent);
  }

  /// Radius after a step. Heun's rule where it is accurate, else the pair of third and second order of
  /// Bogacki and Shampine (Appl. Math. Lett. 2 (1989) 321) with its own steps.
  /// \param radius at the start [m] \param dt of the step [s]
  /// \param driveAt driveAt(fraction of the step, radius) gives the CrackDrive
  template <class DriveAt>
  KOKKOS_INLINE_FUNCTION double radiusAfter(double radius, double dt, const DriveAt& driveAt) const
  {
    constexpr double smooth = 2.0e-4; // change of the growth over the step, relative to the radius
    if (!(dt > 0.0))
      return radius;
    const double first = dt * rate(radius, driveAt(0.0, radius));
    const double last = dt * rate(radius + first, driveAt(1.0, radius + first));
    if (std::fabs(last - first) <= smooth * radius)
      return radius + 0.5 * (first + last);
    return radiusBySteps(radius, dt, first, driveAt);
  }

private:
  /// \param first dt times the rate at the start [m]
  template <class DriveAt>
  KOKKOS_INLINE_FUNCTION double radiusBySteps(double radius, double dt, double first,
                                              const DriveAt& driveAt) const
  {
    constexpr double tolerance = 1.0e-5, least = 1.0e-4; // relative to the radius, and to dt
    const auto slope = [&](double at, double c) { return dt * rate(c, driveAt(at, c)); };
    double at = 0.0, size = 0.1, k1 = first;
    while (at < 1.0)
    {
      const bool ends = !(at + size < 1.0);
      const double h = ends ? 1.0 - at : size, end = ends ? 1.0 : at + h;
      const double k2 = slope(at + 0.5 * h, radius + 0.5 * h * k1);
      const double k3 = slope(at + 0.75 * h, radius + 0.75 * h * k2);
      const double grown = radius + h * (2.0 * k1 + 3.0 * k2 + 4.0 * k3) / 9.0;
      const double k4 = slope(end, grown);
      const double error =
          std::fabs(h * (-5.0 / 72.0 * k1 + k2 / 12.0 + k3 / 9.0 - k4 / 8.0)) / (tolerance * radius);
      if (!(error > 1.0) || size <= least) // also where it is not a number
      {
        at = end;
        radius = grown;
        k1 = k4;
      }
      const double change = 0.9 / std::cbrt(std::fmax(error, 1.0e-3));
      size = std::fmax(h * std::fmin(std::fmax(change, 0.2), 4.0), least);
    }
    return radius;
  }
};

} // namespace Rhegma
