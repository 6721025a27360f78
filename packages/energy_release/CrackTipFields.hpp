#pragma once
/// Displacement, its gradient and stress at a crack tip.

#include "material/CrackCompliance.hpp"

namespace Rhegma::energy_release
{

/// A field in the frame of the front: axis 0 along its direction, axis 1 along its normal.
struct TipField
{
  double displacement[2]; ///< [m]
  double stress[2][2];    ///< [Pa]
  double gradient[2][2];  ///< du_i/dx_j
};

/// The singular fields of unit stress intensity, K = 1 Pa m^0.5, at a position, for both modes: with
/// z_j = r (cos theta + mu_j sin theta), real parts of divided differences over both roots,
///
///     s_22 = Re [mu_1 f(mu_2) - mu_2 f(mu_1)] / (mu_1 - mu_2),   f(mu_j) = 1 / sqrt(2 pi z_j)
///
/// and the like. Differences of f and of products with it are taken in closed form, f(mu_1) - f(mu_2) by the
/// square roots themselves, so that equal roots, as in isotropic materials, are no special case: the fields
/// are then those of Williams. Source: Sih, Paris and Irwin, Int. J. Fract. Mech. 1 (1965) 189.
class TipPosition
{
public:
  /// \param r distance from the tip [m], not zero \param theta angle from the direction, -pi and pi on the
  /// faces
  KOKKOS_INLINE_FUNCTION TipPosition(double r, double theta, const CrackCompliance& material)
      : at_(material), r_(r), size_(1.0 / std::sqrt(8.0 * std::atan(1.0) * r)), s_(std::sin(theta))
  {
    const double c = std::cos(theta);
    // Around the tip the square root goes on where the angle passes pi.
    const double sign = std::fabs(theta) > 4.0 * std::atan(1.0) ? -1.0 : 1.0;
    for (int j = 0; j < 2; ++j)
      root_[j] = sign * Kokkos::sqrt(onFace(c + s_ * at_.root[j], theta));
  }

  /// \param mode 0: opening (I), 1: sliding (II)
  KOKKOS_INLINE_FUNCTION TipField field(int mode) const
  {
    const Complex m1 = at_.root[0], m2 = at_.root[1], sum = m1 + m2, product = m1 * m2;
    const Complex g1 = root_[0], g2 = root_[1], f1 = 1.0 / g1, f2 = 1.0 / g2;
    const Complex Dg = s_ / (g1 + g2), Df = -1.0 * Dg * f1 * f2; // divided differences
    const Complex Dmf = m1 * Df + f2;                            // of mu f
    TipField field;
    if (mode == 0)
    {
      field.stress[0][0] = -size_ * (product * Dmf).real();
      field.stress[1][1] = size_ * (f1 - m1 * Df).real();
      field.stress[0][1] = size_ * (product * Df).real();
    }
    else
    {
      field.stress[0][0] = -size_ * (m1 * m1 * Df + sum * f2).real();
      field.stress[1][1] = -size_ * Df.real();
      field.stress[0][1] = size_ * Dmf.real();
    }
    field.stress[1][0] = field.stress[0][1];
    // Displacement along both axes is of p g, with p a polynomial of mu and 1 / mu.
    const Complex p1[2] = {at_.a11 * m1 * m1 + at_.a12 - at_.a16 * m1, at_.a12 * m1 + at_.a22 / m1 - at_.a26};
    const Complex Dp[2] = {at_.a11 * sum - at_.a16, at_.a12 - at_.a22 / product};
    for (int i = 0; i < 2; ++i)
    {
      const Complex u = p1[i] * Dg + Dp[i] * g2, along = p1[i] * Df + Dp[i] * f2,
                    across = p1[i] * Dmf + Dp[i] * m2 * f2;
      field.displacement[i] = 2.0 * r_ * size_ * (mode == 0 ? p1[i] * g1 - m1 * u : -1.0 * u).real();
      field.gradient[i][0] = size_ * (mode == 0 ? p1[i] * f1 - m1 * along : -1.0 * along).real();
      field.gradient[i][1] = size_ * (mode == 0 ? p1[i] * m1 * f1 - m1 * across : -1.0 * across).real();
    }
    return field;
  }

private:
  using Complex = Kokkos::complex<double>;
  CrackCompliance at_;
  double r_, size_, s_;
  Complex root_[2]; ///< sqrt(z_j / r)

  /// Rounding must not put a position on a face across the cut of the square root.
  KOKKOS_INLINE_FUNCTION static Complex onFace(const Complex& z, double theta)
  {
    const bool above = theta > 0.0 ? theta <= 4.0 * std::atan(1.0) : theta < -4.0 * std::atan(1.0);
    const double imaginary = std::fabs(z.imag());
    return {z.real(), above ? imaginary : -imaginary};
  }
};

} // namespace Rhegma::energy_release
