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
      : at_(material), r_(r), size_(1.0 / std::sqrt(8.0 * std::atan(1.0) * r))
  {
    const double c = std::cos(theta), s = std::sin(theta);
    const Complex m1 = at_.root[0], m2 = at_.root[1];
    g1_ = rootOf(c + s * m1, theta);
    const Complex g2 = rootOf(c + s * m2, theta), f2 = inverseOf(g2), Dg = s * inverseOf(g1_ + g2);
    f1_ = inverseOf(g1_);
    f2_ = f2;
    Df_ = -1.0 * Dg * f1_ * f2;
    Dmf_ = m1 * Df_ + f2;
    for (int i = 0; i < 2; ++i)
    {
      u_[i] = at_.p[i] * Dg + at_.slope[i] * g2;
      along_[i] = at_.p[i] * Df_ + at_.slope[i] * f2;
      across_[i] = at_.p[i] * Dmf_ + at_.slope[i] * m2 * f2;
    }
  }

  /// \param mode 0: opening (I), 1: sliding (II)
  KOKKOS_INLINE_FUNCTION TipField field(int mode) const
  {
    const Complex m1 = at_.root[0];
    TipField field;
    if (mode == 0)
    {
      field.stress[0][0] = -size_ * real(at_.product, Dmf_);
      field.stress[1][1] = size_ * (f1_.real() - real(m1, Df_));
      field.stress[0][1] = size_ * real(at_.product, Df_);
    }
    else
    {
      field.stress[0][0] = -size_ * (real(m1, Dmf_) + real(at_.root[1], f2_));
      field.stress[1][1] = -size_ * Df_.real();
      field.stress[0][1] = size_ * Dmf_.real();
    }
    field.stress[1][0] = field.stress[0][1];
    for (int i = 0; i < 2; ++i)
    {
      double u = -u_[i].real(), along = -along_[i].real(), across = -across_[i].real();
      if (mode == 0)
      {
        const Complex p = at_.p[i];
        u = real(p, g1_) - real(m1, u_[i]);
        along = real(p, f1_) - real(m1, along_[i]);
        across = real(p * m1, f1_) - real(m1, across_[i]);
      }
      field.displacement[i] = 2.0 * r_ * size_ * u;
      field.gradient[i][0] = size_ * along;
      field.gradient[i][1] = size_ * across;
    }
    return field;
  }

private:
  using Complex = Kokkos::complex<double>;
  const CrackCompliance& at_;
  double r_, size_;
  Complex g1_, f1_, f2_;                ///< sqrt(z_j / r), and 1 over it
  Complex Df_, Dmf_;                    ///< divided differences of f and of mu f
  Complex u_[2], along_[2], across_[2]; ///< of p times g, f and mu f

  /// Real part of a product.
  KOKKOS_INLINE_FUNCTION static double real(const Complex& a, const Complex& b)
  {
    return a.real() * b.real() - a.imag() * b.imag();
  }

  KOKKOS_INLINE_FUNCTION static Complex inverseOf(const Complex& z)
  {
    const double scale = 1.0 / (z.real() * z.real() + z.imag() * z.imag());
    return {scale * z.real(), -scale * z.imag()};
  }

  /// The square root that is continuous around the tip, also where the angle passes pi: z has the sign of the
  /// angle, and rounding must not put a position on a face across the cut.
  KOKKOS_INLINE_FUNCTION static Complex rootOf(const Complex& z, double theta)
  {
    const double x = z.real(), size = std::sqrt(x * x + z.imag() * z.imag());
    const double large = std::sqrt(0.5 * (size + std::fabs(x))), small = 0.5 * std::fabs(z.imag()) / large;
    const bool past = std::fabs(theta) > 4.0 * std::atan(1.0);
    const double re = x < 0.0 ? small : large, im = x < 0.0 ? large : small;
    return {past ? -re : re, theta > 0.0 ? im : -im};
  }
};

} // namespace Rhegma::energy_release
