#include "boundary/BoundaryParts.hpp"

#include "base/ReadList.hpp"

namespace Rhegma
{

namespace
{

/// Traction over a surface; a pressure pushes against the outward normal.
template <int D>
PlacedLoad<D> placeTraction(const Teuchos::ParameterList& list, const Seeds<D>& seeds, double thickness,
                            const std::string& where)
{
  const PlacedSurface<D> surface = placeSurface<D>(list, seeds, thickness, where);
  return {surface.points, list.isParameter("Pressure") ? -list.get<double>("Pressure") * surface.area
                                                       : norm(surface.area) * readVector<D>(list, "Stress")};
}

template <int D>
void addTraction(BoundaryParts<D>& parts, const Teuchos::ParameterList& list, const std::string& name)
{
  parts.loads.push_back(
      [=](const State<D>& state)
      { return readLoad<D>(list, state, name, list.get<std::string>("History"), placeTraction<D>); });
}

} // namespace

BoundaryType tractionBoundary()
{
  Section s("Traction", "A force per undeformed area on a part of a body's surface: a line (2D) or a "
                        "parallelogram (3D) of the undeformed body. It moves with the body.");
  describeSurface(s);
  s.realArray("Stress").unit("Pa").perAxis().optional().meaning(
      "Force vector per undeformed area, in a fixed direction.");
  s.real("Pressure")
      .unit("Pa")
      .optional()
      .meaning(
          "Pressure normal to the undeformed surface; positive values push into the body, which must lie to "
          "the left of the direction from From to To (2D), or opposite to Edge 1 x Edge 2 (3D).");
  s.exactlyOneOf({"Stress", "Pressure"});
  describeHistory(s);
  return {s, checkSurface, addTraction<2>, addTraction<3>};
}

} // namespace Rhegma
