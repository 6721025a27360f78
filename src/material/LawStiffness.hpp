#pragma once
/// The stiffness of materials at small strain where it may depend on direction.
///
/// A law whose stiffness does has three more static members, and Properties::mu, lambda and bulk are then
/// means over all directions, for estimates and penalties only:
///
///     PlaneStiffness planeStiffness(numbers)   in the plane of a 2D scene
///     double stiffestModulus(numbers)          density times the square of the largest speed of waves [Pa]
///     double surfaceWaveModulus(numbers)       the same of a wave that no wave along a free surface reaches
///
/// A law that is Hooke's at small strain, and nothing else, has `linear = true`: loads and displacements are
/// then in proportion.

#include "material/MaterialTable.hpp"
#include "material/PlaneStiffness.hpp"

namespace Rhegma
{

/// Whether the law of a material is Hooke's at small strain, and has nothing else.
bool isLinear(const Properties& properties);

/// Whether the stiffness of a material depends on direction.
bool isAnisotropic(const Properties& properties);

/// Whether materials have one law and one stiffness at small strain, along the same axes.
bool haveSameStiffness(const Properties& a, const Properties& b);

/// Density times the square of a speed that no wave along a free surface reaches [Pa].
double surfaceWaveModulus(const Properties& properties);

/// Stiffness at small strain in the plane of a 2D scene.
PlaneStiffness planeStiffness(const Properties& properties);

} // namespace Rhegma
