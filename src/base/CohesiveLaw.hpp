#pragma once
/// A cohesive traction that falls linearly, without state.

#include "base/Types.hpp"

namespace Rhegma
{

/// A cohesive traction that falls linearly from T at an onset to zero at an opening w further on; unloading
/// and reloading follow the secant. It dissipates T w / 2. As a nodal force its numbers are those below; as a
/// traction those in parentheses.
///
/// Of a node behind a front the onset is T / k. The two fields of a node that a front passes are held
/// together at first by the force T that gives both one acceleration. The opening is counted from -T / k, so
/// that the traction can turn with it and has a finite stiffness k at first. Compressive forces are no
/// cohesion and are left out (HoldingForce.hpp).
struct CohesiveLaw
{
  double strength = 0.0; ///< T [N] (Pa)
  double range = 0.0;    ///< w [m]
  double onset = 0.0;    ///< T / k [m]

  /// Force per opening [N/m] (Pa/m) where the largest opening so far is `largest` [m].
  KOKKOS_INLINE_FUNCTION double secant(double largest) const
  {
    const double left = 1.0 - (largest - onset) / range;
    return left > 0.0 ? strength * left / largest : 0.0;
  }

  /// The same on the line of the fall, also beyond its ends.
  KOKKOS_INLINE_FUNCTION double falling(double largest) const
  {
    return strength * (1.0 - (largest - onset) / range) / largest;
  }

  /// Force at an opening [N]. \param largest opening so far [m]
  KOKKOS_INLINE_FUNCTION double traction(double opening, double largest) const
  {
    return secant(opening > largest ? opening : largest) * opening;
  }

  /// Whether the fields have separated. \param largest opening so far [m]
  KOKKOS_INLINE_FUNCTION bool isOpen(double largest) const { return !(traction(largest, largest) > 0.0); }

  /// What the traction dissipates from its onset to zero [J].
  KOKKOS_INLINE_FUNCTION double energy() const { return 0.5 * strength * range; }

  /// Work of the traction from an opening until the node is open [J], including what it stores elastically.
  /// \param square of the opening now [m2]
  KOKKOS_INLINE_FUNCTION double pendingEnergy(double largest, double square) const
  {
    const double force = traction(largest, largest);
    return force > 0.0 ? 0.5 * force * (onset + range - largest) +
                             0.5 * force / largest * (largest * largest - square)
                       : 0.0;
  }
};

} // namespace Rhegma
