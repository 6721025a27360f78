#pragma once
/// Overlapping bodies.

#include "geometry/Seeds.hpp"

namespace Rhegma
{

/// A particle of the seeds that lies inside a shape with at least half of its edge lengths, so that bodies
/// that touch do not count, whatever the rounding. \return its index, or -1
template <int D>
int findOverlap(const Seeds<D>& seeds, const Shape<D>& other);

} // namespace Rhegma
