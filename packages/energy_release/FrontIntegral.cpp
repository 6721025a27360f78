#include "energy_release/FrontIntegral.hpp"

#include "energy_release/ConfigurationalForces.hpp"
#include "energy_release/FacePressureWork.hpp"
#include "geometry/Cross.hpp"
#include "state/Subdomain.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/Stencils.hpp"

#include <algorithm>

namespace Rhegma::energy_release
{

namespace
{

constexpr int D = 3;

/// A node in the tube.
struct TubeNode
{
  double ramp;
  int line;
  double arc;
  double along; ///< its direction times its configurational force, both fields [N]
  Vector<D> direction;
};

/// The nodes in the tube on this rank.
struct TubeNodes
{
  std::vector<TubeNode> nodes;
  View<int*> number; ///< of each row of the lattice and of refined cells, in `nodes`, or -1
};

TubeNodes findNodes(const State<D>& state, const FrontSight& sight, const ContourRadii& radii,
                    const Region<D>& box, const View<double* [D]>& force)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const NodePositions<D> positions = nodePositions(state);
  const int candidates = static_cast<int>(nodes.active.extent(0));
  TubeNodes found;
  found.number = View<int*>("rhegma::tubeNode", nodes.numLattice);
  Kokkos::deep_copy(found.number, -1);
  const View<int*> number = found.number;
  const auto isNear = KOKKOS_LAMBDA(const int n, FrontFoot& foot)
  {
    const Vector<D> x = positions(n);
    if (!box.holds(x))
      return false;
    foot = sight.locate(x);
    return foot.distance < radii.outer;
  };
  int count = 0;
  Kokkos::parallel_scan(
      "rhegma::tubeNodes", Kokkos::RangePolicy<ExecSpace>(0, candidates),
      KOKKOS_LAMBDA(const int i, int& at, const bool final) {
        FrontFoot foot;
        if (!isNear(nodes.active(i), foot))
          return;
        if (final)
          number(nodes.active(i)) = at;
        ++at;
      },
      count);
  const View<double* [7]> values("rhegma::tubeNodes", count);
  const int rows = candidates + nodes.numEnriched;
  // Both fields of a node, one after the other.
  for (const bool second : {false, true})
    Kokkos::parallel_for(
        "rhegma::tubeForces",
        Kokkos::RangePolicy<ExecSpace>(second ? candidates : 0, second ? rows : candidates),
        KOKKOS_LAMBDA(const int i) {
          const int row = activeNode(nodes, i), k = number(latticeNode(nodes, row));
          if (k < 0)
            return;
          const FrontFoot foot = sight.locate(positions(latticeNode(nodes, row)));
          const double ramp = (radii.outer - foot.distance) / (radii.outer - radii.inner);
          values(k, 0) = ramp > 1.0 ? 1.0 : ramp;
          values(k, 1) = foot.arc;
          for (int d = 0; d < D; ++d)
          {
            values(k, 2) += foot.direction[d] * force(row, d);
            values(k, 3 + d) = foot.direction[d];
          }
          values(k, 6) = foot.line;
        });
  const auto host = onHost(values);
  for (int k = 0; k < count; ++k)
    found.nodes.push_back({host(k, 0),
                           static_cast<int>(host(k, 6)),
                           host(k, 1),
                           host(k, 2),
                           {host(k, 3), host(k, 4), host(k, 5)}});
  return found;
}

/// Parts into which a cell's length of front is cut to integrate along it.
constexpr int partsOfCell = 8;

/// Adds to each front node's sum the integral along the front of its weight as the cells interpolate it [m].
void addWidths(const State<D>& state, const FrontLine& line, const FrontSight& sight, const FrontTube& tube,
               const TubeNodes& tubeNodes, std::vector<double>& width)
{
  struct Part
  {
    Vector<D> position, across;
    double length;
  };
  std::vector<Part> parts;
  for (const FrontPiece& piece : line.pieces)
  {
    const FrontNode<D>&a = line.nodes[piece.from], &b = line.nodes[piece.to];
    const Vector<D> along = b.position - a.position;
    // Only the advance across the piece sweeps an area; the piece may be inclined to the directions of its
    // front nodes.
    const Vector<D> swept = cross(along, a.normal + b.normal);
    if (!(norm(swept) > 0.0)) // a piece without length has no area
      continue;
    const Vector<D> across = (dot(swept, a.direction + b.direction) < 0.0 ? -1.0 : 1.0) / norm(swept) * swept;
    const int count =
        std::max(1, static_cast<int>(std::ceil(partsOfCell * piece.length / spacingAt(state, a.position))));
    for (int i = 0; i < count; ++i)
    {
      const double at = (i + 0.5) / count;
      parts.push_back({a.position + at * along, across, piece.length / count});
    }
  }
  ObservedPoints<D> points;
  points.onAllRanks = true;
  points.count = static_cast<int>(parts.size());
  points.position = View<double* [D]>("rhegma::frontPartPosition", points.count);
  points.half = View<double* [D]>("rhegma::frontPartHalf", points.count);
  points.side = View<int*>("rhegma::frontPartSide", points.count); // away from cracks: unbroken
  const auto position = Kokkos::create_mirror_view(points.position);
  for (int k = 0; k < points.count; ++k)
    for (int d = 0; d < D; ++d)
      position(k, d) = parts[k].position[d];
  Kokkos::deep_copy(points.position, position);
  StencilTable<D> table;
  pointStencils(state, points, table, false);
  const auto count = onHost(table.count);
  const auto node = onHost(table.node);
  const auto weight = onHost(table.weight);
  const auto number = onHost(tubeNodes.number);
  for (int k = 0; k < points.count; ++k)
    for (int i = 0; i < count(k); ++i)
    {
      const int own = number(node(k, i));
      if (own < 0)
        continue;
      const TubeNode& n = tubeNodes.nodes[own];
      const double fraction = parts[k].length * weight(k, i) * n.ramp * dot(n.direction, parts[k].across);
      for (std::size_t s = 0; s < width.size(); ++s)
        width[s] += fraction * hatOf(sight, n.line, n.arc, static_cast<int>(s), tube.halfWidth);
    }
}

/// Particles whose functions reach a node are at most 2.5 cells from it along each axis.
double reachOf(const State<D>& state, const FrontTube& tube)
{
  return tube.radii.outer + 4.0 * state.mesh.grid.spacing;
}

/// The weight of a front node has at least this fraction of the length of the pieces at it: of a straight
/// front in material it has all of it, and more.
constexpr double leastWidth = 0.01;

/// J at every front node, of the nodes' configurational forces [N].
std::vector<std::optional<double>> integrate(const State<D>& state, const FrontLine& line,
                                             const FrontTube& tube, const View<double* [D]>& force)
{
  const std::size_t frontNodes = line.nodes.size();
  const FrontSight sight(line, reachOf(state, tube));
  const TubeNodes nodes = findNodes(state, sight, tube.radii, regionAround(line, tube.radii.outer), force);
  std::vector<double> sums(2 * frontNodes, 0.0); // of the release, then of the width
  for (std::size_t s = 0; s < frontNodes; ++s)
    for (const TubeNode& n : nodes.nodes)
      sums[s] += n.ramp * n.along * hatOf(sight, n.line, n.arc, static_cast<int>(s), tube.halfWidth);
  std::vector<double> width(frontNodes, 0.0);
  addWidths(state, line, sight, tube, nodes, width);
  std::copy(width.begin(), width.end(), sums.begin() + static_cast<long>(frontNodes));
  sumParts(state, sums.data(), static_cast<int>(sums.size()));
  std::vector<std::optional<double>> J(frontNodes);
  for (std::size_t s = 0; s < frontNodes; ++s)
    if (sums[frontNodes + s] > leastWidth * line.nodes[s].tributaryLength)
      J[s] = sums[s] / sums[frontNodes + s];
  return J;
}

} // namespace

std::vector<std::optional<double>> integrateWithAcceleration(const State<3>& state, const FrontLine& line,
                                                             const FrontTube& tube,
                                                             const NodalAcceleration<3>& acceleration)
{
  if (line.empty())
    return std::vector<std::optional<double>>(line.nodes.size());
  return integrate(state, line, tube,
                   configurationalForces(state, regionAround(line, reachOf(state, tube)), acceleration));
}

std::vector<std::optional<double>> integrateAlongFront(const State<3>& state, int crack,
                                                       const FrontLine& line, const FrontTube& tube,
                                                       InternalAcceleration<3>& acceleration)
{
  if (line.empty())
    return std::vector<std::optional<double>>(line.nodes.size());
  // Nodes that particles in the tube touch are touched by others.
  const double reach = reachOf(state, tube);
  const View<double* [D]> force = configurationalForces(
      state, regionAround(line, reach),
      acceleration.around(state, regionAround(line, reach + 4.0 * state.mesh.grid.spacing)));
  addForceOfPressure(state, crack, line, tube, force);
  return integrate(state, line, tube, force);
}

} // namespace Rhegma::energy_release
