#include "base/FacetEnds.hpp"
#include "base/PointText.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "geometry/Cross.hpp"
#include "geometry/NearBoxes.hpp"
#include "plan/BoundaryType.hpp"
#include "plausibility/Judges.hpp"
#include "plausibility/SupportReach.hpp"
#include "scene/PositionFunction.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace Rhegma
{

namespace
{

/// Component of a crack's normal along held axes from which a support restrains its opening: 45 degrees.
constexpr double opens = 0.7;

/// A point of a crack, and the length or area of crack that it represents; none of a point where it meets a
/// surface.
template <int D>
struct CrackPoint
{
  int crack;
  Vector<D> at, normal;
  double size;
};

/// Points along a crack no further apart than about a cell, and those at which it meets a surface.
template <int D>
std::vector<CrackPoint<D>> pointsOfCracks(const State<D>& state)
{
  const CrackSet<D>& set = state.cracks;
  const auto vertex = onHost(set.vertex), normals = onHost(set.normal);
  const auto simplex = onHost(set.simplex), neighbour = onHost(set.neighbour);
  const auto crackOf = onHost(set.crackOf);
  std::vector<CrackPoint<D>> points;
  for (int s = 0; s < static_cast<int>(simplex.extent(0)); ++s)
  {
    Vector<D> x[D], normal;
    for (int i = 0; i < D; ++i)
      for (int d = 0; d < D; ++d)
        x[i][d] = vertex(simplex(s, i), d);
    for (int d = 0; d < D; ++d)
      normal[d] = normals(s, d);
    const int crack = crackOf(s);
    if constexpr (D == 2)
    {
      const double length = norm(x[1] - x[0]);
      const int pieces = std::max(1, static_cast<int>(std::ceil(length / spacingAt(state, x[0]))));
      for (int k = 0; k < pieces; ++k)
        points.push_back({crack, x[0] + ((k + 0.5) / pieces) * (x[1] - x[0]), normal, length / pieces});
    }
    else // triangles have about the size of a cell
      points.push_back(
          {crack, (1.0 / 3.0) * (x[0] + x[1] + x[2]), normal, 0.5 * norm(cross(x[1] - x[0], x[2] - x[0]))});
    for (int i = 0; i < D; ++i)
      if (neighbour(s, i) == facet::surfaceBreaking)
        points.push_back({crack, 0.5 * (x[(i + 1) % D] + x[(i + D - 1) % D]), normal, 0.0});
  }
  return points;
}

/// "x, y" of "xy".
std::string listed(const std::string& axes)
{
  std::string text;
  for (const char axis : axes)
    text += (text.empty() ? "" : ", ") + std::string(1, axis);
  return text;
}

/// A support, and where it holds both faces of a crack.
template <int D>
struct Shut
{
  double size = 0.0;                       ///< of the crack that is held [m, m2]
  std::optional<Vector<D>> atSurface, any; ///< points where it is
};

/// The supports that hold both faces of cracks.
template <int D>
class ShutCracks
{
public:
  explicit ShutCracks(const JudgedScene<D>& judged)
      : state_(judged.state), supports_(boundaryRegions(judged.scene)), boxes_(boxesOfSupports<D>(supports_))
  {
    for (const BoundaryRegion& support : supports_)
      fields_.push_back(fieldOf(judged.scene, support));
    for (std::size_t k = 0; k < supports_.size(); ++k)
      if (supports_[k].kind == BoundaryRegion::Kind::HeldOutside)
        outside_.push_back(static_cast<int>(k));
    sizes_.resize(state_.cracks.cracks.size());
    for (const CrackPoint<D>& point : pointsOfCracks(state_))
      add(point);
  }

  Messages messages() const
  {
    Messages messages;
    for (const auto& [pair, shut] : found_)
    {
      const auto& [support, crack] = pair;
      const std::string part = formatShort(100.0 * shut.size / sizes_[crack]) + " %";
      messages.push_back(
          "Boundaries > " + supports_[support].name + ": it prescribes the same motion along " +
          listed(supports_[support].axes) + " for both faces of Cracks > " +
          state_.cracks.cracks[crack].name + ", over " +
          (shut.size > 0.0 ? part + " of the crack" : std::string("a node")) +
          (shut.atSurface ? " where it meets the surface, " : ", such as ") +
          formatPoint(shut.atSurface ? *shut.atSurface : *shut.any) +
          ", so that the crack can't open there; end the region before the crack (Lower Corner, Upper "
          "Corner), or write one support for each side of it");
    }
    return messages;
  }

private:
  /// The velocity of a support as a function of position; none where it is the same everywhere.
  static std::optional<PositionFunction> fieldOf(const Teuchos::ParameterList& scene,
                                                 const BoundaryRegion& support)
  {
    const Teuchos::ParameterList& list = scene.sublist("Boundaries").sublist(support.name);
    if (!list.isType<std::string>("Field"))
      return {};
    return PositionFunction::parse(list.get<std::string>("Field"), D);
  }

  void add(const CrackPoint<D>& point)
  {
    sizes_[point.crack] += point.size;
    const double cell = spacingAt(state_, point.at);
    std::vector<int> near = boxes_.near({point.at, point.at}, cell);
    near.insert(near.end(), outside_.begin(), outside_.end());
    for (const int k : near)
      if (restrains(k, point.normal) && holdsBoth(supports_[k], point, cell) && !parts(k, point, cell))
      {
        Shut<D>& shut = found_[{k, point.crack}];
        shut.size += point.size;
        (point.size > 0.0 ? shut.any : shut.atSurface) = point.at;
      }
  }

  bool restrains(int support, const Vector<D>& normal) const
  {
    double square = 0.0;
    for (const char axis : supports_[support].axes)
      square += normal[axis - 'x'] * normal[axis - 'x'];
    return square > opens * opens;
  }

  /// Whether it holds nodes on both sides of a crack, of those less than a cell away along each axis. A node
  /// on the crack has a field for each face, and both are held.
  bool holdsBoth(const BoundaryRegion& support, const CrackPoint<D>& point, double cell) const
  {
    const double slack = 1e-6 * cell;
    bool below = false, above = false;
    for (int k = 0; k < 1 << D; ++k)
    {
      Vector<D> node;
      bool touched = true, inside = true, strictly = true;
      for (int d = 0; d < D; ++d)
      {
        const double at = (point.at[d] - state_.mesh.grid.origin[d]) / cell;
        const double line = std::floor(at + 1e-6) + (k >> d & 1);
        node[d] = state_.mesh.grid.origin[d] + line * cell;
        touched = touched && std::fabs(node[d] - point.at[d]) < cell - slack;
        inside = inside && node[d] >= support.from[d] - slack && node[d] <= support.to[d] + slack;
        strictly = strictly && node[d] > support.from[d] + slack && node[d] < support.to[d] - slack;
      }
      const bool held = support.kind == BoundaryRegion::Kind::HeldOutside ? !strictly : inside;
      if (!touched || !held)
        continue;
      const double side = dot(node - point.at, point.normal);
      below = below || side <= slack;
      above = above || side >= -slack;
    }
    return below && above;
  }

  /// Whether its velocity jumps across the crack, as that of a field with a crack in it does.
  bool parts(int support, const CrackPoint<D>& point, double cell) const
  {
    constexpr double close = 1e-6, jump = 1e-3; // of a cell, and of the velocity
    if (!fields_[support])
      return false;
    const Vector<D> across = (close * cell) * point.normal;
    const Vector<D> above = (*fields_[support])(point.at + across),
                    below = (*fields_[support])(point.at - across);
    return norm(above - below) > jump * (norm(above) + norm(below));
  }

  const State<D>& state_;
  std::vector<BoundaryRegion> supports_;
  Geometry::NearBoxes<D> boxes_;
  std::vector<std::optional<PositionFunction>> fields_;
  std::vector<int> outside_;  ///< supports that hold the outside of a box
  std::vector<double> sizes_; ///< of the cracks [m, m2]
  std::map<std::pair<int, int>, Shut<D>> found_;
};

} // namespace

template <int D>
Messages judgeShutCracks(const JudgedScene<D>& judged)
{
  if (!judged.state.method.mechanics || judged.state.cracks.empty() ||
      judged.state.cracks.simplex.extent(0) == 0)
    return {};
  const std::vector<BoundaryRegion> regions = boundaryRegions(judged.scene);
  const bool held = std::any_of(regions.begin(), regions.end(),
                                [](const BoundaryRegion& region) {
                                  return region.kind == BoundaryRegion::Kind::Held ||
                                         region.kind == BoundaryRegion::Kind::HeldOutside;
                                });
  return held ? ShutCracks<D>(judged).messages() : Messages{};
}

template Messages judgeShutCracks(const JudgedScene<2>&);
template Messages judgeShutCracks(const JudgedScene<3>&);

} // namespace Rhegma
