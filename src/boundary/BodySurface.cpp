#include "boundary/BodySurface.hpp"

#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "boundary/BoundaryParts.hpp"
#include "geometry/Cross.hpp"
#include "geometry/SurfaceChoice.hpp"
#include "plan/Axis.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Rhegma
{

namespace
{

using Teuchos::ParameterList;

constexpr const char* base = "Base";

/// Names of a body's parts: the first shape, and the operations.
std::vector<std::string> partsOf(const ParameterList& body)
{
  std::vector<std::string> names{base};
  if (body.isSublist("Operations"))
    for (const std::string& name : SceneValues::sublists(body.sublist("Operations")))
      names.push_back(name);
  return names;
}

/// Parameters of a choice that a boundary has, without Largest Angle, which has a default.
std::vector<std::string> choicesOf(const ParameterList& list)
{
  std::vector<std::string> given;
  for (const char* name : {"Part", "Lower Corner", "Upper Corner", "Facing", "Around"})
    if (list.isParameter(name))
      given.emplace_back(name);
  return given;
}

void checkFlat(SectionChecks& checks, const ParameterList& list, const std::string& where)
{
  const auto needed = checks.dimension() == 2 ? std::vector<std::string>{"From", "To"}
                                              : std::vector<std::string>{"Corner", "Edge 1", "Edge 2"};
  for (const std::string& name : needed)
    if (!list.isParameter(name))
      checks.report(scenePath(where, name),
                    "is missing; write " + std::to_string(checks.dimension()) +
                        " numbers (type=\"Array(double)\") [m], or Surface = Body for "
                        "all of the body's surface or a choice of it.");
  for (const std::string& name : choicesOf(list))
    checks.report(scenePath(where, name),
                  "chooses from the body's whole surface; write Surface = Body with it.");
  checks.surface(list, where);
}

void checkChoice(SectionChecks& checks, const ParameterList& list, const std::string& where)
{
  for (const char* name : {"From", "To", "Corner", "Edge 1", "Edge 2"})
    if (list.isParameter(name))
      checks.report(scenePath(where, name),
                    "is of a flat piece of the surface, and Surface = Body takes all of it; "
                    "leave one of the two out.");
  for (const char* name : {"Facing", "Around"})
    if (const auto direction = SceneValues::reals(list, name);
        direction && std::all_of(direction->begin(), direction->end(), [](double x) { return x == 0.0; }))
      checks.report(scenePath(where, name), "is zero; write the vector of a direction, of any length.");
  if (list.isParameter("Largest Angle") && !list.getEntry("Largest Angle").isDefault() &&
      !list.isParameter("Facing") && !list.isParameter("Around"))
    checks.report(
        scenePath(where, "Largest Angle"),
        "is the largest deviation from Facing or Around, and there is neither; write one of them, or "
        "leave it out.");
  checks.corners(list, where, true);
  const ParameterList& scene = checks.scene();
  const std::string part = SceneValues::text(list, "Part"), body = SceneValues::text(list, "Body");
  if (part.empty() || !scene.isSublist("Bodies") || !scene.sublist("Bodies").isSublist(body))
    return;
  const std::vector<std::string> names = partsOf(scene.sublist("Bodies").sublist(body));
  if (std::count(names.begin(), names.end(), part) > 1)
    checks.report(scenePath(where, "Part"),
                  "\"" + part + "\" is the first shape of Bodies > " + body +
                      ", and one of its Operations has that name, too; rename the operation.");
  if (std::find(names.begin(), names.end(), part) == names.end())
  {
    std::string all;
    for (const std::string& name : names)
      all += (all.empty() ? "" : ", ") + name;
    checks.report(scenePath(where, "Part"),
                  "\"" + part + "\" is no part of Bodies > " + body + "; its parts are: " + all + ".");
  }
}

template <int D>
Geometry::SurfaceChoice<D> readChoice(const ParameterList& list, const ParameterList& body)
{
  Geometry::SurfaceChoice<D> choice;
  if (list.isParameter("Part"))
  {
    const std::vector<std::string> names = partsOf(body);
    choice.part = std::find(names.begin(), names.end(), list.get<std::string>("Part")) - names.begin();
  }
  if (list.isParameter("Lower Corner"))
    choice.box = {readVector<D>(list, "Lower Corner"), readVector<D>(list, "Upper Corner")};
  for (const char* name : {"Facing", "Around"})
    if (list.isParameter(name))
      choice.facing = {readVector<D>(list, name), std::string(name) == "Around",
                       list.get<double>("Largest Angle")};
  return choice;
}

/// Whether a point lies on a plane of symmetry, where the body goes on.
template <int D>
bool isOnSymmetry(const ParameterList& scene, const Geometry::SurfacePoint<D>& point, double rounding)
{
  const ParameterList& boundaries = scene.sublist("Boundaries");
  const std::vector<std::string> names = sublistNames(boundaries);
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name)
                     {
                       const ParameterList& list = boundaries.sublist(name);
                       if (list.get<std::string>("Type") != "Symmetry")
                         return false;
                       const int axis = list.get<std::string>("Axis")[0] - 'x';
                       constexpr double along = 0.999; // of a normal along the axis
                       return axis < D && std::abs(point.normal[axis]) > along &&
                              std::abs(point.x[axis] - list.get<double>("Position")) < rounding;
                     });
}

/// The other bodies of a scene.
template <int D>
std::vector<Shape<D>> otherBodies(const ParameterList& scene, const std::string& name)
{
  std::vector<Shape<D>> shapes;
  const ParameterList& bodies = scene.sublist("Bodies");
  for (const std::string& other : sublistNames(bodies))
    if (other != name)
      shapes.push_back(makeShape<D>(bodies.sublist(other)));
  return shapes;
}

/// Leaves out points that are no free surface: on planes of symmetry, and where another body begins.
template <int D>
void keepFree(const ParameterList& scene, const std::string& body, double cell,
              std::vector<Geometry::SurfacePoint<D>>& points)
{
  constexpr double rounding = 1e-3; // of a cell
  const std::vector<Shape<D>> others = otherBodies<D>(scene, body);
  const auto isCovered = [&](const Geometry::SurfacePoint<D>& point)
  {
    const Vector<D> beyond = point.x + rounding * cell * point.normal;
    return isOnSymmetry(scene, point, rounding * cell) ||
           std::any_of(others.begin(), others.end(),
                       [&](const Shape<D>& other) { return other.contains(beyond); });
  };
  points.erase(std::remove_if(points.begin(), points.end(), isCovered), points.end());
}

/// Outward normal of a flat piece, as long as its area [m2].
template <int D>
Vector<D> flatSurface(const ParameterList& list, const Depth& depth)
{
  if constexpr (D == 2)
  {
    const Vector<2> from = readVector<2>(list, "From"), to = readVector<2>(list, "To"), along = to - from;
    return depth.at(0.5 * (from[0] + to[0])) * Vector<2>{along[1], -along[0]};
  }
  else
    return cross(readVector<3>(list, "Edge 1"), readVector<3>(list, "Edge 2"));
}

} // namespace

void describeSurface(Section& s)
{
  describeLoadedBody(s);
  s.choice("Surface", {"Flat", "Body"})
      .byDefault("Flat")
      .meaning(
          "Flat: a line (2D: From, To) or a parallelogram (3D: Corner, Edge 1, Edge 2) of the undeformed "
          "body. Body: all of the body's free surface, less what Part, Lower Corner with Upper Corner, "
          "Facing "
          "and Around leave out; for round faces and walls of holes. Planes of Symmetry and faces that touch "
          "other bodies are not free.");
  s.realArray("From").unit("m").onlyIn(2).length(2).optional().meaning(
      "One end of a line on the surface of the undeformed body.");
  s.realArray("To").unit("m").onlyIn(2).length(2).optional().meaning("Other end of the line.");
  s.realArray("Corner").unit("m").onlyIn(3).length(3).optional().meaning(
      "One corner of a parallelogram on the surface of the undeformed body.");
  s.realArray("Edge 1").unit("m").onlyIn(3).length(3).optional().meaning(
      "Vector of its first edge from Corner.");
  s.realArray("Edge 2").unit("m").onlyIn(3).length(3).optional().meaning(
      "Vector of its second edge from Corner.");
  s.text("Part").notEmpty().optional().meaning("With Surface = Body: name of one of the body's Operations, "
                                               "such as a hole, or Base for its first shape; "
                                               "only the surface that comes from it.");
  s.realArray("Lower Corner")
      .unit("m")
      .perAxis()
      .optional()
      .meaning("With Surface = Body: corner of a box, and only the surface in it; the corner with the "
               "smallest coordinates.");
  s.realArray("Upper Corner")
      .unit("m")
      .perAxis()
      .optional()
      .meaning("Corner of the box with the largest coordinates.");
  s.realArray("Facing").perAxis().optional().meaning("With Surface = Body: a direction, of any length; only "
                                                     "the surface whose outward normal deviates from it by "
                                                     "Largest Angle at most.");
  s.realArray("Around").onlyIn(3).length(3).optional().meaning(
      "With Surface = Body: direction of an axis; only the surface whose normal is perpendicular to it, to "
      "within "
      "Largest Angle: the wall of a shaft or a hole.");
  s.real("Largest Angle")
      .unit("degrees")
      .range(0.0, 180.0)
      .byDefault(45.0)
      .meaning("Largest deviation of the normal from Facing, or from the plane perpendicular to Around.");
  s.allOrNoneOf({"Lower Corner", "Upper Corner"});
  s.atMostOneOf({"Facing", "Around"});
}

void checkSurface(SectionChecks& checks, const ParameterList& list, const std::string& where)
{
  const auto& errors = checks.errors();
  const bool isWrong =
      std::any_of(errors.begin(), errors.end(),
                  [&](const SceneError& error) { return error.where == scenePath(where, "Surface"); });
  if (choosesSurface(list))
    checkChoice(checks, list, where);
  else if (checks.dimension() != 0 && !isWrong)
    checkFlat(checks, list, where);
}

bool choosesSurface(const ParameterList& list) { return SceneValues::text(list, "Surface") == "Body"; }

template <int D>
std::vector<Geometry::SurfacePoint<D>> chosenSurface(const ParameterList& scene, const ParameterList& list,
                                                     const std::string& where)
{
  const std::string name = list.get<std::string>("Body");
  const ParameterList& body = scene.sublist("Bodies").sublist(name);
  const double cell = scene.sublist("Domain").get<double>("Cell Size");
  auto points = Geometry::chosenPoints<D>(makeShape<D>(body), readChoice<D>(list, body), 0.25 * cell);
  const bool any = !points.empty();
  keepFree(scene, name, cell, points);
  if (any && points.empty())
    throw std::invalid_argument(where + ": all of the chosen surface of Bodies > " + name +
                                " lies on planes of symmetry or on other bodies, where nothing acts on it; "
                                "choose a surface that is free");
  if (points.empty())
  {
    std::string left;
    for (const std::string& choice : choicesOf(list))
      left += (left.empty() ? "" : ", ") + choice;
    throw std::invalid_argument(where + ": nothing of the surface of Bodies > " + name +
                                (left.empty() ? " is larger than a quarter of a cell; use smaller cells"
                                              : " is left by " + left +
                                                    "; leave one of them out, or look at the "
                                                    "body with rhegma-plot --scene"));
  }
  return points;
}

template <int D>
SurfaceMeasure<D> measureSurface(const std::vector<Geometry::SurfacePoint<D>>& points, const Depth& depth)
{
  SurfaceMeasure<D> surface;
  for (const Geometry::SurfacePoint<D>& point : points)
  {
    const double area = depth.at(point.x[0]) * point.size;
    surface.area += area;
    surface.outward = surface.outward + area * point.normal;
  }
  // A closed surface has none; what is left is round-off, or small where its pieces are not mirror images.
  constexpr double closed = 1e-9;
  if (norm(surface.outward) < closed * surface.area)
    surface.outward = {};
  return surface;
}

template <int D>
SurfaceMeasure<D> measureSurface(const ParameterList& scene, const ParameterList& list,
                                 const std::string& where)
{
  const Depth depth = depthOf<D>(scene);
  if (choosesSurface(list))
    return measureSurface(chosenSurface<D>(scene, list, where), depth);
  const Vector<D> outward = flatSurface<D>(list, depth);
  return {norm(outward), outward};
}

template std::vector<Geometry::SurfacePoint<2>> chosenSurface(const ParameterList&, const ParameterList&,
                                                              const std::string&);
template std::vector<Geometry::SurfacePoint<3>> chosenSurface(const ParameterList&, const ParameterList&,
                                                              const std::string&);
template SurfaceMeasure<2> measureSurface(const std::vector<Geometry::SurfacePoint<2>>&, const Depth&);
template SurfaceMeasure<3> measureSurface(const std::vector<Geometry::SurfacePoint<3>>&, const Depth&);
template SurfaceMeasure<2> measureSurface(const ParameterList&, const ParameterList&, const std::string&);
template SurfaceMeasure<3> measureSurface(const ParameterList&, const ParameterList&, const std::string&);

} // namespace Rhegma
