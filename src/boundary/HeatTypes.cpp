#include "boundary/BoundaryParts.hpp"

namespace Rhegma
{

namespace
{

/// A line (2D) or a parallelogram (3D) on a body.
void surface(Section& s)
{
  s.text("Body").notEmpty().meaning("Name of the body.");
  s.realArray("From").unit("m").onlyIn(2).length(2).meaning("One end of a line on the undeformed surface.");
  s.realArray("To").unit("m").onlyIn(2).length(2).meaning("Other end of the line.");
  s.realArray("Corner").unit("m").onlyIn(3).length(3).meaning(
      "One corner of a parallelogram on the undeformed surface.");
  s.realArray("Edge 1").unit("m").onlyIn(3).length(3).meaning("Vector of its first edge from Corner.");
  s.realArray("Edge 2").unit("m").onlyIn(3).length(3).meaning("Vector of its second edge from Corner.");
}

void checkBox(SectionChecks& checks, const Teuchos::ParameterList& boundary, const std::string& where)
{
  checks.corners(boundary, where, true);
}

void checkSurface(SectionChecks& checks, const Teuchos::ParameterList& boundary, const std::string& where)
{
  checks.surface(boundary, where);
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
  surface(s);
  s.real("Flux").unit("W/m2").meaning("Heat flux into the body per undeformed area.");
  describeHistory(s);
  return {s, checkSurface, {}, {}, capability::heat};
}

BoundaryType convectionBoundary()
{
  Section s("Convection", "Convective heat exchange of a part of a body's surface with its surroundings. "
                          "Needs the section Thermal.");
  surface(s);
  s.real("Coefficient")
      .unit("W/(m2 K)")
      .positive()
      .meaning("Heat transfer coefficient: heat flux per temperature difference.");
  s.real("Ambient Temperature")
      .unit("K")
      .positive()
      .meaning("Temperature of the surroundings; History multiplies it.");
  describeHistory(s);
  return {s, checkSurface, {}, {}, capability::heat};
}

} // namespace Rhegma
