#pragma once
/// The point of a segment or triangle of a crack that is nearest to another point.

#include "geometry/NearestOnSimplex.hpp"

namespace Rhegma::surface
{

using Geometry::distanceToSegment;
using Geometry::distanceToSimplex;
using Geometry::Foot;
using Geometry::footOn;
using Geometry::pointAt;

} // namespace Rhegma::surface
