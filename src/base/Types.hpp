#pragma once
/// Types used everywhere: execution space, views, and vectors and matrices of a few numbers.

#include <Kokkos_Core.hpp>

#include <cmath>
#include <limits>

namespace Rhegma
{

using ExecSpace = Kokkos::DefaultExecutionSpace; ///< where kernels run
using MemorySpace = ExecSpace::memory_space;     ///< where fields are stored

/// A view in the memory of the execution space. Rows (particles, nodes) are contiguous on every back end, so
/// that one row is one vector load.
template <class Data>
using View = Kokkos::View<Data, Kokkos::LayoutRight, MemorySpace>;

/// A view that borrows the memory of another.
template <class Data>
using BorrowedView =
    Kokkos::View<Data, Kokkos::LayoutRight, MemorySpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;

/// A copy of a view for the host; the view itself where the host has it.
template <class AnyView>
auto onHost(const AnyView& view)
{
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view);
}

/// A vector of D numbers.
template <int D>
struct Vector
{
  double c[D]; ///< the numbers
  KOKKOS_INLINE_FUNCTION double& operator[](int i) { return c[i]; }
  KOKKOS_INLINE_FUNCTION const double& operator[](int i) const { return c[i]; }
};

template <int D>
KOKKOS_INLINE_FUNCTION Vector<D> operator+(const Vector<D>& a, const Vector<D>& b)
{
  Vector<D> r;
  for (int i = 0; i < D; ++i)
    r[i] = a[i] + b[i];
  return r;
}

template <int D>
KOKKOS_INLINE_FUNCTION Vector<D> operator-(const Vector<D>& a, const Vector<D>& b)
{
  Vector<D> r;
  for (int i = 0; i < D; ++i)
    r[i] = a[i] - b[i];
  return r;
}

template <int D>
KOKKOS_INLINE_FUNCTION Vector<D> operator*(double s, const Vector<D>& a)
{
  Vector<D> r;
  for (int i = 0; i < D; ++i)
    r[i] = s * a[i];
  return r;
}

template <int D>
KOKKOS_INLINE_FUNCTION double dot(const Vector<D>& a, const Vector<D>& b)
{
  double r = 0.0;
  for (int i = 0; i < D; ++i)
    r += a[i] * b[i];
  return r;
}

template <int D>
KOKKOS_INLINE_FUNCTION double norm(const Vector<D>& a)
{
  return std::sqrt(dot(a, a));
}

/// A vector that is not yet known: null in the summary.
template <int D>
Vector<D> notANumber()
{
  Vector<D> r;
  for (int i = 0; i < D; ++i)
    r[i] = std::numeric_limits<double>::quiet_NaN();
  return r;
}

/// Components of a symmetric tensor: xx yy xy zz in 2D (zz out of plane), xx yy zz xy yz xz in 3D.
template <int D>
constexpr int symmetricSize = D == 2 ? 4 : 6;

/// Components of a deformation gradient: xx xy yx yy zz in 2D (zz the stretch of the thickness), row by row
/// in 3D.
template <int D>
constexpr int gradientSize = D == 2 ? 5 : 9;

/// Position of component ij (i, j < D) of a symmetric tensor.
template <int D>
KOKKOS_INLINE_FUNCTION constexpr int symmetricIndex(int i, int j)
{
  if (i == j)
    return i;
  return D == 2 ? 2 : (i + j == 1 ? 3 : (i + j == 3 ? 4 : 5));
}

/// How a 2D scene treats the third direction; Solid is 3D.
enum class Plane
{
  Strain,
  Stress,
  Solid
};

} // namespace Rhegma
