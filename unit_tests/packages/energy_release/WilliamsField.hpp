#pragma once
/// Williams' fields of a crack tip in an isotropic body, by which the tests check those of the program.

#include "energy_release/CrackTipFields.hpp"

namespace Rhegma::energy_release
{

/// Shear modulus [Pa] and Kolosov's constant: 3 - 4 nu in plane strain, (3 - nu) / (1 + nu) in plane stress.
struct TipModuli
{
  double shear;
  double kolosov;
};

/// The singular fields of unit stress intensity, K = 1 Pa m^0.5, at a position, which both modes share.
/// Source: Williams, J. Appl. Mech. 24 (1957) 109; in this form Anderson, Fracture Mechanics,
/// tables 2.1, 2.2.
struct WilliamsPosition
{
  double r, s, c, s3, c3; ///< distance [m]; sine and cosine of half the angle, and of three halves of it
  double size;            ///< 1 / sqrt(2 pi r)

  /// \param r distance from the tip [m], not zero \param theta angle from the direction, -pi and pi on the
  /// faces
  KOKKOS_INLINE_FUNCTION WilliamsPosition(double distance, double theta)
      : r(distance),
        s(std::sin(0.5 * theta)),
        c(std::cos(0.5 * theta)),
        s3(std::sin(1.5 * theta)),
        c3(std::cos(1.5 * theta)),
        size(1.0 / std::sqrt(8.0 * std::atan(1.0) * distance))
  {
  }

  /// \param mode 0: opening (I), 1: sliding (II)
  KOKKOS_INLINE_FUNCTION TipField field(int mode, const TipModuli& moduli) const
  {
    const double k = moduli.kolosov;
    TipField f;
    double g[2], slope[2]; // u = sqrt(r / 2 pi) / (2 mu) g(theta); slope = dg/dtheta
    if (mode == 0)
    {
      f.stress[0][0] = size * c * (1.0 - s * s3);
      f.stress[1][1] = size * c * (1.0 + s * s3);
      f.stress[0][1] = size * c * s * c3;
      g[0] = c * (k - 1.0 + 2.0 * s * s);
      g[1] = s * (k + 1.0 - 2.0 * c * c);
      slope[0] = -0.5 * s * (k - 1.0 + 2.0 * s * s) + 2.0 * s * c * c;
      slope[1] = 0.5 * c * (k + 1.0 - 2.0 * c * c) + 2.0 * s * s * c;
    }
    else
    {
      f.stress[0][0] = -size * s * (2.0 + c * c3);
      f.stress[1][1] = size * s * c * c3;
      f.stress[0][1] = size * c * (1.0 - s * s3);
      g[0] = s * (k + 1.0 + 2.0 * c * c);
      g[1] = -c * (k - 1.0 - 2.0 * s * s);
      slope[0] = 0.5 * c * (k + 1.0 + 2.0 * c * c) - 2.0 * s * s * c;
      slope[1] = 0.5 * s * (k - 1.0 - 2.0 * s * s) + 2.0 * s * c * c;
    }
    f.stress[1][0] = f.stress[0][1];
    const double scale = size / (2.0 * moduli.shear);
    const double cosine = c * c - s * s, sine = 2.0 * s * c;
    for (int i = 0; i < 2; ++i)
    {
      f.gradient[i][0] = scale * (0.5 * cosine * g[i] - sine * slope[i]);
      f.gradient[i][1] = scale * (0.5 * sine * g[i] + cosine * slope[i]);
      f.displacement[i] = scale * r * g[i];
    }
    return f;
  }
};

/// The field of one mode (WilliamsPosition).
KOKKOS_INLINE_FUNCTION TipField williamsField(int mode, double r, double theta, const TipModuli& moduli)
{
  return WilliamsPosition(r, theta).field(mode, moduli);
}

} // namespace Rhegma::energy_release
