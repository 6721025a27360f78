#pragma once
/// Size of the cells at a position.

#include "state/State.hpp"

namespace Rhegma
{

/// Edge of the leaf in which a position lies [m]; for a few positions, called on the host.
template <int D>
double spacingAt(const State<D>& state, const Vector<D>& x);

} // namespace Rhegma
