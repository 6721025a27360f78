#pragma once
/// Stress of a particle, and what is made of it.

#include "material/Tensors.hpp"

#include <cmath>

namespace Rhegma
{

/// Cauchy stress of a material point as xx yy zz xy yz xz, sigma = tau / J [Pa]. In 2D yz and xz are zero.
/// \param F deformation gradient \param tau Kirchhoff stress [Pa], both with the components of particle
/// fields \param s six numbers
template <int D>
KOKKOS_INLINE_FUNCTION void cauchyStress(const double* F, const double* tau, double* s)
{
  const double inverse = 1.0 / determinant<D>(F);
  for (int i = 0; i < 3; ++i)
  {
    s[i] = inverse * tau[normalIndex<D>(i)];
    s[3 + i] = 0.0;
  }
  for (int i = shearBegin<D>; i < shearEnd<D>; ++i)
    s[3 + i - shearBegin<D>] = inverse * tau[i];
}

/// Von Mises stress of xx yy zz xy yz xz [Pa].
KOKKOS_INLINE_FUNCTION double vonMisesStress(const double* s)
{
  const double xy = s[0] - s[1], yz = s[1] - s[2], zx = s[2] - s[0];
  const double shear = s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * shear);
}

/// Largest eigenvalue of a stress xx yy zz xy yz xz [Pa]: by Jacobi's rotations, which are as exact where two
/// eigenvalues are equal as elsewhere (Golub and Van Loan, Matrix Computations, 8.5).
KOKKOS_INLINE_FUNCTION double largestPrincipalStress(const double* s)
{
  double A[3][3] = {{s[0], s[3], s[5]}, {s[3], s[1], s[4]}, {s[5], s[4], s[2]}};
  constexpr int sweeps = 8; // they converge quadratically; four suffice for any tensor
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q)
      {
        if (A[p][q] == 0.0)
          continue;
        const double theta = 0.5 * (A[q][q] - A[p][p]) / A[p][q];
        const double t = (theta < 0.0 ? -1.0 : 1.0) / (std::fabs(theta) + std::hypot(theta, 1.0));
        const double c = 1.0 / std::sqrt(1.0 + t * t), sine = t * c;
        const int r = 3 - p - q;
        const double rp = A[r][p], rq = A[r][q];
        A[p][p] -= t * A[p][q];
        A[q][q] += t * A[p][q];
        A[p][q] = A[q][p] = 0.0;
        A[r][p] = A[p][r] = c * rp - sine * rq;
        A[r][q] = A[q][r] = sine * rp + c * rq;
      }
  const double two = A[0][0] > A[1][1] ? A[0][0] : A[1][1];
  return two > A[2][2] ? two : A[2][2];
}

} // namespace Rhegma
