#pragma once
/// The D components of a slot's value, in registers.

#include "base/Pack.hpp"

namespace Rhegma::sub_cycling
{

/// D numbers of one slot. In 2D one register: compilers make none of loops over two components.
template <int D>
struct SlotRow
{
  double c[D];

  KOKKOS_FORCEINLINE_FUNCTION double operator[](int d) const { return c[d]; }
  KOKKOS_FORCEINLINE_FUNCTION static SlotRow zero() { return {}; }
  KOKKOS_FORCEINLINE_FUNCTION static SlotRow load(const double* from)
  {
    SlotRow row;
    for (int d = 0; d < D; ++d)
      row.c[d] = from[d];
    return row;
  }
  KOKKOS_FORCEINLINE_FUNCTION void store(double* to) const
  {
    for (int d = 0; d < D; ++d)
      to[d] = c[d];
  }
  /// Adds s a.
  KOKKOS_FORCEINLINE_FUNCTION void add(double s, const SlotRow& a)
  {
    for (int d = 0; d < D; ++d)
      c[d] += s * a.c[d];
  }
  /// Adds s a, component by component.
  KOKKOS_FORCEINLINE_FUNCTION void add(const SlotRow& s, const SlotRow& a)
  {
    for (int d = 0; d < D; ++d)
      c[d] += s.c[d] * a.c[d];
  }
};

template <>
struct SlotRow<2> : Pack<2>
{
  KOKKOS_FORCEINLINE_FUNCTION SlotRow() = default;
  KOKKOS_FORCEINLINE_FUNCTION SlotRow(const Pack<2>& row) : Pack<2>(row) {}
  KOKKOS_FORCEINLINE_FUNCTION static SlotRow zero() { return Pack<2>::zero(); }
  KOKKOS_FORCEINLINE_FUNCTION static SlotRow load(const double* from) { return Pack<2>::load(from); }
};

/// Slopes of one node's function for all components of a displacement: `of` as ComponentSlopes has them.
/// Calls visit(j, slopes along axis j): one number for all components, or one for each of them.
template <int D, bool ForEachComponent, class Visit>
KOKKOS_FORCEINLINE_FUNCTION void forEachSlope(const double* of, const Visit& visit)
{
  for (int j = 0; j < D; ++j)
    if constexpr (ForEachComponent)
      visit(j, SlotRow<D>::load(of + D * j));
    else
      visit(j, of[j]);
}

} // namespace Rhegma::sub_cycling
