#pragma once
/// A few doubles in one vector register.

#include <Kokkos_Core.hpp>

namespace Rhegma
{

#if defined(__GNUC__) && !defined(__CUDACC__) && !defined(__HIPCC__) && !defined(__SYCL_DEVICE_ONLY__)

template <int W>
struct PackData
{
  typedef double Vector __attribute__((vector_size(W * sizeof(double))));
  typedef double Unaligned
      __attribute__((vector_size(W * sizeof(double)), aligned(sizeof(double)), may_alias));
};

/// W doubles, W a power of two: part of a row of nodal values. The compiler's own vector, which is one
/// register where the processor has registers so wide; loops over its parts compile to far worse code.
template <int W>
struct Pack
{
  using Vector = typename PackData<W>::Vector;
  using Unaligned = typename PackData<W>::Unaligned;
  Vector c;

  KOKKOS_FORCEINLINE_FUNCTION double operator[](int k) const { return c[k]; }
  KOKKOS_FORCEINLINE_FUNCTION static Pack zero() { return {Vector{}}; }
  /// Reads W numbers; they need no alignment.
  KOKKOS_FORCEINLINE_FUNCTION static Pack load(const double* from)
  {
    return {*reinterpret_cast<const Unaligned*>(from)};
  }
  KOKKOS_FORCEINLINE_FUNCTION void store(double* to) const { *reinterpret_cast<Unaligned*>(to) = c; }
  /// Adds s a.
  KOKKOS_FORCEINLINE_FUNCTION void add(double s, const Pack& a) { c += s * a.c; }
  /// Adds s a, number by number.
  KOKKOS_FORCEINLINE_FUNCTION void add(const Pack& s, const Pack& a) { c += s.c * a.c; }
};

template <int W>
KOKKOS_FORCEINLINE_FUNCTION Pack<W> operator*(double s, const Pack<W>& a)
{
  return {s * a.c};
}

template <int W>
KOKKOS_FORCEINLINE_FUNCTION Pack<W> operator*(const Pack<W>& s, const Pack<W>& a)
{
  return {s.c * a.c};
}

KOKKOS_FORCEINLINE_FUNCTION Pack<2> pack(double a, double b) { return {Pack<2>::Vector{a, b}}; }
KOKKOS_FORCEINLINE_FUNCTION Pack<4> pack(double a, double b, double c, double d)
{
  return {Pack<4>::Vector{a, b, c, d}};
}

#else

/// W doubles: part of a row of nodal values.
template <int W>
struct Pack
{
  double c[W]; ///< the numbers

  KOKKOS_FORCEINLINE_FUNCTION double operator[](int k) const { return c[k]; }
  KOKKOS_FORCEINLINE_FUNCTION static Pack zero() { return {}; }
  KOKKOS_FORCEINLINE_FUNCTION static Pack load(const double* from)
  {
    Pack r;
    for (int k = 0; k < W; ++k)
      r.c[k] = from[k];
    return r;
  }
  KOKKOS_FORCEINLINE_FUNCTION void store(double* to) const
  {
    for (int k = 0; k < W; ++k)
      to[k] = c[k];
  }
  /// Adds s a.
  KOKKOS_FORCEINLINE_FUNCTION void add(double s, const Pack& a)
  {
    for (int k = 0; k < W; ++k)
      c[k] += s * a.c[k];
  }
  /// Adds s a, number by number.
  KOKKOS_FORCEINLINE_FUNCTION void add(const Pack& s, const Pack& a)
  {
    for (int k = 0; k < W; ++k)
      c[k] += s.c[k] * a.c[k];
  }
};

template <int W>
KOKKOS_FORCEINLINE_FUNCTION Pack<W> operator*(double s, const Pack<W>& a)
{
  Pack<W> r = Pack<W>::zero();
  r.add(s, a);
  return r;
}

template <int W>
KOKKOS_FORCEINLINE_FUNCTION Pack<W> operator*(const Pack<W>& s, const Pack<W>& a)
{
  Pack<W> r = Pack<W>::zero();
  r.add(s, a);
  return r;
}

KOKKOS_FORCEINLINE_FUNCTION Pack<2> pack(double a, double b) { return {{a, b}}; }
KOKKOS_FORCEINLINE_FUNCTION Pack<4> pack(double a, double b, double c, double d) { return {{a, b, c, d}}; }

#endif

} // namespace Rhegma
