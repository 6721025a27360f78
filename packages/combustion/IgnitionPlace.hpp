#pragma once
/// Where a crack may catch fire.

#include "state/State.hpp"

namespace Rhegma::combustion
{

/// A box in which a crack is to catch fire, beside the crack.
struct IgnitionPlace
{
  double away = 0.0;   ///< distance of the box from the crack, 0 where it meets it [m]
  bool inBody = false; ///< whether the part of the crack that is nearer than a cell lies in a body
};

/// Looks for the faces near a box. Collective.
template <int D>
IgnitionPlace lookNearBox(const State<D>& state, int crack, const Vector<D>& lower, const Vector<D>& upper);

} // namespace Rhegma::combustion
