#pragma once
/// The speed of Rayleigh waves.

#include "material/Law.hpp"

namespace Rhegma
{

/// Speed of waves along a free surface at small strain [m/s], which no crack under tension passes: the root
/// of
///
///     4 sqrt(1 - v^2/c_d^2) sqrt(1 - v^2/c_s^2) = (2 - v^2/c_s^2)^2
///
/// with the speeds c_d and c_s of dilatational and shear waves; in plane stress c_d is that of the plate.
/// In an anisotropic material, where it depends on direction, an upper bound: the speed of the slowest wave
/// in a body, which limits that at its surface (Barnett and Lothe, J. Phys. F 4 (1974) 671), in the direction
/// where it is largest. Source: Freund, Dynamic Fracture Mechanics, Cambridge 1990, section 2.4.
double rayleighSpeed(const Properties& material);

} // namespace Rhegma
