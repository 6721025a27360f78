#pragma once
/// Polar decomposition F = R U of many deformation gradients.

#include "base/Types.hpp"

#include <algorithm>

namespace Rhegma
{

/// Deformation gradients that are decomposed together, so that the compiler uses vector instructions.
constexpr int polarLanes = 8;

namespace detail
{

/// X <- (X + X^-T) / 2, whose limit is the rotation of X. \param X row by row \param change out: largest
/// change of a component
inline void towardsRotation(double (&X)[9][polarLanes], double (&change)[polarLanes])
{
  for (int l = 0; l < polarLanes; ++l)
  {
    double C[9]; // cofactors, det X times X^-T
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
      {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        C[3 * i + j] = X[3 * i1 + j1][l] * X[3 * i2 + j2][l] - X[3 * i1 + j2][l] * X[3 * i2 + j1][l];
      }
    const double inverse = 1.0 / (X[0][l] * C[0] + X[1][l] * C[1] + X[2][l] * C[2]);
    // A lane that has converged stays, so that no particle depends on the others of its block.
    const double half = change[l] > 1e-8 ? 0.5 : 0.0;
    double largest = 0.0;
    for (int k = 0; k < 9; ++k)
    {
      const double step = half * (inverse * C[k] - X[k][l]);
      X[k][l] += step;
      largest = std::max(largest, std::fabs(step));
    }
    change[l] = largest;
  }
}

/// Deformation in a plane: R turns by the angle of (F_xx + F_yy, F_yx - F_xy).
inline void polarOfPlane(int n, const double* F, double* R, double* U)
{
  for (int l = 0; l < n; ++l)
  {
    const double xx = F[l], xy = F[n + l], yx = F[3 * n + l], yy = F[4 * n + l];
    const double x = xx + yy, y = yx - xy, scale = 1.0 / std::sqrt(x * x + y * y), c = x * scale,
                 s = y * scale;
    R[l] = R[4 * n + l] = c;
    R[n + l] = -s;
    R[3 * n + l] = s;
    R[8 * n + l] = 1.0;
    R[2 * n + l] = R[5 * n + l] = R[6 * n + l] = R[7 * n + l] = 0.0;
    U[l] = c * xx + s * yx;
    U[n + l] = c * yy - s * xy;
    U[2 * n + l] = F[8 * n + l];
    U[3 * n + l] = 0.5 * (c * xy + s * yy + c * yx - s * xx);
    U[4 * n + l] = U[5 * n + l] = 0.0;
  }
}

} // namespace detail

/// Decomposes F = R U. Newton's iteration of Higham (SIAM J. Sci. Stat. Comput. 7 (1986) 1160) squares the
/// distance to R in each step, so that the step after one of 1e-8 is below rounding.
/// \param n how many \param F component by component, row by row: F[k * n + l] of gradient l; det F > 0
/// \param R out: the same layout \param U out: xx yy zz xy yz xz, U[k * n + l]. Both are not numbers where F
/// is singular or not finite; where det F < 0, R is a reflection. \param plane whether xz, yz, zx and zy are
/// zero
inline void polarDecomposition(int n, const double* F, double* R, double* U, bool plane = false)
{
  if (plane)
    return detail::polarOfPlane(n, F, R, U);
  constexpr int mostSteps = 60; // each halves a stretch that is large
  for (int first = 0; first < n; first += polarLanes)
  {
    const int count = std::min(polarLanes, n - first);
    double X[9][polarLanes], change[polarLanes];
    for (int k = 0; k < 9; ++k)
      for (int l = 0; l < polarLanes; ++l)
        X[k][l] = l < count ? F[k * n + first + l] : (k % 4 == 0 ? 1.0 : 0.0);
    std::fill(change, change + polarLanes, 1.0);
    for (int s = 0; s<mostSteps&& * std::max_element(change, change + polarLanes)> 1e-8; ++s)
      detail::towardsRotation(X, change);
    for (int k = 0; k < 9; ++k)
      for (int l = 0; l < count; ++l)
        R[k * n + first + l] = X[k][l];
    constexpr int row[6] = {0, 1, 2, 0, 1, 0}, column[6] = {0, 1, 2, 1, 2, 2};
    for (int k = 0; k < 6; ++k)
      for (int l = 0; l < count; ++l)
      {
        double sum = 0.0, other = 0.0; // of R^T F and its transpose, equal but for rounding
        for (int i = 0; i < 3; ++i)
        {
          sum += X[3 * i + row[k]][l] * F[(3 * i + column[k]) * n + first + l];
          other += X[3 * i + column[k]][l] * F[(3 * i + row[k]) * n + first + l];
        }
        U[k * n + first + l] = 0.5 * (sum + other);
      }
  }
}

} // namespace Rhegma
