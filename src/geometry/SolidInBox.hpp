#pragma once
/// The part of a box that lies in a solid, exactly.

#include "geometry/PartOfBox.hpp"
#include "geometry/Solid.hpp"

namespace Rhegma::Geometry
{

/// The part of a box along the axes that is inside a solid: volume, centroid and second moments as the
/// surface's segments or triangles bound them, but for rounding.
///
/// Above each point of one side of the box, the length inside the box is the sum of the heights in it at
/// which a line along an axis leaves the solid, minus those at which it enters. So a volume integral is a sum
/// of integrals over the items in the column above the box, each clipped by the sides of the column and of
/// the box. No item needs to know of another one, so nothing has to be decided where edges or corners lie on
/// sides of the box. The column goes out of the solid by the way on which most of the surface in the box
/// faces.
template <int D>
BoxPart<D> partInSolid(const Solid<D>& solid, const Vector<D>& lower, const Vector<D>& upper);

} // namespace Rhegma::Geometry
