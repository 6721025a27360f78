#pragma once
/// How far the two fields of a node take part in the opening of a crack.

#include "base/Types.hpp"

#include <cmath>

namespace Rhegma
{

/// Fraction of a crack's opening at a node in 2D [-], by the masses of its two fields: where particles are
/// cut at a fraction z of a cell from the node, the lesser field has (1 - z)^2 / 2 of the mass, so that this
/// is 1 - z for the cut that the particles really have. Zero where a field has no particle.
KOKKOS_INLINE_FUNCTION double openingFraction(double mass, double other)
{
  return std::sqrt(2.0 * std::fmin(mass, other) / (mass + other));
}

} // namespace Rhegma
