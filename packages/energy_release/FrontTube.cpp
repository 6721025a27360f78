#include "energy_release/FrontTube.hpp"

#include "archive/Archive.hpp"
#include "energy_release/ClearOfCracks.hpp"
#include "state/Subdomain.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace Rhegma::energy_release
{

namespace
{

constexpr double halfWidthCells = 2.0, wantedInnerCells = 2.0;

/// Largest inclination towards the front of a surface at which it ends: nodes of that surface have their feet
/// on the front within this fraction of their distance, and a cell, from the end.
constexpr double leans = 0.6;

/// Largest fraction of an open front that is left out at each end.
constexpr double atAnEnd = 0.4;

/// Length that is left out at an end of an open front, at most. A row of nodes lies within half a cell of its
/// middle: where the front is long enough, this row counts.
double leftOutAtEnds(double length, double cell)
{
  constexpr double motion = 0.1; // of the ends, with the body [cells]
  return length > 2.0 * cell ? std::min(atAnEnd * length, 0.5 * (length - cell) - motion * cell)
                             : std::max(atAnEnd * length, cell);
}

/// Distance from a front within which all nodes are surrounded by material; the ends of an open one, where
/// the surface is, are left out.
double clearOfSurfaces(const State<3>& state, int crack, const FrontLine& line, double radius)
{
  Vector<3> middle{{0.0, 0.0, 0.0}};
  for (const FrontNode<3>& s : line.nodes)
    middle = middle + (1.0 / static_cast<double>(line.nodes.size())) * s.position;
  double extent = 0.0;
  for (const FrontNode<3>& s : line.nodes)
    extent = std::max(extent, norm(s.position - middle));
  const NodeCover<3> cover = coverOfNodes(state, middle, extent + radius, crack);
  const FrontSight sight(line, radius);
  const double cell = state.mesh.grid.spacing;
  double most = 1e300;
  for (const double length : line.open)
    if (length > 0.0)
      most = std::min(most, leftOutAtEnds(length, cell));
  double nearest = radius;
  Kokkos::parallel_reduce(
      "rhegma::clearOfSurfaces", Kokkos::RangePolicy<ExecSpace>(0, cover.box.count()),
      KOKKOS_LAMBDA(const int k, double& smallest) {
        const Vector<3> x = cover.box.position(k);
        if (!cover.isOpen(k) || norm(x - middle) > extent + radius)
          return;
        const FrontFoot foot = sight.locate(x);
        const double end = std::fmin(cell + leans * foot.distance, most);
        if (foot.inside >= end && foot.distance < smallest)
          smallest = foot.distance;
      },
      Kokkos::Min<double>(nearest));
  double closeness = -nearest;
  maxParts(state, &closeness, 1);
  return std::min(-closeness, radius);
}

/// Distance to the other fronts of its crack.
double clearOfOwnFronts(const CrackSet<3>& cracks, const CrackFront<3>& front, const FrontLine& line,
                        double radius)
{
  double nearest = radius;
  for (const CrackFront<3>& other : cracks.fronts)
    if (other.crack == front.crack && other.number != front.number)
      for (const FrontNode<3>& s : line.nodes)
        for (const FrontNode<3>& t : other.nodes)
          nearest = std::min(nearest, norm(t.position - s.position));
  return nearest;
}

/// Distances of two positions on a front from which their curvature counts, and from which it counts fully
/// [cells]; closer pairs measure the corners between pieces. The weight increases in between, so that
/// round-off does not change a tube.
constexpr double curvatureFrom = 1.5, curvatureFully = 3.0;

/// Directions of the front nodes, each the mean over two front nodes on both sides by weights that fall
/// linearly: the offset of a single front node turns its neighbours and is no curvature. Directions on a
/// circle do not change.
std::vector<Vector<3>> meanDirections(const FrontLine& line)
{
  constexpr int reach = 2;
  const int count = static_cast<int>(line.nodes.size());
  std::vector<Vector<3>> mean(count);
  for (int k = 0; k < count; ++k)
  {
    const bool closed = line.loop[line.line[k]] > 0.0;
    int first = k, last = k; // of its line
    while (first > 0 && line.line[first - 1] == line.line[k])
      --first;
    while (last + 1 < count && line.line[last + 1] == line.line[k])
      ++last;
    const int size = last - first + 1;
    // The ends of an open line point along the surface.
    const int most = closed ? reach : std::clamp(std::min(k - first, last - k) - 1, 0, reach);
    Vector<3> sides[2] = {{{0.0, 0.0, 0.0}}, {{0.0, 0.0, 0.0}}};
    double sideLength[2] = {0.0, 0.0}; // weighted length of front to the front nodes of each side
    for (int side = 0; side < 2; ++side)
    {
      double along = 0.0;
      for (int j = 1, from = k; j <= most; ++j)
      {
        const int to = first + ((k - first + (side == 0 ? -j : j)) % size + size) % size;
        along += norm(line.nodes[to].position - line.nodes[from].position);
        sideLength[side] += double(reach + 1 - j) * along;
        sides[side] = sides[side] + double(reach + 1 - j) * line.nodes[to].direction;
        from = to;
      }
    }
    // Equal lengths on both sides, so that unequal pieces do not turn an arc.
    Vector<3> sum = double(reach + 1) * line.nodes[k].direction;
    if (most > 0)
      sum = sum +
            (2.0 / (sideLength[0] + sideLength[1])) * (sideLength[1] * sides[0] + sideLength[0] * sides[1]);
    const double length = norm(sum);
    mean[k] = length > 0.0 ? (1.0 / length) * sum : line.nodes[k].direction;
  }
  return mean;
}

} // namespace

double radiusOfCurvature(const FrontLine& line, double cell)
{
  const std::vector<Vector<3>> direction = meanDirections(line);
  std::vector<char> atSurface(line.nodes.size(), 0);
  for (const FrontPiece& piece : line.pieces)
  {
    atSurface[piece.from] |= piece.begins;
    atSurface[piece.to] |= piece.ends;
  }
  double largest = 0.0;
  for (std::size_t s = 0; s < line.nodes.size(); ++s)
    for (std::size_t t = 0; t < line.nodes.size(); ++t)
    {
      if (atSurface[s] || atSurface[t])
        continue;
      const Vector<3> chord = line.nodes[t].position - line.nodes[s].position;
      const double length = norm(chord), sagitta = std::fabs(dot(chord, direction[s]));
      const double says = (length / cell - curvatureFrom) / (curvatureFully - curvatureFrom);
      if (says > 0.0)
        largest = std::max(largest, std::min(says, 1.0) * 2.0 * sagitta / (length * length));
    }
  return largest > 0.0 ? 1.0 / largest : std::numeric_limits<double>::infinity();
}

void FrontTube::store(const std::string& name, Archive& archive)
{
  const Archive::Group group(archive, name);
  archive("inner", radii.inner);
  archive("outer", radii.outer);
  archive("half_width", halfWidth);
}

template <>
GivenRadii usualCells<2>()
{
  return {};
}

template <>
GivenRadii usualCells<3>()
{
  GivenRadii radii;
  radii.innerCells = 2.5;
  radii.outerCells = 5.0;
  return radii;
}

double clearAround(const State<2>& state, const CrackFront<2>& front, double radius)
{
  return std::min(largestContour(state, front, radius),
                  clearOfCracks(state.cracks, front, radius, spacingAt(state, front.position)));
}

double clearAround(const State<3>& state, const CrackFront<3>& front, double radius)
{
  const FrontLine line = lineOf(front);
  const double cell = spacingAt(state, front.position);
  radius = std::min(radius, radiusOfCurvature(line, cell));
  radius = clearOfOwnFronts(state.cracks, front, line, radius);
  radius = clearOfCracks(state.cracks, front, radius, cell);
  return clearOfSurfaces(state, front.crack, line, radius);
}

template <int D>
FrontTube fittingTube(const State<D>& state, const CrackFront<D>& front, const GivenRadii& given)
{
  const double cell = spacingAt(state, front.position);
  FrontTube tube{usualRadii(given, cell), 0.0};
  if constexpr (D == 3)
    tube.halfWidth =
        std::min(halfWidthCells * cell, std::max(0.5 * radiusOfCurvature(lineOf(front), cell), cell));
  if (given.outer > 0.0)
    return tube;
  const double usual = tube.radii.outer;
  double &inner = tube.radii.inner, &outer = tube.radii.outer;
  outer = std::max(clearAround(state, front, usual), smallestOuter(given, cell));
  if (given.inner == 0.0 && outer < usual)
    inner = D == 2 ? std::max(0.5 * outer, std::min(wantedInnerCells * cell, outer - cell))
                   : std::min(inner, 0.5 * outer);
  return tube;
}

template FrontTube fittingTube(const State<2>&, const CrackFront<2>&, const GivenRadii&);
template FrontTube fittingTube(const State<3>&, const CrackFront<3>&, const GivenRadii&);

} // namespace Rhegma::energy_release
