#include "boundary/BoundaryParts.hpp"

#include "base/ReadList.hpp"
#include "geometry/Cross.hpp"

namespace Rhegma
{

namespace
{

double length(const Vector<2>& a) { return norm(a); }

/// Traction over a segment of unit thickness times the thickness; a pressure pushes against the outward
/// normal, which is to the right of From -> To.
PlacedLoad<2> placeTraction(const Teuchos::ParameterList& list, const Seeds<2>& seeds, double thickness,
                            const std::string& where)
{
  const Vector<2> from = readVector<2>(list, "From"), to = readVector<2>(list, "To");
  const Vector<2> along = to - from;
  Vector<2> force;
  if (list.isParameter("Pressure"))
    force = -list.get<double>("Pressure") * thickness * Vector<2>{along[1], -along[0]};
  else
    force = length(along) * thickness * readVector<2>(list, "Stress");
  return {lineLoad<2>(seeds, from, to, Profile::Uniform, where), force};
}

PlacedLoad<3> placeTraction(const Teuchos::ParameterList& list, const Seeds<3>& seeds, double,
                            const std::string& where)
{
  const Vector<3> corner = readVector<3>(list, "Corner");
  const Vector<3> a = readVector<3>(list, "Edge 1"), b = readVector<3>(list, "Edge 2");
  const Vector<3> area = cross(a, b);
  Vector<3> force;
  if (list.isParameter("Pressure"))
    force = -list.get<double>("Pressure") * area;
  else
    force = norm(area) * readVector<3>(list, "Stress");
  return {faceLoad(seeds, corner, a, b, where), force};
}

template <int D>
void addTraction(BoundaryParts<D>& parts, const Teuchos::ParameterList& list, const std::string& name)
{
  parts.loads.push_back(
      [=](const State<D>& state)
      {
        return readLoad<D>(list, state, name, list.get<std::string>("History"),
                           [](const auto&... of) { return placeTraction(of...); });
      });
}

void checkTraction(SectionChecks& checks, const Teuchos::ParameterList& boundary, const std::string& where)
{
  checks.surface(boundary, where);
}

} // namespace

template <int D>
Surface<D> readSurface(const Teuchos::ParameterList& list, const State<D>& state, const std::string& name)
{
  Teuchos::ParameterList unit(list);
  unit.set("Pressure", 1.0);
  double area = 0.0;
  const auto position = [&](const auto&... of)
  {
    const PlacedLoad<D> placed = placeTraction(of...);
    area = norm(placed.force);
    return placed;
  };
  Load<D> points = readLoad<D>(unit, state, name, "1", position);
  return {std::move(points), area};
}

template Surface<2> readSurface(const Teuchos::ParameterList&, const State<2>&, const std::string&);
template Surface<3> readSurface(const Teuchos::ParameterList&, const State<3>&, const std::string&);

BoundaryType tractionBoundary()
{
  Section s("Traction", "A force per undeformed area on a part of a body's surface: a line (2D) or a "
                        "parallelogram (3D) of the undeformed body. It moves with the body.");
  describeLoadedBody(s);
  s.realArray("From").unit("m").onlyIn(2).length(2).meaning("One end of the line, in the undeformed body.");
  s.realArray("To").unit("m").onlyIn(2).length(2).meaning(
      "Other end of the line. The body lies to the left of the direction from From to To.");
  s.realArray("Corner").unit("m").onlyIn(3).length(3).meaning(
      "One corner of the parallelogram, in the undeformed body.");
  s.realArray("Edge 1").unit("m").onlyIn(3).length(3).meaning("Vector of its first edge from Corner.");
  s.realArray("Edge 2").unit("m").onlyIn(3).length(3).meaning(
      "Vector of its second edge from Corner. Edge 1 x Edge 2 must point out of the body.");
  s.realArray("Stress").unit("Pa").perAxis().optional().meaning(
      "Force vector per undeformed area, in a fixed direction.");
  s.real("Pressure")
      .unit("Pa")
      .optional()
      .meaning("Pressure normal to the undeformed surface; positive values push into the body.");
  s.exactlyOneOf({"Stress", "Pressure"});
  describeHistory(s);
  return {s, checkTraction, addTraction<2>, addTraction<3>};
}

} // namespace Rhegma
