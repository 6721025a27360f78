#pragma once
/// What the gradient of temperature adds to the integrals around a front in 2D, next to the front.

#include "base/Types.hpp"

#include <cmath>

namespace Rhegma::energy_release
{

/// Corrects the integrals of f = dW/dT T,1 and of its like for intensities over the cells at the front.
///
/// At the front of an insulating crack, or of one whose faces are held at a temperature, the gradient of
/// temperature is singular as the stress is, so that each unit of r contributes as much to the integral as
/// any other; particles within a cell of the front do not resolve that. Their part is replaced by a fit to a
/// ring around them. With the stress of mode I only the part of T,1 remains that is even about the crack:
/// singular where faces are held, then uniform, so that the mean of r f over a circle has the terms 1 and
/// r^(1/2). With that of mode II it is the odd part: singular where faces insulate, then of order r^(1/2),
/// which gives 1 and r. Two moments over the ring give both coefficients. With w = 1 within `within`, falling
/// linearly to 0 at `until`,
///
///     sum V f q  becomes  sum V f q (1 - w) + int w (c0 + c1 r^p) dr,   p = 1/2, 1.
///
/// f of J is K_I times that of mode I plus K_II times that of mode II plus a remainder, of which r f has the
/// term r (regular stress), and where moduli depend on temperature 1 (energy of a singular stress in their
/// gradient).
///
/// For cracks that are straight within the ring.
struct HeatNearFront
{
  static constexpr int numSums = 3; ///< of w f q, and both moments of f

  bool moduliVary = false; ///< with temperature
  double within = 0.0, until = 0.0,
         outer = 0.0; ///< radii of w, and of the ring outside [m]; 0: no correction

  HeatNearFront() = default;

  /// \param cell size of the cells at the front [m] \param inner radius of the part of the disk in which the
  /// weight is 1 [m] \param most outer radius of the disk [m]
  HeatNearFront(double cell, double inner, double most)
  {
    constexpr double rounding = 1.0 - 1e-9;
    if (inner < 2.0 * cell * rounding || most < 3.0 * cell * rounding)
      return;
    within = cell;
    until = 2.0 * cell;
    outer = std::fmin(4.0 * cell, most);
  }

  bool corrects() const { return outer > 0.0; }
  KOKKOS_INLINE_FUNCTION bool reaches(double r) const { return r < outer; }

  KOKKOS_INLINE_FUNCTION double fraction(double r) const
  {
    return r <= within ? 1.0 : r < until ? (until - r) / (until - within) : 0.0;
  }

  /// Weight of the first moment; that of the second is r times this. Zero at both ends of the ring.
  KOKKOS_INLINE_FUNCTION double ofRing(double r) const
  {
    return r > within && r < outer ? (r - within) * (outer - r) : 0.0;
  }

  /// Adds a particle. \param f its part of the integral without the weight \param q the weight
  KOKKOS_INLINE_FUNCTION void add(double r, double f, double q, double* sums) const
  {
    sums[0] += fraction(r) * q * f;
    sums[1] += ofRing(r) * f;
    sums[2] += ofRing(r) * r * f;
  }

  /// The integral of w f by the fit c0 + c1 r^power. \param sums of all particles
  double near(const double* sums, double power) const
  {
    const double a = ringIntegral(0.0), b = ringIntegral(power), c = ringIntegral(1.0),
                 d = ringIntegral(power + 1.0);
    return ((sums[1] * d - sums[2] * b) * nearIntegral(0.0) +
            (sums[2] * a - sums[1] * c) * nearIntegral(power)) /
           (a * d - b * c);
  }

  /// The integral of w f of a remainder. \param sums of all particles \param singular whether it has the term
  /// 1, which costs accuracy
  double nearOfRemainder(const double* sums, bool singular) const
  {
    return singular ? near(sums, 1.0) : sums[1] / ringIntegral(1.0) * nearIntegral(1.0);
  }

private:
  /// Of ofRing r^p.
  double ringIntegral(double p) const
  {
    const auto primitive = [&](double r)
    {
      return -std::pow(r, p + 3.0) / (p + 3.0) + (within + outer) * std::pow(r, p + 2.0) / (p + 2.0) -
             within * outer * std::pow(r, p + 1.0) / (p + 1.0);
    };
    return primitive(outer) - primitive(within);
  }

  /// Of w r^p.
  double nearIntegral(double p) const
  {
    const auto primitive = [&](double r) {
      return (until * std::pow(r, p + 1.0) / (p + 1.0) - std::pow(r, p + 2.0) / (p + 2.0)) / (until - within);
    };
    return std::pow(within, p + 1.0) / (p + 1.0) + primitive(until) - primitive(within);
  }
};

} // namespace Rhegma::energy_release
