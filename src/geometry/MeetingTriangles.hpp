#pragma once
/// Triangles of a surface that intersect.

#include "geometry/Shells.hpp"

namespace Rhegma::Geometry
{

/// Refuses a surface that meets itself, or shells that meet each other. Triangles of less height than the
/// resolution are not looked at.
/// \throws std::invalid_argument with the number of pairs and a position
void refuseMeetings(const Simplices<3>& surface, const Shells& shells, double resolution);

} // namespace Rhegma::Geometry
