#pragma once
/// Maxwell elements at finite strain: what the laws that have them share.
///
/// With Cb = J^(-2/3) F^T F and Eb = (Cb - 1)/2 an element stores G e:e, e the part of Eb that its spring
/// has; its stress is J^(-2/3) F (2 G e) F^T, of which the deviator counts.

#include "material/AcousticBound.hpp"
#include "material/ThicknessRoot.hpp"

namespace Rhegma
{

/// Most Maxwell elements that one material has.
constexpr int maxwellElements = 5;

/// Eb, J and J^(-2/3).
template <int D>
struct IsochoricStrain
{
  double J, scale;
  double E[symmetricSize<D>];

  /// \return false where F is inverted
  KOKKOS_INLINE_FUNCTION bool set(const double* F)
  {
    J = determinant<D>(F);
    if (!(J > 0.0))
      return false;
    const double root = std::cbrt(J);
    scale = 1.0 / (root * root);
    strain(F);
    return true;
  }

  /// The same of an F whose volume is near that of another one: without a cube root.
  KOKKOS_INLINE_FUNCTION bool setNear(const double* F, const IsochoricStrain& other)
  {
    J = determinant<D>(F);
    if (!(J > 0.0))
      return false;
    const double change = other.J / J - 1.0;
    if (std::fabs(change) > seriesLimit)
      return set(F);
    scale = other.scale * twoThirdsPower(change);
    strain(F);
    return true;
  }

private:
  static constexpr double seriesLimit = 0.02;

  /// (1 + x)^(2/3); the first term left out is 1e-14 at the limit.
  KOKKOS_INLINE_FUNCTION static double twoThirdsPower(double x)
  {
    return 1.0 + x * (2.0 / 3.0 -
                      x * (1.0 / 9.0 -
                           x * (4.0 / 81.0 - x * (7.0 / 243.0 - x * (14.0 / 729.0 - x * (91.0 / 6561.0))))));
  }

  KOKKOS_INLINE_FUNCTION void strain(const double* F)
  {
    rightStrain<D>(F, E);
    for (int k = 0; k < symmetricSize<D>; ++k)
      E[k] *= 0.5 * scale;
    for (int i = 0; i < 3; ++i)
      E[normalIndex<D>(i)] += 0.5 * (scale - 1.0);
  }
};

/// Bound of rho c^2 by elements of the shear moduli `shear`, without their stress [Pa]: the second derivative
/// of their energy is at most 2 G |dEb|^2 <= 4/3 G b^2. \param largest eigenvalue b of J^(-2/3) F F^T
/// \param theta in plane stress the thickness follows by theta times the dilatation of the plane
template <Plane P>
KOKKOS_INLINE_FUNCTION double elementsModulus(double shear, double largest, double theta)
{
  if constexpr (P == Plane::Stress)
  {
    const double rest = 1.0 - theta;
    return 0.5 * shear * largest * largest * (4.0 + 4.0 * theta * theta - 4.0 / 3.0 * rest * rest);
  }
  else
    return 4.0 / 3.0 * shear * largest * largest;
}

/// Bound of sum G_i e_i : d^2 Cb over all directions, from its spatial tensor q = J^(-2/3) F (sum 2 G_i
/// e_i) F^T: n.q n - 4/3 p m.q n + 5/9 p^2 tr q; in plane stress it is at most 4 |q|.
template <int D, Plane P>
KOKKOS_INLINE_FUNCTION double stiffening(const double* q)
{
  const EigenvalueRange range = directionalRange<D>(q);
  double largest = larger(std::fabs(range.largest), std::fabs(range.smallest));
  if constexpr (P == Plane::Stress)
    return 4.0 * larger(largest, std::fabs(q[3]));
  return larger(range.largest, 0.0) + 4.0 / 3.0 * largest + 5.0 / 9.0 * std::fabs(trace<D>(q));
}

/// tau_zz as a function of the thickness stretch s, with S = R + G (Cb - 1).
struct ThicknessStress
{
  double xx, yy, xy; ///< of F^T F, in the plane
  double area;       ///< of the plane, j
  double R[4];       ///< S without the strain of this step
  double G;          ///< sum of G_i gain_i
  double bulk;       ///< after relaxation
  double base;       ///< sum of K_i v_i without the strain of this step, at J = 1
  double K;          ///< sum of K_i gain_i

  KOKKOS_INLINE_FUNCTION double operator()(double s, double& slope) const
  {
    const double J = area * s, root = std::cbrt(J), scale = 1.0 / (root * root);
    const double cx = scale * xx, cy = scale * yy, cxy = scale * xy, cz = scale * s * s;
    const double sx = R[0] + G * (cx - 1.0), sy = R[1] + G * (cy - 1.0), sxy = R[2] + G * cxy,
                 sz = R[3] + G * (cz - 1.0);
    // Derivatives by ln s.
    const double dx = -2.0 / 3.0 * cx, dy = -2.0 / 3.0 * cy, dxy = -2.0 / 3.0 * cxy, dz = 4.0 / 3.0 * cz;
    const double product = sx * cx + sy * cy + 2.0 * sxy * cxy + sz * cz;
    const double rise =
        (G * cx + sx) * dx + (G * cy + sy) * dy + 2.0 * (G * cxy + sxy) * dxy + (G * cz + sz) * dz;
    slope = (G * cz + sz) * dz - rise / 3.0 + bulk * J * J + K;
    return cz * sz - product / 3.0 + 0.5 * bulk * (J - 1.0) * (J + 1.0) + base + K * std::log(J);
  }
};

} // namespace Rhegma
