#pragma once
/// What follows from the constants of a material of the library.

#include "scene/MaterialLibrary.hpp"
#include "scene/Schema.hpp"

#include <optional>

namespace Rhegma
{

/// Of the usual law at small strain, in plane strain.
struct DerivedConstants
{
  double density = 0.0;                                   ///< [kg/m3]
  double young = 0.0;                                     ///< [Pa]
  double poisson = 0.0;                                   ///< [-]
  double longitudinal = 0.0, shear = 0.0, rayleigh = 0.0; ///< speeds of waves [m/s]
  std::optional<double> toughness;                        ///< of a crack at rest [J/m2]
  std::optional<double> intensity;                        ///< K_Ic = sqrt(E Gc / (1 - nu^2)) [Pa m^0.5]
};

/// \param schema with a section Materials
DerivedConstants deriveConstants(const LibraryMaterial& material, const SceneSchema& schema);

} // namespace Rhegma
