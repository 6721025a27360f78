#pragma once
/// What would hold the two fields of a node together.

#include "cracks/Nearest.hpp"
#include "cracks/Sides.hpp"
#include "state/State.hpp"

#include <algorithm>

namespace Rhegma::cracks
{

/// Share of mass / dt^2 that the stiffness may have: an explicit step of two masses on a spring is stable up
/// to 4, of which the material needs its part.
constexpr double stable = 1.0;

/// Sign of a node's own field.
KOKKOS_INLINE_FUNCTION double signOf(int side) { return side > 0 ? 1.0 : -1.0; }

/// The first level of cells whose nodes take steps of their own.
template <int D>
int firstOfShortSteps(const State<D>& state)
{
  return state.mesh.tree.deepest - std::min(state.mesh.subcycledLevels, state.mesh.tree.deepest) + 1;
}

/// The force with which side +1 would be held to side -1 [N], so that both fields of the i-th node with two
/// get one acceleration; without what pushes the faces apart.
template <int D>
struct HoldingForce
{
  Nodes<D> nodes;
  View<int*> side;
  View<double* [D]> normal;
  View<std::uint64_t*> nearest;
  View<double* [D]> whole; ///< forces of all ranks on nodes; empty where there is one rank

  KOKKOS_INLINE_FUNCTION Vector<D> operator()(int i) const
  {
    const int own = nodes.parent(i), other = nodes.numLattice + i;
    const double a = nodes.sums(own, Nodes<D>::massAt), b = nodes.sums(other, Nodes<D>::massAt);
    const int s = simplexOf(nearest(own));
    Vector<D> force, n;
    for (int d = 0; d < D; ++d)
    {
      const bool ranks = whole.extent(0) > 0;
      const double f = ranks ? whole(own, d) : nodes.sums(own, Nodes<D>::forceAt + d),
                   g = ranks ? whole(other, d) : nodes.sums(other, Nodes<D>::forceAt + d);
      force[d] = signOf(side(own)) * (f * b - g * a) / (a + b);
      n[d] = normal(s, d);
    }
    const double across = dot(force, n);
    return across < 0.0 ? force - across * n : force;
  }
};

} // namespace Rhegma::cracks
