#pragma once
/// Prescribed motion of nodes.

#include "base/Types.hpp"

namespace Rhegma
{

/// Sets the velocity of nodes inside or outside of a box, axis by axis.
template <int D>
struct NodeConstraint
{
  Vector<D> lower, upper;  ///< the box, both corners inside [m]
  bool outside = false;    ///< holds the nodes outside of the box and on its boundary instead
  bool holds[D];           ///< axes that are prescribed
  Vector<D> value;         ///< velocity along them now [m/s]
  View<double* [D]> field; ///< velocity of each lattice node, to be multiplied by `factor`; empty: `value`
  double factor = 1.0;     ///< of `field`, now

  KOKKOS_INLINE_FUNCTION bool appliesAt(const Vector<D>& x) const
  {
    bool in = true;
    for (int d = 0; d < D; ++d)
      in = in && x[d] >= lower[d] && x[d] <= upper[d];
    return in != outside;
  }
  KOKKOS_INLINE_FUNCTION double at(int latticeNode, int axis) const
  {
    return field.extent(0) > 0 ? factor * field(latticeNode, axis) : value[axis];
  }
};

} // namespace Rhegma
