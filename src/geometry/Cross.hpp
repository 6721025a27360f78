#pragma once
/// The cross product.

#include "base/Types.hpp"

namespace Rhegma
{

KOKKOS_INLINE_FUNCTION Vector<3> cross(const Vector<3>& a, const Vector<3>& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

} // namespace Rhegma
