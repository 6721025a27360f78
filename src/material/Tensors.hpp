#pragma once
/// Algebra of the tensors of a particle in the layouts of base/Types.hpp. In 2D a symmetric tensor includes
/// zz, so that traces, invariants and determinants are always those of the solid.

#include "base/Types.hpp"

// These are always inlined: a call in the loop over particles would keep it from being vectorised.

namespace Rhegma
{

/// Position of the normal component ii, i = 0, 1, 2, of a symmetric tensor.
template <int D>
KOKKOS_INLINE_FUNCTION constexpr int normalIndex(int i)
{
  return D == 2 && i == 2 ? 3 : i;
}

/// First of the shear components of a symmetric tensor, and one past the last.
template <int D>
constexpr int shearBegin = D == 2 ? 2 : 3;
template <int D>
constexpr int shearEnd = D == 2 ? 3 : 6;

/// Area ratio of the plane.
KOKKOS_FORCEINLINE_FUNCTION double planeDeterminant(const double* F) { return F[0] * F[3] - F[1] * F[2]; }

/// Volume ratio J.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION double determinant(const double* F)
{
  if constexpr (D == 2)
    return planeDeterminant(F) * F[4];
  else
    return F[0] * (F[4] * F[8] - F[5] * F[7]) - F[1] * (F[3] * F[8] - F[5] * F[6]) +
           F[2] * (F[3] * F[7] - F[4] * F[6]);
}

/// g = F F^T - 1. Laws written in g keep their digits at small strain.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION void leftStrain(const double* F, double* g)
{
  if constexpr (D == 2)
  {
    g[0] = F[0] * F[0] + F[1] * F[1] - 1.0;
    g[1] = F[2] * F[2] + F[3] * F[3] - 1.0;
    g[2] = F[0] * F[2] + F[1] * F[3];
    g[3] = F[4] * F[4] - 1.0;
  }
  else
  {
    g[0] = F[0] * F[0] + F[1] * F[1] + F[2] * F[2] - 1.0;
    g[1] = F[3] * F[3] + F[4] * F[4] + F[5] * F[5] - 1.0;
    g[2] = F[6] * F[6] + F[7] * F[7] + F[8] * F[8] - 1.0;
    g[3] = F[0] * F[3] + F[1] * F[4] + F[2] * F[5];
    g[4] = F[3] * F[6] + F[4] * F[7] + F[5] * F[8];
    g[5] = F[0] * F[6] + F[1] * F[7] + F[2] * F[8];
  }
}

/// F^T F - 1.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION void rightStrain(const double* F, double* c)
{
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j)
    {
      double sum = i == j ? -1.0 : 0.0;
      for (int k = 0; k < D; ++k)
        sum += F[k * D + i] * F[k * D + j];
      c[symmetricIndex<D>(i, j)] = sum;
    }
  if constexpr (D == 2)
    c[3] = F[4] * F[4] - 1.0;
}

template <int D>
KOKKOS_FORCEINLINE_FUNCTION double trace(const double* a)
{
  return a[0] + a[1] + a[normalIndex<D>(2)];
}

/// a : a.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION double squaredNorm(const double* a)
{
  const double zz = a[normalIndex<D>(2)];
  double shear = 0.0;
  for (int i = shearBegin<D>; i < shearEnd<D>; ++i)
    shear += a[i] * a[i];
  return a[0] * a[0] + a[1] * a[1] + zz * zz + 2.0 * shear;
}

/// a : b.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION double contraction(const double* a, const double* b)
{
  const int zz = normalIndex<D>(2);
  double shear = 0.0;
  for (int i = shearBegin<D>; i < shearEnd<D>; ++i)
    shear += a[i] * b[i];
  return a[0] * b[0] + a[1] * b[1] + a[zz] * b[zz] + 2.0 * shear;
}

/// Second invariant, ((tr a)^2 - a : a) / 2.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION double secondInvariant(const double* a)
{
  const double zz = a[normalIndex<D>(2)];
  double shear = 0.0;
  for (int i = shearBegin<D>; i < shearEnd<D>; ++i)
    shear += a[i] * a[i];
  return a[0] * a[1] + (a[0] + a[1]) * zz - shear;
}

/// Determinant of a symmetric tensor.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION double symmetricDeterminant(const double* a)
{
  if constexpr (D == 2)
    return (a[0] * a[1] - a[2] * a[2]) * a[3];
  else
    return a[0] * (a[1] * a[2] - a[4] * a[4]) - a[3] * (a[3] * a[2] - a[4] * a[5]) +
           a[5] * (a[3] * a[4] - a[1] * a[5]);
}

/// s = a a.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION void square(const double* a, double* s)
{
  if constexpr (D == 2)
  {
    const double shear = a[2] * a[2];
    s[0] = a[0] * a[0] + shear;
    s[1] = a[1] * a[1] + shear;
    s[2] = a[2] * (a[0] + a[1]);
    s[3] = a[3] * a[3];
  }
  else
  {
    const double xy = a[3] * a[3];
    const double yz = a[4] * a[4];
    const double xz = a[5] * a[5];
    s[0] = a[0] * a[0] + xy + xz;
    s[1] = a[1] * a[1] + xy + yz;
    s[2] = a[2] * a[2] + yz + xz;
    s[3] = a[3] * (a[0] + a[1]) + a[5] * a[4];
    s[4] = a[4] * (a[1] + a[2]) + a[3] * a[5];
    s[5] = a[5] * (a[0] + a[2]) + a[3] * a[4];
  }
}

/// result = F a F^T for a symmetric a.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION void pushForward(const double* F, const double* a, double* result)
{
  double Fa[D * D];
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
    {
      double sum = 0.0;
      for (int k = 0; k < D; ++k)
        sum += F[D * i + k] * a[symmetricIndex<D>(k, j)];
      Fa[D * i + j] = sum;
    }
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j)
    {
      double sum = 0.0;
      for (int k = 0; k < D; ++k)
        sum += Fa[D * i + k] * F[D * j + k];
      result[symmetricIndex<D>(i, j)] = sum;
    }
  if constexpr (D == 2)
    result[3] = F[4] * F[4] * a[3];
}

/// Inverse of F. \param J its determinant, not zero
template <int D>
KOKKOS_FORCEINLINE_FUNCTION void inverse(const double* F, double J, double* result)
{
  if constexpr (D == 2)
  {
    const double scale = F[4] / J;
    result[0] = F[3] * scale;
    result[1] = -F[1] * scale;
    result[2] = -F[2] * scale;
    result[3] = F[0] * scale;
    result[4] = 1.0 / F[4];
  }
  else
  {
    const double scale = 1.0 / J;
    result[0] = (F[4] * F[8] - F[5] * F[7]) * scale;
    result[1] = (F[2] * F[7] - F[1] * F[8]) * scale;
    result[2] = (F[1] * F[5] - F[2] * F[4]) * scale;
    result[3] = (F[5] * F[6] - F[3] * F[8]) * scale;
    result[4] = (F[0] * F[8] - F[2] * F[6]) * scale;
    result[5] = (F[2] * F[3] - F[0] * F[5]) * scale;
    result[6] = (F[3] * F[7] - F[4] * F[6]) * scale;
    result[7] = (F[1] * F[6] - F[0] * F[7]) * scale;
    result[8] = (F[0] * F[4] - F[1] * F[3]) * scale;
  }
}

/// Result of a law that fails: zero stress and false.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION bool noStress(double* tau)
{
  for (int i = 0; i < symmetricSize<D>; ++i)
    tau[i] = 0.0;
  return false;
}

/// 2 ln J from g = F F^T - 1, exact in the digits of g: det(1 + g) = 1 + I + II + III.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION double logVolumeSquared(const double* g)
{
  return std::log1p(trace<D>(g) + secondInvariant<D>(g) + symmetricDeterminant<D>(g));
}

} // namespace Rhegma
