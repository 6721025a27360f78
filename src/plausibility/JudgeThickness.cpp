#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "boundary/DomainEdges.hpp"
#include "geometry/Shape.hpp"
#include "plausibility/JudgeWalls.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace Rhegma
{

namespace
{

using namespace Geometry;

/// Smallest width of a polygon over the directions of its edges, where that of a convex one lies.
double widthOf(const std::vector<Vector<2>>& points)
{
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const Vector<2> along = points[(k + 1) % points.size()] - points[k];
    const double length = norm(along);
    if (length == 0.0)
      continue;
    double low = 0.0, high = 0.0;
    for (const Vector<2>& x : points)
    {
      const Vector<2> from = x - points[k];
      const double across = (along[0] * from[1] - along[1] * from[0]) / length;
      low = std::min(low, across);
      high = std::max(high, across);
    }
    smallest = std::min(smallest, high - low);
  }
  return smallest;
}

/// What is thin of a primitive, in metres. \tparam Images factor on the width along an axis
template <int D, class Images>
struct Width
{
  Images images;

  double operator()(const Box<D>& box) const
  {
    const Vector<D> extents = box.corners.upper - box.corners.lower;
    double smallest = std::numeric_limits<double>::infinity();
    for (int d = 0; d < D; ++d)
      smallest = std::min(smallest, extents[d] * images(d));
    return smallest;
  }
  double operator()(const Ball<D>& ball) const { return 2.0 * ball.radius; }
  double operator()(const Cylinder<D>& cylinder) const
  {
    return std::min(2.0 * cylinder.radius, norm(cylinder.to - cylinder.from));
  }
  double operator()(const FileShape<D>& shape) const
  {
    const Frame<D> straight{spaceAxes<D>(), Vector<D>{}};
    return (*this)(Box<D>{shape.bounds(straight)});
  }
  double operator()(const VoxelShape<D>& shape) const
  {
    const Frame<D> straight{spaceAxes<D>(), Vector<D>{}};
    return (*this)(Box<D>{shape.bounds(straight)});
  }
  double operator()(const Polygon<D>& polygon) const
  {
    const double flat = widthOf(polygon.points);
    return D == 2 ? flat : std::min(flat, (polygon.top - polygon.bottom) * images(2));
  }
};

template <int D, class Images>
double widthOf(const Part<D>& part, const Images& images)
{
  return std::visit(Width<D, Images>{images}, part.primitive);
}

/// Width of a part that is thinner than `least` even with its mirror images: twice its own with one, endless
/// with two; none: it is not. \param slack of mirrors [m]
template <int D>
std::optional<double> thinWidth(const Part<D>& part, double least, const MirroredSides& mirrored,
                                double slack)
{
  if (widthOf(part, [](int) { return 1.0; }) >= least) // as most are
    return {};
  const Bounds<D> bounds = part.bounds();
  const double width =
      widthOf(part,
              [&](int d)
              {
                const bool low = mirrored.has(bounds, d, false, slack);
                const bool high = mirrored.has(bounds, d, true, slack);
                return low && high ? std::numeric_limits<double>::infinity() : low || high ? 2.0 : 1.0;
              });
  return width < least ? std::optional<double>(width) : std::nullopt;
}

/// Whether a cut removes material of what comes before it: by points in its bounds, in an order in which the
/// first ones lie all over it.
template <int D>
bool meetsMaterial(const Shape<D>& shape, std::size_t cut)
{
  constexpr int points = D == 2 ? 64 : 24, stride = D == 2 ? 2531 : 8543; // prime to the number of points
  const Shape<D> before(std::vector<Part<D>>(shape.parts().begin(), shape.parts().begin() + cut));
  const Part<D>& part = shape.parts()[cut];
  const Bounds<D> bounds = part.bounds();
  const int all = D == 2 ? points * points : points * points * points;
  for (int k = 0; k < all; ++k)
  {
    Vector<D> x;
    int rest = static_cast<int>(static_cast<long>(k) * stride % all);
    for (int d = 0; d < D; ++d)
    {
      x[d] = bounds.lower[d] + (rest % points + 0.5) / points * (bounds.upper[d] - bounds.lower[d]);
      rest /= points;
    }
    if (part.contains(x) && before.contains(x))
      return true;
  }
  return false;
}

/// Where a part of a body stands in the scene. \param number of the part; 0 is the body itself
std::string placeOf(const Teuchos::ParameterList& body, const std::string& name, std::size_t number)
{
  const std::string where = "Bodies > " + name;
  return number == 0 ? where
                     : where + " > Operations > " + sublistNames(body.sublist("Operations"))[number - 1];
}

/// Whether a boundary chooses the wall of an operation, or what operations leave to `Base`: one that removes
/// nothing may then name the wall of a hole that the body has already (docs/how-to/supports-and-loads.md).
bool namesWall(const Teuchos::ParameterList& scene, const std::string& body, const std::string& operation)
{
  if (!scene.isSublist("Boundaries"))
    return false;
  const Teuchos::ParameterList& boundaries = scene.sublist("Boundaries");
  const std::vector<std::string> names = sublistNames(boundaries);
  const auto is = [](const Teuchos::ParameterList& list, const char* parameter, const std::string& value)
  { return list.isType<std::string>(parameter) && list.get<std::string>(parameter) == value; };
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name)
                     {
                       const Teuchos::ParameterList& list = boundaries.sublist(name);
                       return is(list, "Body", body) &&
                              (is(list, "Part", operation) || is(list, "Part", "Base"));
                     });
}

/// \param named whether a part that removes nothing may be meant \return whether the part is thin
template <int D>
bool judgePart(const State<D>& state, const MirroredSides& mirrored, const Shape<D>& shape, std::size_t k,
               bool named, const std::function<std::string()>& where, Messages& messages)
{
  constexpr double fewest = 2.0; // cells: fewer do not bend, and nodes of both sides are the same
  const Part<D>& part = shape.parts()[k];
  const bool hole = k > 0 && part.operation == Operation::Cut;
  const double cell = spacingAt(state, part.bounds().centre());
  const auto width = thinWidth(part, (fewest - 1e-6) * cell, mirrored, 1e-3 * state.mesh.grid.spacing);
  const bool idle = hole && !meetsMaterial(shape, k);
  if (idle && named)
    return false;
  if (idle)
    messages.push_back(where() +
                       ": it cuts nothing, because the body has no material there; move it or leave it out");
  else if (width)
    messages.push_back(where() + ": the " +
                       (hole     ? "hole"
                        : k == 0 ? "body"
                                 : "added part") +
                       " is " + readableLength(*width) + " thin, " + formatShort(*width / cell) +
                       " cells of " + readableLength(cell) + "; the grid needs at least two cells to " +
                       (hole ? "keep it open" : "resolve bending and strain") +
                       ": use smaller cells (Domain > Cell Size), or check its size (metres)");
  return width.has_value();
}

} // namespace

template <int D>
Messages judgeThickness(const Teuchos::ParameterList& scene, const State<D>& state)
{
  Messages messages;
  const MirroredSides mirrored(scene);
  const Teuchos::ParameterList& section = scene.sublist("Bodies");
  for (const std::string& name : sublistNames(section))
  {
    const Teuchos::ParameterList& list = section.sublist(name);
    const Shape<D> shape = makeShape<D>(list);
    std::vector<char> thin(shape.parts().size());
    const std::vector<std::string> operations =
        thin.size() > 1 ? sublistNames(list.sublist("Operations")) : std::vector<std::string>();
    for (std::size_t k = 0; k < thin.size(); ++k)
      thin[k] = judgePart<D>(
          state, mirrored, shape, k, k > 0 && namesWall(scene, name, operations[k - 1]),
          [&] { return placeOf(list, name, k); }, messages);
    judgeWalls(state, mirrored, shape, thin, name, messages);
  }
  return messages;
}

template Messages judgeThickness(const Teuchos::ParameterList&, const State<2>&);
template Messages judgeThickness(const Teuchos::ParameterList&, const State<3>&);

} // namespace Rhegma
