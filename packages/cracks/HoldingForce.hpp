#pragma once
/// The force that holds the two fields of a node together, and the largest stable stiffness of a spring
/// between them.

#include "cracks/Nearest.hpp"
#include "cracks/Sides.hpp"
#include "cracks/SpringConstants.hpp"
#include "state/State.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma::cracks
{

/// Sign of a node's primary field.
KOKKOS_INLINE_FUNCTION double signOf(int side) { return side > 0 ? 1.0 : -1.0; }

/// Whether both fields of a node have mass [kg]. A particle that touches the edge of a node's cells gives it
/// some 1e-14 of the mass of a full cell or nothing, as its position is rounded: on other ranks otherwise.
KOKKOS_INLINE_FUNCTION bool bothHaveMass(double mass, double other)
{
  constexpr double rounding = 1e-12;
  return std::fmin(mass, other) > rounding * (mass + other);
}

/// The largest stiffness of a spring between the fields of the i-th node with two that is stable in the step
/// that this node takes, a substep where it is subcycled, without added inertia [N/m]. Zero where a field has
/// no mass; in equilibrium that of the motion that starts in it, or without limit.
template <int D>
struct StableStiffness
{
  Nodes<D> nodes;
  bool refined;
  View<int*> level;
  int firstSubcycled; ///< level of the first cells whose nodes take substeps
  double limit;       ///< stiffness per reduced mass [1/s2]
  double dt;          ///< of nodes that take the whole step [s]

  explicit StableStiffness(const State<D>& state)
      : nodes(state.mesh.nodes),
        refined(state.mesh.tree.refined()),
        level(state.mesh.tree.nodeLevel),
        firstSubcycled(state.mesh.tree.deepest -
                       std::min(state.mesh.subcycledLevels, state.mesh.tree.deepest) + 1),
        limit(std::numeric_limits<double>::max()),
        dt(state.method.equilibrium() ? state.clock.stepOfMotion : state.clock.dt)
  {
    if (dt > 0.0)
      limit = springs::stableStiffness / (dt * dt);
  }

  /// How often the step of a node is halved.
  KOKKOS_INLINE_FUNCTION int halvings(int node) const
  {
    return refined && level(node) >= firstSubcycled ? level(node) - firstSubcycled + 1 : 0;
  }
  /// Step of a node [s].
  KOKKOS_INLINE_FUNCTION double stepOf(int node) const { return std::ldexp(dt, -halvings(node)); }

  KOKKOS_INLINE_FUNCTION double operator()(int i) const
  {
    const int primary = nodes.parent(i);
    const double a = nodes.sums(primary, Nodes<D>::massAt),
                 b = nodes.sums(nodes.numLattice + i, Nodes<D>::massAt);
    const double most = limit < std::numeric_limits<double>::max()
                            ? std::ldexp(limit, 2 * halvings(primary)) * a * b / (a + b)
                            : limit;
    return bothHaveMass(a, b) ? most : 0.0;
  }
};

/// The force with which side +1 would be held to side -1 [N], so that both fields of the i-th node with two
/// get one acceleration; without its compressive part.
template <int D>
struct HoldingForce
{
  Nodes<D> nodes;
  View<int*> side;
  View<double* [D]> normal;
  View<std::uint64_t*> nearest;
  View<double* [D]> forceSum; ///< forces of all ranks on nodes; empty where there is one rank

  KOKKOS_INLINE_FUNCTION Vector<D> operator()(int i) const
  {
    const int primary = nodes.parent(i), enriched = nodes.numLattice + i;
    const double a = nodes.sums(primary, Nodes<D>::massAt), b = nodes.sums(enriched, Nodes<D>::massAt);
    const int s = simplexOf(nearest(primary));
    Vector<D> force, n;
    for (int d = 0; d < D; ++d)
    {
      const bool ranks = forceSum.extent(0) > 0;
      const double f = ranks ? forceSum(primary, d) : nodes.sums(primary, Nodes<D>::forceAt + d),
                   g = ranks ? forceSum(enriched, d) : nodes.sums(enriched, Nodes<D>::forceAt + d);
      force[d] = signOf(side(primary)) * (f * b - g * a) / (a + b);
      n[d] = normal(s, d);
    }
    const double across = dot(force, n);
    return across < 0.0 ? force - across * n : force;
  }
};

/// Damping C of a spring of two masses [N s/m] for a force by their velocity at the start of a step, from
/// c = 2 springs::damping sqrt(k m), with the inertia m of their relative motion: C = c / (1 + c dt / m)
/// gives the force that is c times the velocity which it leaves at the end of the step, and never reverses
/// the relative motion.
///
/// A step of velocity first and then displacement is stable if C dt / m < 2 and K dt^2 / m + 2 C dt / m < 4,
/// K the stiffness of spring and material. With m = m0 + k dt^2 / 2 (springs::addedInertia), m0 the reduced
/// mass, a spring of any stiffness between two lumped masses leaves at least 3.31 m0 / dt^2 to the material.
/// With m = m0 and the largest k of limited springs (k dt^2 / m = 1) C dt / m is 0.586, and 1.83 is left.
/// \param stiffness k [N/m] \param inertia m [kg] \param dt of the node [s]
KOKKOS_INLINE_FUNCTION double stableDamping(double stiffness, double inertia, double dt)
{
  if (!(stiffness > 0.0) || !(inertia > 0.0))
    return 0.0;
  const double damping = 2.0 * springs::damping * std::sqrt(stiffness * inertia);
  return damping / (1.0 + damping * dt / inertia);
}

} // namespace Rhegma::cracks
