#include "boundary/BoundaryParts.hpp"

namespace Rhegma
{

namespace
{

void checkBox(SectionChecks& checks, const Teuchos::ParameterList& boundary, const std::string& where)
{
  checks.corners(boundary, where, true);
}

} // namespace

BoundaryType temperatureBoundary()
{
  Section s("Temperature",
            "Prescribes the temperature of all grid nodes in a box. Needs the section Thermal.");
  s.realArray("Lower Corner").unit("m").perAxis().meaning("Corner of the box with the smallest coordinates.");
  s.realArray("Upper Corner").unit("m").perAxis().meaning("Corner of the box with the largest coordinates.");
  s.real("Temperature").unit("K").positive().meaning("The prescribed temperature.");
  describeHistory(s);
  return {s, checkBox, {}, {}, capability::heat};
}

BoundaryType heatFluxBoundary()
{
  Section s("Heat Flux", "Heat flux into a part of a body's surface. Needs the section Thermal.");
  describeSurface(s);
  s.real("Flux").unit("W/m2").meaning("Heat flux into the body per undeformed area.");
  describeHistory(s);
  return {s, checkSurface, {}, {}, capability::heat};
}

BoundaryType convectionBoundary()
{
  Section s("Convection", "Convective heat exchange of a part of a body's surface with its surroundings. "
                          "Needs the section Thermal.");
  describeSurface(s);
  s.real("Coefficient")
      .unit("W/(m2 K)")
      .positive()
      .meaning("Heat transfer coefficient: heat flux per temperature difference.");
  s.real("Ambient Temperature")
      .unit("K")
      .positive()
      .meaning("Temperature of the surroundings; History is a factor on it.");
  describeHistory(s);
  return {s, checkSurface, {}, {}, capability::heat};
}

} // namespace Rhegma
