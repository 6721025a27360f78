#pragma once
/// Whether constants of a material look as if they were in SI units.

#include "material/Law.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

/// A sentence for each material through which waves run slower than 10 m/s or faster than 30 km/s, which is
/// what moduli in GPa, or a density in g/cm3, come to. Shear waves run at some metres a second through the
/// softest gels; dilatational ones are faster in all solids, and at 18 km/s in diamond the fastest. \param
/// names and constants of the materials
std::vector<std::string> warningsOfUnits(const std::vector<std::string>& names,
                                         const std::vector<Properties>& materials);

} // namespace Rhegma
