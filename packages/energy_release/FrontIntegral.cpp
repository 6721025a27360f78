#include "energy_release/FrontIntegral.hpp"

#include "energy_release/ConfigurationalForces.hpp"
#include "energy_release/FacePressureWork.hpp"
#include "energy_release/FrontCurvature.hpp"
#include "geometry/Cross.hpp"
#include "state/Subdomain.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/NearNodes.hpp"
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
  double along;  ///< its direction times its configurational force, both fields [N]
  double spring; ///< energy of the spring between its fields [J]
  Vector<D> direction;
};

/// The nodes in the tube on this rank.
struct TubeNodes
{
  std::vector<TubeNode> nodes;
  BoxNodes<D> box;
  std::vector<int> number; ///< of each node of the box, in `nodes`, or -1
};

/// What is found at a node of the box: whether it is in the tube, the part of TubeNode.
constexpr int tubeWidth = 9;

TubeNodes findNodes(const State<D>& state, const FrontSight& sight, const ContourRadii& radii,
                    const Region<D>& region, const ConfigurationalForces& force)
{
  const Nodes<D> nodes = state.mesh.nodes;
  TubeNodes found{{}, BoxNodes<D>(state, region), {}};
  const BoxNodes<D> box = found.box;
  const View<double* [tubeWidth]> values("rhegma::tubeNodes", box.count());
  const View<double*> spring = state.cracks.springEnergy;
  Kokkos::parallel_for(
      "rhegma::tubeNodes", Kokkos::RangePolicy<ExecSpace>(0, box.count()), KOKKOS_LAMBDA(const int k) {
        const Vector<D> x = box.position(k);
        if (!region.holds(x))
          return;
        const FrontFoot foot = sight.locate(x);
        if (!(foot.distance < radii.outer))
          return;
        const double ramp = (radii.outer - foot.distance) / (radii.outer - radii.inner);
        values(k, 0) = ramp > 1.0 ? 1.0 : ramp;
        values(k, 1) = foot.arc;
        for (int d = 0; d < D; ++d)
        {
          values(k, 2) += foot.direction[d] * force(box.node(k), d);
          values(k, 3 + d) = foot.direction[d];
        }
        values(k, 6) = foot.line;
        values(k, 7) = 1.0;
      });
  Kokkos::parallel_for(
      "rhegma::tubeForces", Kokkos::RangePolicy<ExecSpace>(0, nodes.numEnriched), KOKKOS_LAMBDA(const int i) {
        const int k = box.find(nodes.parent(i));
        if (k < 0 || values(k, 7) == 0.0)
          return;
        for (int d = 0; d < D; ++d)
          Kokkos::atomic_add(&values(k, 2), values(k, 3 + d) * force(nodes.numLattice + i, d));
        if (i < nodes.numOfCracks && spring.extent(0) > 0 && isOwnedByThisRank(nodes, nodes.parent(i)))
          values(k, 8) = spring(nodes.parent(i));
      });
  const auto host = onHost(values);
  found.number.assign(box.count(), -1);
  for (int k = 0; k < box.count(); ++k)
    if (host(k, 7) > 0.0)
    {
      found.number[k] = static_cast<int>(found.nodes.size());
      found.nodes.push_back({host(k, 0),
                             static_cast<int>(host(k, 6)),
                             host(k, 1),
                             host(k, 2),
                             host(k, 8),
                             {host(k, 3), host(k, 4), host(k, 5)}});
    }
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
  for (int k = 0; k < points.count; ++k)
    for (int i = 0; i < count(k); ++i)
    {
      const int at = tubeNodes.box.find(node(k, i)), own = at < 0 ? -1 : tubeNodes.number[at];
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

/// The work that front springs require where an advance makes a curved front longer: each length of front has
/// their energy, as it has that of the particles near it, which is part of the configurational forces.
/// Without it J of a disk of 6 cells is 3 % high. Added to each front node's sum, negative [N m].
void addSpringsOfLongerFront(const FrontLine& line, const FrontSight& sight, const FrontTube& tube,
                             const std::vector<TubeNode>& nodes, std::vector<double>& sums)
{
  const FrontCurvature curvature(line);
  for (const TubeNode& n : nodes)
  {
    if (!(n.spring > 0.0))
      continue;
    const double work = n.ramp * n.spring * curvature.at(n.line, n.arc);
    for (std::size_t s = 0; s < line.nodes.size(); ++s)
      sums[s] -= work * hatOf(sight, n.line, n.arc, static_cast<int>(s), tube.halfWidth);
  }
}

/// J at every front node, of the nodes' configurational forces [N].
std::vector<std::optional<double>> integrate(const State<D>& state, const FrontLine& line,
                                             const FrontTube& tube, const ConfigurationalForces& force)
{
  const std::size_t frontNodes = line.nodes.size();
  const FrontSight sight(line, reachOf(state, tube));
  const TubeNodes nodes = findNodes(state, sight, tube.radii, regionAround(line, tube.radii.outer), force);
  std::vector<double> sums(2 * frontNodes, 0.0); // of the release, then of the width
  for (std::size_t s = 0; s < frontNodes; ++s)
    for (const TubeNode& n : nodes.nodes)
      sums[s] += n.ramp * n.along * hatOf(sight, n.line, n.arc, static_cast<int>(s), tube.halfWidth);
  addSpringsOfLongerFront(line, sight, tube, nodes.nodes, sums);
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

Region<3> accelerationRange(const State<3>& state, const FrontLine& line, const FrontTube& tube)
{
  // Nodes that particles in the tube touch are touched by others.
  return regionAround(line, reachOf(state, tube) + 4.0 * state.mesh.grid.spacing);
}

std::vector<std::optional<double>> integrateWithAcceleration(const State<3>& state, const FrontLine& line,
                                                             const FrontTube& tube,
                                                             const NodalAcceleration<3>& acceleration)
{
  if (line.empty())
    return std::vector<std::optional<double>>(line.nodes.size());
  FrontRowTable<3> rows;
  BlocksInReach<3> blocks;
  return integrate(state, line, tube,
                   configurationalForces(state, {}, regionAround(line, reachOf(state, tube)), acceleration,
                                         {rows, blocks}));
}

std::vector<std::optional<double>> integrateAlongFront(const State<3>& state, int crack,
                                                       const FrontLine& line, const FrontTube& tube,
                                                       InternalAcceleration<3>& acceleration)
{
  FrontRowTable<3> rows;
  BlocksInReach<3> blocks;
  return integrateAlongFront(state, crack, line, tube, acceleration, {rows, blocks});
}

std::vector<std::optional<double>> integrateAlongFront(const State<3>& state, int crack,
                                                       const FrontLine& line, const FrontTube& tube,
                                                       InternalAcceleration<3>& acceleration,
                                                       const FrontWork<3>& kept)
{
  if (line.empty())
    return std::vector<std::optional<double>>(line.nodes.size());
  const ConfigurationalForces force =
      configurationalForces(state, particlesOfCrack(state, crack), regionAround(line, reachOf(state, tube)),
                            acceleration.around(state, accelerationRange(state, line, tube)), kept);
  addForceOfPressure(state, crack, line, tube, force);
  return integrate(state, line, tube, force);
}

} // namespace Rhegma::energy_release
