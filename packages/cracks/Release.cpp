#include "cracks/Release.hpp"

#include "base/SmallLoops.hpp"
#include "cracks/HoldingForce.hpp"
#include "state/Subdomain.hpp"
#include "transfer/FaceRotation.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace Rhegma::cracks
{

namespace
{

/// A node that a front passes in this step.
struct PassedNode
{
  int second;         ///< index among nodes with two fields
  double force, area; ///< holding force [N]; tributary area of the node (NodeArea)
  bool counts;        ///< on this rank
  std::size_t at = 0; ///< its front node, counted through all fronts
};

/// The forces on nodes and enriched fields, before the solve sums those of shared nodes; nothing where there
/// is one rank. Collective.
template <int D>
View<double* [D]> forceSumOverRanks(const State<D>& state)
{
  if (!state.mesh.subdomain)
    return {};
  View<double* [D]> force("rhegma::cracks::forceSumOverRanks", state.mesh.nodes.sums.extent(0));
  const auto sums = state.mesh.nodes.sums;
  Kokkos::parallel_for(
      "rhegma::cracks::forceSumOverRanks", Kokkos::RangePolicy<ExecSpace>(0, force.extent(0)),
      KOKKOS_LAMBDA(const int n) {
        for (int d = 0; d < D; ++d)
          force(n, d) = sums(n, Nodes<D>::forceAt + d);
      });
  sumOverRanks(state, force.data(), D, 0, D);
  return force;
}

/// Area of new face that belongs to a node, in 2D by thickness [m2, m].
template <int D>
struct NodeArea
{
  CrackSight<D> sight;
  /// By thickness in 2D; with several materials, nodes between them seem less than full [kg/m3].
  double density;

  KOKKOS_INLINE_FUNCTION double operator()(int s, const Vector<D>& x, double mass, double cell) const
  {
    if (D == 2) // required energy is divided among nodes there, not by area
      return 0.0;
    double steepest = 0.0, full = density;
    for (int d = 0; d < D; ++d)
    {
      steepest = std::fmax(steepest, std::fabs(sight.normal(s, d)));
      full *= cell;
    }
    const double away = std::fabs(sight.locate(s, x).distance) / (cell * steepest);
    double area = std::fmin(1.0, mass / full);
    for (int d = 1; d < D; ++d)
      area *= cell;
    return away < 1.0 ? area / steepest * (1.0 - away) : 0.0;
  }
};

double smallestDensity(const std::vector<Properties>& materials)
{
  double density = 0.0;
  for (const Properties& material : materials)
    density = density > 0.0 ? std::min(density, material.density) : material.density;
  return density;
}

/// Of each node with two fields: index of the front that passes it + 1, or 0; holding force [N], area [m2]
/// and position [m].
template <int D>
View<double* [D + 3]> measurePassed(const State<D>& state, const Surroundings& surroundings,
                                    const NodalSprings<D>& springs, const HoldingForce<D>& holding)
{
  const Nodes<D> nodes = state.mesh.nodes;
  View<double * [D + 3]> rows("rhegma::cracks::passedNodes", nodes.numOfCracks);
  const NodePositions<D> positions = nodePositions(state);
  const View<std::uint64_t*> nearest = surroundings.nearest;
  const bool refined = state.mesh.tree.refined();
  const View<int*> level = state.mesh.tree.nodeLevel;
  const double spacing = state.mesh.grid.spacing;
  const NodeArea<D> areaOf{CrackSight<D>(state.cracks, spacing),
                           smallestDensity(state.materials.properties) * state.method.thickness};
  parallelForSmall(
      "rhegma::cracks::passedNodes", nodes.numOfCracks, KOKKOS_LAMBDA(const int i) {
        const int primary = nodes.parent(i);
        if (!springs.isPassed(primary))
          return;
        const Vector<D> x = positions(primary);
        rows(i, 0) = springs.front(primary) + 1.0;
        rows(i, 1) = norm(holding(i));
        const double mass =
            nodes.sums(primary, Nodes<D>::massAt) + nodes.sums(nodes.numLattice + i, Nodes<D>::massAt);
        const double cell = refined ? spacing / (1 << level(primary)) : spacing;
        rows(i, 2) = areaOf(simplexOf(nearest(primary)), x, mass, cell);
        for (int d = 0; d < D; ++d)
          rows(i, 3 + d) = x[d];
      });
  return rows;
}

/// The points of a front: its nodes, or where it is or was where it has none.
template <int D>
std::vector<Vector<D>> pointsOf(const CrackFront<D>& front)
{
  std::vector<Vector<D>> points = front.points();
  if (points.empty())
    points.push_back(front.position);
  return points;
}

/// The point that is nearest to x among those of all fronts of a crack that have grown, counted through all
/// fronts. \param first of each front
template <int D>
std::size_t nearestPoint(const CrackSet<D>& set, const std::vector<std::size_t>& first, int crack,
                         const Vector<D>& x, std::size_t otherwise)
{
  std::size_t found = otherwise;
  double shortest = 1e300;
  for (std::size_t f = 0; f < set.fronts.size(); ++f)
  {
    if (set.fronts[f].crack != crack || !set.fronts[f].grown)
      continue;
    std::size_t at = first[f];
    for (const Vector<D>& point : pointsOf(set.fronts[f]))
    {
      const double distance = norm(x - point);
      if (distance < shortest)
      {
        shortest = distance;
        found = at;
      }
      ++at;
    }
  }
  return found;
}

/// The nodes on this rank that fronts pass. \param first of each front, its first node counted through all
/// fronts
template <int D>
std::vector<PassedNode> listPassed(const State<D>& state, const View<double * [D + 3]>& rows,
                                   const std::vector<std::size_t>& first)
{
  const auto host = onHost(rows);
  const auto parent = onHost(state.mesh.nodes.parent);
  std::vector<PassedNode> passed;
  for (int i = 0; i < state.mesh.nodes.numOfCracks; ++i)
  {
    if (host(i, 0) == 0.0)
      continue;
    const int front = static_cast<int>(host(i, 0)) - 1;
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = host(i, 3 + d);
    passed.push_back({i, host(i, 1), host(i, 2), isOwnedByThisRank(state.mesh.nodes, parent(i)),
                      nearestPoint(state.cracks, first, state.cracks.fronts[front].crack, x, first[front])});
  }
  return passed;
}

/// Holding force and area of the nodes at a front node.
struct FrontSums
{
  double force = 0.0, area = 0.0;
};

/// Energies that the nodes at each front node get from the budget of the front [J].
template <int D>
std::vector<double> releaseEnergy(const State<D>& state, CrackFront<D>& front, const FrontSums* sums,
                                  const std::vector<double>& toughness)
{
  std::vector<double> energy(toughness.size(), 0.0);
  const double cell = spacingAt(state, front.position);
  if (!front.budget.byArea)
  {
    // If the front reaches a node only because material moves through the grid, its energy is that of a cell
    // of new face by the toughness of the last advance; by G, which may be far above that, it would
    // dissipate too much.
    const double ofCell = toughness[0] * state.method.depth().at(front.position[0]) * cell,
                 pending = front.budget.pending;
    // What is pending beyond a cell where no node was passed before was required while springs softened.
    const bool first = !(front.budget.released > front.budget.carriedOver);
    const double most =
        std::max(springs::carriedOverFraction, first && pending > ofCell ? 1.0 - ofCell / pending : 0.0);
    if (sums[0].force > 0.0)
      energy[0] = front.budget.releaseAll(ofCell, most, springs::deductedFraction);
    return energy;
  }
  double wanted = 0.0, row = 0.0;
  for (std::size_t k = 0; k < toughness.size(); ++k)
    wanted += toughness[k] * sums[k].area;
  if (!(wanted > 0.0))
    return energy;
  for (std::size_t k = 0; k < front.nodes.size(); ++k)
    row += toughness[k] * front.nodes[k].tributaryLength * cell;
  const double fraction =
      front.budget.fractionOfArea(wanted, row, springs::smallestByArea, springs::largestByArea);
  for (std::size_t k = 0; k < toughness.size(); ++k)
  {
    const double ofNodes = fraction * toughness[k] * sums[k].area;
    if (!(sums[k].force > 0.0) || !(ofNodes > 0.0))
      continue;
    energy[k] = ofNodes;
    front.budget.release(ofNodes);
  }
  return energy;
}

/// The range of the traction of each node with two fields that fronts pass, else 0 [m].
template <int D>
View<double*> releaseRanges(State<D>& state, const View<double * [D + 3]>& rows,
                            const ToughnessAlong<D>& toughness)
{
  std::vector<CrackFront<D>>& fronts = state.cracks.fronts;
  std::vector<std::size_t> first{0};
  for (const CrackFront<D>& front : fronts)
    first.push_back(first.back() + std::max<std::size_t>(1, front.nodes.size()));
  const std::vector<PassedNode> passed = listPassed(state, rows, first);
  std::vector<FrontSums> sums(first.back());
  for (const PassedNode& node : passed)
    if (node.counts)
    {
      sums[node.at].force += node.force;
      sums[node.at].area += node.area;
    }
  sumParts(state, &sums[0].force, static_cast<int>(2 * sums.size()));
  std::vector<double> range(sums.size(), 0.0);
  for (std::size_t f = 0; f < fronts.size(); ++f)
  {
    const std::vector<double> energy =
        releaseEnergy(state, fronts[f], &sums[first[f]], toughness(state.cracks, static_cast<int>(f)));
    for (std::size_t k = 0; k < energy.size(); ++k)
      if (energy[k] > 0.0)
        range[first[f] + k] = releaseRange(energy[k], sums[first[f] + k].force);
  }
  View<double*> rangeOf("rhegma::cracks::releaseRanges", state.mesh.nodes.numOfCracks);
  const auto host = Kokkos::create_mirror_view(rangeOf);
  for (const PassedNode& node : passed)
    host(node.second) = range[node.at];
  Kokkos::deep_copy(rangeOf, host);
  return rangeOf;
}

} // namespace

template <int D>
void releasePassedNodes(State<D>& state, const Surroundings& surroundings, const NodalSprings<D>& springs,
                        const ToughnessAlong<D>& toughness)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int*> side = state.cracks.nodeSide;
  const HoldingForce<D> holding{nodes, side, normalsInBody(state.cracks), surroundings.nearest,
                                forceSumOverRanks(state)};
  const View<double*> range =
      releaseRanges(state, measurePassed(state, surroundings, springs, holding), toughness);
  const View<double * [D + 1]> spring = state.cracks.spring;
  const StableStiffness<D> stable(state);
  parallelForSmall(
      "rhegma::cracks::releasePassedNodes", nodes.numOfCracks, KOKKOS_LAMBDA(const int i) {
        const int primary = nodes.parent(i), enriched = nodes.numLattice + i;
        if (!springs.isPassed(primary))
          return;
        const Vector<D> held = holding(i);
        const double stiffness = stable(i);
        const NodalSpring<D> node = springs(primary);
        node.setState(SpringState::Open);
        if (!(norm(held) > 0.0) || !(range(i) > 0.0))
          return;
        const double fraction = startingFraction(range(i), norm(held) / stiffness);
        const Vector<D> force = fraction * held;
        Vector<D> offset;
        for (int d = 0; d < D; ++d)
          offset[d] = force[d] / stiffness - node.jump(d);
        node.release(releaseLaw(norm(force), range(i), fraction, stiffness), offset);
        spring(primary, D) = stiffness;
        for (int d = 0; d < D; ++d)
        {
          spring(primary, d) = -signOf(side(primary)) * force[d];
          if (!isOwnedByThisRank(nodes, primary))
            continue;
          nodes.sums(primary, Nodes<D>::forceAt + d) += spring(primary, d);
          nodes.sums(enriched, Nodes<D>::forceAt + d) -= spring(primary, d);
        }
      });
}

template <int D>
void returnPendingEnergy(State<D>& state, const NodalSprings<D>& springs, const NearestFront<D>& frontOf,
                         int stamp)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const NodePositions<D> positions = nodePositions(state);
  const int before = stamp - 1;
  const auto pending = KOKKOS_LAMBDA(const int i)
  {
    const int n = nodes.active(i);
    const NodalSpring<D> node = springs(n);
    return before > 0 && static_cast<int>(node.step()) == before && isOwnedByThisRank(nodes, n)
               ? node.pendingEnergy(node.opening())
               : 0.0;
  };
  const Kokkos::RangePolicy<ExecSpace> all(0, nodes.active.extent(0));
  double any = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::cracks::pendingOfWholeNodes", all,
      KOKKOS_LAMBDA(const int i, double& sum) { sum += pending(i); }, any);
  sumParts(state, &any, 1);
  if (!(any > 0.0))
    return;
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    double energy = 0.0;
    Kokkos::parallel_reduce(
        "rhegma::cracks::pendingOfAFront", all,
        KOKKOS_LAMBDA(const int i, double& sum) {
          const double ofNode = pending(i);
          if (ofNode > 0.0 && frontOf(positions(nodes.active(i)), anyCrack) == static_cast<int>(f))
            sum += ofNode;
        },
        energy);
    sumParts(state, &energy, 1);
    state.cracks.fronts[f].budget.returnPending(energy);
  }
  // Once: the same may be found again before another node gets two fields.
  Kokkos::parallel_for(
      "rhegma::cracks::forgetWholeNodes", all, KOKKOS_LAMBDA(const int i) {
        const NodalSpring<D> node = springs(nodes.active(i));
        if (static_cast<int>(node.step()) == before)
          node.setState(SpringState::Bonded);
      });
}

template <int D>
void returnPendingOfLostNodes(State<D>& state, int stamp)
{
  const std::vector<FrontPosition<D>> fronts = frontPoints(state.cracks);
  for (const auto& lost : state.mesh.nodalFields.lost(springField<D>().field.name))
  {
    const NodalSpring<D, const double> node{lost.values.data()};
    const double energy =
        static_cast<int>(node.step()) == stamp - 1 ? node.pendingEnergy(node.opening()) : 0.0;
    const int front =
        nearestGrownFront(fronts.data(), static_cast<int>(fronts.size()), lost.position, anyCrack);
    if (energy > 0.0 && front != noFront)
      state.cracks.fronts[front].budget.returnPending(energy);
  }
}

template void releasePassedNodes(State<2>&, const Surroundings&, const NodalSprings<2>&,
                                 const ToughnessAlong<2>&);
template void releasePassedNodes(State<3>&, const Surroundings&, const NodalSprings<3>&,
                                 const ToughnessAlong<3>&);
template void returnPendingEnergy(State<2>&, const NodalSprings<2>&, const NearestFront<2>&, int);
template void returnPendingEnergy(State<3>&, const NodalSprings<3>&, const NearestFront<3>&, int);
template void returnPendingOfLostNodes(State<2>&, int);
template void returnPendingOfLostNodes(State<3>&, int);

} // namespace Rhegma::cracks
