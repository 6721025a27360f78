#pragma once
/// What lies beyond a facet of a crack's simplex where no other simplex does.

namespace Rhegma::facet
{

constexpr int surfaceBreaking = -1; ///< the surface of the body
constexpr int front = -2;           ///< uncracked material
constexpr int joined = -3;          ///< another crack, which this one has met

} // namespace Rhegma::facet
