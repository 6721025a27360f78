#include "thermal/JudgeCutPieces.hpp"

#include "base/PointText.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "boundary/BodySurface.hpp"
#include "plausibility/CutBodies.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace Rhegma::thermal
{

namespace
{

/// A part of space that determines temperatures, of one body or of all.
template <int D>
struct Reach
{
  std::string body; ///< empty: of all
  Geometry::Bounds<D> bounds;
};

/// Bounds of a flat surface.
Geometry::Bounds<2> flatBounds(const Teuchos::ParameterList& list, Vector<2>)
{
  Geometry::Bounds<2> bounds = Geometry::emptyBounds<2>();
  bounds.include(readVector<2>(list, "From"));
  bounds.include(readVector<2>(list, "To"));
  return bounds;
}

Geometry::Bounds<3> flatBounds(const Teuchos::ParameterList& list, Vector<3>)
{
  Geometry::Bounds<3> bounds = Geometry::emptyBounds<3>();
  const Vector<3> corner = readVector<3>(list, "Corner"), one = readVector<3>(list, "Edge 1"),
                  two = readVector<3>(list, "Edge 2");
  for (const Vector<3>& x : {corner, corner + one, corner + two, corner + one + two})
    bounds.include(x);
  return bounds;
}

/// Where a scene determines temperatures.
template <int D>
std::vector<Reach<D>> reachesOf(const Teuchos::ParameterList& scene)
{
  std::vector<Reach<D>> all;
  if (!scene.isSublist("Boundaries"))
    return all;
  const Teuchos::ParameterList& section = scene.sublist("Boundaries");
  for (const std::string& name : sublistNames(section))
  {
    const Teuchos::ParameterList& list = section.sublist(name);
    const std::string type = list.get<std::string>("Type");
    if (type == "Temperature")
      all.push_back({"", {readVector<D>(list, "Lower Corner"), readVector<D>(list, "Upper Corner")}});
    else if (type == "Convection" && !choosesSurface(list))
      all.push_back({list.get<std::string>("Body"), flatBounds(list, Vector<D>{})});
    else if (type == "Convection")
      for (const auto& point : chosenSurface<D>(scene, list, "Boundaries > " + name))
        all.push_back({list.get<std::string>("Body"), {point.x, point.x}});
  }
  return all;
}

template <int D>
bool meet(const Geometry::Bounds<D>& one, const Geometry::Bounds<D>& other, double gap)
{
  bool meets = true;
  for (int d = 0; d < D; ++d)
    meets = meets && one.lower[d] <= other.upper[d] + gap && other.lower[d] <= one.upper[d] + gap;
  return meets;
}

} // namespace

namespace
{

/// Whether another body may conduct into a piece, as bodies within two cells share nodes.
template <int D>
bool touchesAnother(const std::vector<BodyMeasure<D>>& bodies, const BodyMeasure<D>& body,
                    const Piece<D>& piece, double cell)
{
  return std::any_of(bodies.begin(), bodies.end(),
                     [&](const BodyMeasure<D>& other)
                     {
                       return other.name != body.name &&
                              meet(Geometry::Bounds<D>{other.lower, other.upper}, piece.bounds, 2.0 * cell);
                     });
}

} // namespace

template <int D>
void judgeCutPieces(const Teuchos::ParameterList& scene, const Conduction<D>& conduction, State<D>& state)
{
  const std::vector<BodyMeasure<D>> bodies = measureBodies(state);
  const std::vector<CutBody<D>> cut = cutBodies(bodies, state);
  if (cut.empty())
    return;
  const std::vector<Reach<D>> reaches = reachesOf<D>(scene);
  const std::vector<char> insulates = conduction.faces.insulating();
  const auto conducts = [&](int crack)
  { return static_cast<std::size_t>(crack) < insulates.size() && insulates[crack] == 0; };
  for (const auto& [b, pieces, cutters] : cut)
  {
    // Other pieces may get heat through faces that conduct.
    if (std::any_of(cutters.begin(), cutters.end(), conducts))
      continue;
    const BodyMeasure<D>& body = bodies[b];
    for (const Piece<D>& piece : pieces.all())
      if (std::none_of(reaches.begin(), reaches.end(),
                       [&](const Reach<D>& reach)
                       {
                         return (reach.body.empty() || reach.body == body.name) &&
                                meet(reach.bounds, piece.bounds, state.mesh.grid.spacing);
                       }) &&
          !touchesAnother(bodies, body, piece, state.mesh.grid.spacing))
        state.warnings.push_back(
            pathsOfCracks(cutters, state) + ": its faces insulate a piece of Bodies > " + body.name + ", " +
            formatShort(piece.mass) + " kg of " + formatShort(body.mass) + " kg, such as at " +
            formatPoint(piece.at) +
            ", and no Temperature and no Convection (Boundaries) reaches it, so that its steady temperature "
            "is not determined: it keeps that of the start; prescribe a temperature of the piece, end the "
            "crack inside the body, or let its faces conduct (Thermal > Crack Faces)");
  }
}

template void judgeCutPieces(const Teuchos::ParameterList&, const Conduction<2>&, State<2>&);
template void judgeCutPieces(const Teuchos::ParameterList&, const Conduction<3>&, State<3>&);

} // namespace Rhegma::thermal
