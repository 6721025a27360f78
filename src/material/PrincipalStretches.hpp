#pragma once
/// Principal stretches and their directions, for laws that are written in them.

#include "material/AcousticBound.hpp"
#include "material/Tensors.hpp"

namespace Rhegma
{

/// Logarithms e_i of the principal stretches, and how a tensor with the same axes is put together. In 2D the
/// last is that of the thickness. The error of each is some roundings of the largest, also where stretches
/// are equal or close.
template <int D>
struct PrincipalStretches;

template <>
struct PrincipalStretches<2>
{
  double log[3];
  double cosine, sine; ///< of twice the angle of the first axis

  /// \param F of positive determinant; F[4] may be anything, and log[2] is not set
  KOKKOS_INLINE_FUNCTION explicit PrincipalStretches(const double* F)
  {
    const double xx = F[0] * F[0] + F[1] * F[1], yy = F[2] * F[2] + F[3] * F[3];
    const double half = 0.5 * (xx - yy), shear = F[0] * F[2] + F[1] * F[3];
    const double radius = std::sqrt(half * half + shear * shear);
    cosine = radius > 0.0 ? half / radius : 1.0;
    sine = radius > 0.0 ? shear / radius : 0.0;
    // The smaller one from the area: where it is much smaller, b has not its digits.
    log[0] = 0.5 * std::log(0.5 * (xx + yy) + radius);
    log[1] = std::log(planeDeterminant(F)) - log[0];
    log[2] = 0.0;
  }

  /// Without the axes: all three, and the squares of the stretches in the plane.
  KOKKOS_INLINE_FUNCTION static void logarithms(const double* F, double (&log)[3], double (&square)[3])
  {
    const double xx = F[0] * F[0] + F[1] * F[1], yy = F[2] * F[2] + F[3] * F[3];
    const double half = 0.5 * (xx - yy), shear = F[0] * F[2] + F[1] * F[3], area = planeDeterminant(F);
    square[0] = 0.5 * (xx + yy) + std::sqrt(half * half + shear * shear);
    square[1] = area * area / square[0];
    square[2] = F[4] * F[4];
    log[0] = 0.5 * std::log(square[0]);
    log[1] = std::log(area) - log[0];
    log[2] = std::log(F[4]);
  }

  /// The tensor of principal values t.
  KOKKOS_INLINE_FUNCTION void assemble(const double (&t)[3], double* tau) const
  {
    const double middle = 0.5 * (t[0] + t[1]), half = 0.5 * (t[0] - t[1]);
    tau[0] = middle + half * cosine;
    tau[1] = middle - half * cosine;
    tau[2] = half * sine;
    tau[3] = t[2];
  }
};

/// The eigenvalue of b that is farthest from the others is found by the cosine of a third of an angle,
/// where that is exact, the other two in the plane across its direction. Source: Eberly, A Robust Eigensolver
/// for 3x3 Symmetric Matrices (2014).
template <>
struct PrincipalStretches<3>
{
  double log[3];
  double n[3][3]; ///< axes of unit length, one in each row

  /// \param F of positive determinant
  KOKKOS_INLINE_FUNCTION explicit PrincipalStretches(const double* F)
  {
    const Deviator b(F);
    double value[3];
    if (b.size > 0.0)
    {
      value[0] = b.middle + b.size * b.alone;
      findFirst(b.B, b.alone);
      findOthers(b, value);
    }
    else
      for (int i = 0; i < 3; ++i)
      {
        value[i] = b.middle;
        for (int j = 0; j < 3; ++j)
          n[i][j] = i == j ? 1.0 : 0.0;
      }
    takeLogarithms(F, value, log);
  }

  /// Without the axes: all three, and the squares of the stretches. Where two are close, their difference has
  /// an error of the root of rounding, but not their sum.
  KOKKOS_INLINE_FUNCTION static void logarithms(const double* F, double (&log)[3], double (&square)[3])
  {
    const Deviator b(F);
    const double half = 0.5 * std::sqrt(larger(12.0 - 3.0 * b.alone * b.alone, 0.0));
    square[0] = b.middle + b.size * b.alone;
    square[1] = b.middle + b.size * (half - 0.5 * b.alone);
    square[2] = b.middle - b.size * (half + 0.5 * b.alone);
    takeLogarithms(F, square, log);
  }

  KOKKOS_INLINE_FUNCTION void assemble(const double (&t)[3], double* tau) const
  {
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j)
        tau[symmetricIndex<3>(i, j)] =
            t[0] * n[0][i] * n[0][j] + t[1] * n[1][i] * n[1][j] + t[2] * n[2][i] * n[2][j];
  }

private:
  /// b = middle 1 + size B, with B : B = 6.
  struct Deviator
  {
    double middle, size;
    double B[6];
    double alone; ///< the eigenvalue of B that is farthest from the others

    KOKKOS_INLINE_FUNCTION explicit Deviator(const double* F)
    {
      leftStrain<3>(F, B);
      const double mean = trace<3>(B) / 3.0;
      middle = 1.0 + mean;
      for (int i = 0; i < 3; ++i)
        B[i] -= mean;
      size = std::sqrt(squaredNorm<3>(B) / 6.0);
      constexpr double least = 1e-150; // its square is still a normal number
      size = size > least ? size : 0.0;
      const double inverse = size > 0.0 ? 1.0 / size : 0.0;
      for (double& component : B)
        component *= inverse;
      const double half = std::fmin(std::fmax(0.5 * symmetricDeterminant<3>(B), -1.0), 1.0);
      alone = (half < 0.0 ? -2.0 : 2.0) * std::cos(std::acos(std::fabs(half)) / 3.0);
    }
  };

  /// The smallest one from the volume: where it is much smaller than the others, b has not its digits.
  KOKKOS_INLINE_FUNCTION static void takeLogarithms(const double* F, const double (&value)[3],
                                                    double (&log)[3])
  {
    const int last = value[0] <= value[1] && value[0] <= value[2] ? 0 : value[1] <= value[2] ? 1 : 2;
    const int one = last == 0 ? 1 : 0, two = last == 2 ? 1 : 2;
    log[one] = 0.5 * std::log(value[one]);
    log[two] = 0.5 * std::log(value[two]);
    log[last] = std::log(determinant<3>(F)) - log[one] - log[two];
  }

  /// n[0], across all rows of B - alone 1, whose rank is two: the largest of their cross products.
  KOKKOS_INLINE_FUNCTION void findFirst(const double (&B)[6], double alone)
  {
    const double row[3][3] = {
        {B[0] - alone, B[3], B[5]}, {B[3], B[1] - alone, B[4]}, {B[5], B[4], B[2] - alone}};
    double largest = -1.0;
    for (int k = 0; k < 3; ++k)
    {
      const double* const a = row[k];
      const double* const b = row[k == 2 ? 0 : k + 1];
      const double c[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
      const double square = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
      if (square > largest)
      {
        largest = square;
        for (int i = 0; i < 3; ++i)
          n[0][i] = c[i];
      }
    }
    const double scale = 1.0 / std::sqrt(largest);
    for (double& component : n[0])
      component *= scale;
  }

  /// n[1], n[2] and their values, in the plane across n[0].
  KOKKOS_INLINE_FUNCTION void findOthers(const Deviator& b, double (&value)[3])
  {
    const double(&B)[6] = b.B;
    const double* const a = n[0];
    double u[3];
    if (std::fabs(a[0]) > std::fabs(a[1]))
    {
      const double scale = 1.0 / std::sqrt(a[0] * a[0] + a[2] * a[2]);
      u[0] = -a[2] * scale;
      u[1] = 0.0;
      u[2] = a[0] * scale;
    }
    else
    {
      const double scale = 1.0 / std::sqrt(a[1] * a[1] + a[2] * a[2]);
      u[0] = 0.0;
      u[1] = a[2] * scale;
      u[2] = -a[1] * scale;
    }
    const double v[3] = {a[1] * u[2] - a[2] * u[1], a[2] * u[0] - a[0] * u[2], a[0] * u[1] - a[1] * u[0]};
    const double Bu[3] = {B[0] * u[0] + B[3] * u[1] + B[5] * u[2], B[3] * u[0] + B[1] * u[1] + B[4] * u[2],
                          B[5] * u[0] + B[4] * u[1] + B[2] * u[2]};
    const double Bv[3] = {B[0] * v[0] + B[3] * v[1] + B[5] * v[2], B[3] * v[0] + B[1] * v[1] + B[4] * v[2],
                          B[5] * v[0] + B[4] * v[1] + B[2] * v[2]};
    const double uu = u[0] * Bu[0] + u[1] * Bu[1] + u[2] * Bu[2];
    const double vv = v[0] * Bv[0] + v[1] * Bv[1] + v[2] * Bv[2];
    const double uv = u[0] * Bv[0] + u[1] * Bv[1] + u[2] * Bv[2];
    const double half = 0.5 * (uu - vv), radius = std::sqrt(half * half + uv * uv);
    value[1] = b.middle + b.size * (0.5 * (uu + vv) + radius);
    value[2] = b.middle + b.size * (0.5 * (uu + vv) - radius);
    // Of the two rows of the plane's tensor less its larger value, the longer one is free of cancellation.
    double x = half >= 0.0 ? radius + half : uv, y = half >= 0.0 ? uv : radius - half;
    const double length = std::sqrt(x * x + y * y);
    x = length > 0.0 ? x / length : 1.0;
    y = length > 0.0 ? y / length : 0.0;
    for (int i = 0; i < 3; ++i)
    {
      n[1][i] = x * u[i] + y * v[i];
      n[2][i] = x * v[i] - y * u[i];
    }
  }
};

/// Stress t_i, and derivatives of the energy by the logarithms of the principal stretches, of a principal
/// state.
struct PrincipalTangent
{
  double stress[3];    ///< Kirchhoff stress [Pa]
  double curvature[3]; ///< w'' of an energy sum w(e_i - tr e / 3) of the shape [Pa]
  double volumetric;   ///< second derivative of the energy of the volume by ln J [Pa]

  /// d^2 W / de_i de_j.
  KOKKOS_INLINE_FUNCTION double second(int i, int j) const
  {
    double sum = volumetric;
    for (int k = 0; k < 3; ++k)
      sum += curvature[k] * ((k == i ? 1.0 : 0.0) - 1.0 / 3.0) * ((k == j ? 1.0 : 0.0) - 1.0 / 3.0);
    return sum;
  }
};

/// Bound of rho0 c^2 [Pa] of an isotropic energy of the principal stretches. Its acoustic tensor is
///     sum A_iiii q_i^2 + sum_{i<j} (A_ijij a^2 + A_jiji b^2 + 2 (A_iijj + A_ijji) a b),
/// q_i = n_i m_i, a = n_i m_j, b = n_j m_i, with a b = q_i q_j put into the second sum. Since all q^2, a^2
/// and b^2 add up to one, it is at most the largest A_iiii or eigenvalue of the forms in a, b. A_iijj =
/// W_ij - delta_ij t_i, A_ijij = s l_i^2, A_ijji = A_ijij - t_i, s = (t_i - t_j) / (l_i^2 - l_j^2), l the
/// stretches (Ogden, Non-Linear Elastic Deformations (1984), 6.1.4). In plane stress the thickness follows.
template <int D, Plane P>
KOKKOS_INLINE_FUNCTION double principalWaveModulus(const PrincipalTangent& at, const double (&square)[3])
{
  const double thickness = P == Plane::Stress ? at.second(2, 2) : 0.0;
  const auto second = [&](int i, int j)
  {
    const double W = at.second(i, j);
    return P == Plane::Stress && thickness > 0.0 ? W - at.second(i, 2) * (at.second(j, 2) / thickness) : W;
  };
  double largest = 0.0;
  for (int i = 0; i < D; ++i)
  {
    largest = larger(largest, second(i, i) - at.stress[i]);
    for (int j = i + 1; j < D; ++j)
    {
      // The mean slope has an error of the square of the difference.
      constexpr double close = 1e-4;
      const double s = std::fabs(square[i] - square[j]) < close * square[j]
                           ? 0.5 * (at.curvature[i] + at.curvature[j]) / (square[i] + square[j])
                           : (at.stress[i] - at.stress[j]) / (square[i] - square[j]);
      const double mixed = second(i, j) + s * square[i] - at.stress[i];
      const double half = 0.5 * s * (square[i] - square[j]);
      largest = larger(largest, 0.5 * s * (square[i] + square[j]) + std::sqrt(half * half + mixed * mixed));
    }
  }
  return largest;
}

} // namespace Rhegma
