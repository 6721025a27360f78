#include "material/Units.hpp"

#include "base/ShortNumber.hpp"
#include "material/MaterialTable.hpp"

#include <cmath>

namespace Rhegma
{

std::vector<std::string> warningsOfUnits(const std::vector<std::string>& names,
                                         const std::vector<Properties>& materials)
{
  constexpr double slowest = 10.0, fastest = 30e3;
  std::vector<std::string> warnings;
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    const double speed = std::sqrt(elasticity(materials[m]).constrainedModulus / materials[m].density);
    if (!std::isfinite(speed))
      warnings.push_back(
          "Materials > " + names[m] +
          ": its wave speed sqrt(M / density) is not finite; moduli are in Pa and densities in "
          "kg/m3");
    else if (speed < slowest || speed > fastest)
      warnings.push_back("Materials > " + names[m] + ": its wave speed is " + formatShort(speed) + " m/s, " +
                         (speed < slowest ? "lower than in almost any solid" : "higher than in diamond") +
                         "; moduli are in Pa and densities in kg/m3");
  }
  return warnings;
}

} // namespace Rhegma
