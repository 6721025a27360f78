/// The points of interfaces at the start.

#include "body_contact/InterfacePoints.hpp"
#include "geometry/SurfaceChoice.hpp"

#include <algorithm>
#include <stdexcept>

namespace Rhegma::body_contact
{

namespace
{

using Teuchos::ParameterList;

/// Width of a gap below which faces count as touching, in cells: rounding of positions in the scene.
constexpr double touching = 1e-2;

/// Spacing of points, in cells: the middle of a piece at the edge of the interface decides whether all of it
/// counts.
constexpr double pointSpacing = 0.125;

/// A point, with its normal from the first group to the second.
template <int D>
struct Placed
{
  Geometry::SurfacePoint<D> point;
  const NamedPair* pair;
};

/// Shapes of the bodies of a group.
template <int D>
std::vector<Shape<D>> shapesOf(const ParameterList& bodies, const State<D>& state, const BondedGroups& groups,
                               int group)
{
  std::vector<Shape<D>> shapes;
  for (std::size_t b = 0; b < groups.of.size(); ++b)
    if (groups.of[b] == group)
      shapes.push_back(makeShape<D>(bodies.sublist(state.bodies.info[b].name)));
  return shapes;
}

/// Largest diagonal of the bodies' bounds [m].
template <int D>
double sizeOf(const std::vector<Shape<D>>& shapes)
{
  double size = 0.0;
  for (const Shape<D>& shape : shapes)
    size = std::max(size, norm(shape.bounds().upper - shape.bounds().lower));
  return size;
}

/// The surface of some bodies where others begin.
template <int D>
std::vector<Geometry::SurfacePoint<D>> commonSurface(const std::vector<Shape<D>>& bodies,
                                                     const std::vector<Shape<D>>& others, double cell)
{
  std::vector<Geometry::SurfacePoint<D>> common;
  for (const Shape<D>& body : bodies)
    for (const Geometry::SurfacePoint<D>& point : Geometry::chosenPoints<D>(body, {}, pointSpacing * cell))
    {
      const Vector<D> beyond = point.x + touching * cell * point.normal;
      if (std::any_of(others.begin(), others.end(), [&](const Shape<D>& o) { return o.contains(beyond); }))
        common.push_back(point);
    }
  return common;
}

template <int D>
void reserve(InterfacePoints<D>& points, int count)
{
  points.count = count;
  points.group = View<int* [2]>("rhegma::interfaceGroups", count);
  points.area = View<double*>("rhegma::interfaceArea", count);
  points.stiffness = View<double* [2]>("rhegma::interfaceStiffness", count);
  points.position = View<double* [D]>("rhegma::interfacePosition", count);
  points.normal = View<double* [D]>("rhegma::interfaceNormal", count);
  points.jump = View<double* [D]>("rhegma::interfaceJump", count);
  points.released = View<int*>("rhegma::interfaceReleased", count);
  points.table.reserve(count);
}

template <int D>
InterfacePoints<D> fromHost(const std::vector<Placed<D>>& placed, double thickness)
{
  InterfacePoints<D> points;
  reserve(points, static_cast<int>(placed.size()));
  const auto group = Kokkos::create_mirror_view(points.group);
  const auto area = Kokkos::create_mirror_view(points.area);
  const auto stiffness = Kokkos::create_mirror_view(points.stiffness);
  const auto position = Kokkos::create_mirror_view(points.position);
  const auto normal = Kokkos::create_mirror_view(points.normal);
  for (int k = 0; k < points.count; ++k)
  {
    const Placed<D>& one = placed[k];
    group(k, 0) = one.pair->one;
    group(k, 1) = one.pair->other;
    area(k) = one.point.size * (D == 2 ? thickness : 1.0);
    stiffness(k, 0) = one.pair->interface->normal;
    stiffness(k, 1) = one.pair->interface->along;
    for (int d = 0; d < D; ++d)
    {
      position(k, d) = one.point.x[d];
      normal(k, d) = one.point.normal[d];
    }
  }
  Kokkos::deep_copy(points.group, group);
  Kokkos::deep_copy(points.area, area);
  Kokkos::deep_copy(points.stiffness, stiffness);
  Kokkos::deep_copy(points.position, position);
  Kokkos::deep_copy(points.normal, normal);
  return points;
}

} // namespace

template <int D>
InterfacePoints<D> placeInterfaces(const ParameterList& scene, const std::vector<NamedPair>& named,
                                   const BondedGroups& groups, const State<D>& state)
{
  const ParameterList& bodies = scene.sublist("Bodies");
  const double cell = state.mesh.grid.spacing;
  std::vector<Placed<D>> placed;
  for (const NamedPair& pair : named)
  {
    if (!pair.interface)
      continue;
    const std::vector<Shape<D>> one = shapesOf(bodies, state, groups, pair.one),
                                other = shapesOf(bodies, state, groups, pair.other);
    // All of a small body's face may lie on a part of a large one's: pieces of the former end where it ends.
    const bool fromFirst = sizeOf(one) <= sizeOf(other);
    const std::vector<Geometry::SurfacePoint<D>> common =
        fromFirst ? commonSurface(one, other, cell) : commonSurface(other, one, cell);
    if (common.empty())
      throw std::invalid_argument(
          "Body Contact > " + pair.name +
          " > Bodies: the two bodies do not touch at the start, and an interface joins faces "
          "that do; move one of them, or choose another law");
    for (Geometry::SurfacePoint<D> point : common)
    {
      point.normal = fromFirst ? point.normal : -1.0 * point.normal;
      placed.push_back({point, &pair});
    }
  }
  return fromHost(placed, state.method.thickness);
}

template InterfacePoints<2> placeInterfaces(const ParameterList&, const std::vector<NamedPair>&,
                                            const BondedGroups&, const State<2>&);
template InterfacePoints<3> placeInterfaces(const ParameterList&, const std::vector<NamedPair>&,
                                            const BondedGroups&, const State<3>&);

} // namespace Rhegma::body_contact
