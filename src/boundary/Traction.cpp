#include "boundary/BoundaryParts.hpp"

#include "base/ReadList.hpp"

#include <stdexcept>

namespace Rhegma
{

namespace
{

/// Traction over a surface; a pressure pushes against the outward normal.
template <int D>
PlacedLoad<D> placeTraction(const Teuchos::ParameterList& scene, const Teuchos::ParameterList& list,
                            const Seeds<D>& seeds, const std::string& where)
{
  const PlacedSurface<D> surface = placeSurface<D>(scene, list, seeds, where);
  const auto& [area, outward] = surface.measure;
  if (!(area > 0.0))
    throw std::invalid_argument(
        where + ": its surface has no area, as a line on the axis of revolution; write a surface "
                "away from the axis");
  if (list.isParameter("Force"))
    return {surface.points, readVector<D>(list, "Force")};
  if (!list.isParameter("Pressure"))
    return {surface.points, area * readVector<D>(list, "Stress")};
  const double pull = -list.get<double>("Pressure");
  if (surface.flat)
    return {surface.points, pull * outward};
  return {surface.points, {}, pull * area};
}

template <int D>
void addTraction(BoundaryParts<D>& parts, const Teuchos::ParameterList& list, const std::string& name)
{
  const auto place = [scene = &parts.scene](const auto&... of) { return placeTraction<D>(*scene, of...); };
  parts.loads.push_back([=](const State<D>& state)
                        { return readLoad<D>(list, state, name, list.get<std::string>("History"), place); });
}

} // namespace

BoundaryType tractionBoundary()
{
  Section s("Traction", "A force per undeformed area on a part of a body's surface: a line (2D) or a "
                        "parallelogram (3D) of the undeformed body, or a choice of all of its surface. It "
                        "moves with the body.");
  describeSurface(s);
  s.realArray("Stress").unit("Pa").perAxis().optional().meaning(
      "Force vector per undeformed area, in a fixed direction.");
  s.real("Pressure")
      .unit("Pa")
      .optional()
      .meaning(
          "Pressure normal to the undeformed surface; positive values push into the body, which must lie to "
          "the left of the direction from From to To (2D), or opposite to Edge 1 x Edge 2 (3D). With Surface "
          "= Body it is normal to the surface at each point. Its direction does not turn with the body.");
  s.realArray("Force").unit("N").perAxis().optional().meaning(
      "Force on all of the surface, in a fixed direction, spread evenly over its area; in 2D on the whole "
      "thickness.");
  s.exactlyOneOf({"Stress", "Pressure", "Force"});
  describeHistory(s);
  return {s, checkSurface, addTraction<2>, addTraction<3>};
}

} // namespace Rhegma
