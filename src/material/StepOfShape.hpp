#pragma once
/// Small algebra of the calls of shared laws.

#include "base/Types.hpp"

namespace Rhegma
{

/// Determinant of a symmetric tensor xx yy zz xy yz xz, component by component: a[k * n + l].
inline double shapeDeterminant(const double* a, int n, int l)
{
  const double xx = a[l], yy = a[n + l], zz = a[2 * n + l], xy = a[3 * n + l], yz = a[4 * n + l],
               xz = a[5 * n + l];
  return xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
}

/// G = change middle^-1 of two symmetric tensors xx yy zz xy yz xz. \param G out: in rows
inline void stepOfShape(const double* change, const double* middle, double* G)
{
  const double xx = middle[0], yy = middle[1], zz = middle[2], xy = middle[3], yz = middle[4], xz = middle[5];
  double C[6] = {yy * zz - yz * yz, xx * zz - xz * xz, xx * yy - xy * xy,
                 xz * yz - xy * zz, xy * xz - xx * yz, xy * yz - xz * yy};
  const double scale = 1.0 / (xx * C[0] + xy * C[3] + xz * C[5]);
  for (double& c : C)
    c *= scale;
  constexpr int at[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      double sum = 0.0;
      for (int k = 0; k < 3; ++k)
        sum += change[at[i][k]] * C[at[k][j]];
      G[3 * i + j] = sum;
    }
}

/// Inverse of a matrix in rows.
inline void inverseOf(const double (&A)[9], double (&B)[9])
{
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      B[3 * j + i] = A[3 * i1 + j1] * A[3 * i2 + j2] - A[3 * i1 + j2] * A[3 * i2 + j1];
    }
  const double scale = 1.0 / (A[0] * B[0] + A[1] * B[3] + A[2] * B[6]);
  for (double& b : B)
    b *= scale;
}

inline double determinantOf(const double (&F)[9])
{
  return F[0] * (F[4] * F[8] - F[5] * F[7]) - F[1] * (F[3] * F[8] - F[5] * F[6]) +
         F[2] * (F[3] * F[7] - F[4] * F[6]);
}

/// C = A B of matrices in rows.
inline void product(const double (&A)[9], const double (&B)[9], double (&C)[9])
{
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      C[3 * i + j] = A[3 * i] * B[j] + A[3 * i + 1] * B[3 + j] + A[3 * i + 2] * B[6 + j];
}

/// R s R^T of a symmetric tensor xx yy zz xy yz xz, in place.
inline void turn(const double (&R)[9], double (&s)[6])
{
  const double S[9] = {s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2]};
  const double turned[9] = {R[0], R[3], R[6], R[1], R[4], R[7], R[2], R[5], R[8]}; // R^T
  double half[9], whole[9];
  product(R, S, half);
  product(half, turned, whole);
  const double result[6] = {whole[0], whole[4], whole[8], whole[1], whole[5], whole[2]};
  for (int k = 0; k < 6; ++k)
    s[k] = result[k];
}

} // namespace Rhegma
