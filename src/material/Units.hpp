#pragma once
/// Checks that constants of a material are plausible in SI units.

#include "material/Law.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

/// A warning for each material with a wave speed below 10 m/s or above 30 km/s, as from moduli in GPa or a
/// density in g/cm3. Shear waves have some metres a second in the softest gels; dilatational ones are faster
/// in all solids, and at 18 km/s in diamond the fastest. \param names and constants of the materials
std::vector<std::string> warningsOfUnits(const std::vector<std::string>& names,
                                         const std::vector<Properties>& materials);

} // namespace Rhegma
