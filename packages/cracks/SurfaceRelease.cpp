#include "cracks/SurfaceRelease.hpp"

#include "base/FewItems.hpp"
#include "cracks/Cohesion.hpp"
#include "cracks/CrackGrowth.hpp"
#include "cracks/HoldingForce.hpp"
#include "state/Subdomain.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace Rhegma::cracks
{

namespace
{

/// Most by which nodes take more, and least to which they take less, than their area says.
constexpr double most = 1.5, least = 0.5;

/// A node that waits: what would hold it, its area, and the front that passed it.
struct Waiting
{
  int second; ///< counts nodes with two fields
  int front, frontNode;
  double force, area;
  bool counts; ///< on this rank
};

/// Of each node with two fields: whether it waits (its front + 1, or 0), holding force [N], area [m2], place
/// [m].
using Rows = View<double* [6]>;

Rows look(const State<3>& state, const Surroundings& surroundings, const View<double* [3]>& whole,
          const View<double* [7]>& cohesive, double density)
{
  const Nodes<3> nodes = state.mesh.nodes;
  Rows rows("rhegma::cracks::waitingNodes", nodes.numSecond);
  const NodePlaces<3> places = nodePlaces(state);
  const CrackSight<3> sight(state.cracks, state.mesh.grid.spacing);
  const View<std::uint64_t*> nearest = surroundings.nearest;
  const HoldingForce<3> holding{nodes, state.cracks.nodeSide, state.cracks.normal, nearest, whole};
  const bool refined = state.mesh.tree.refined();
  const View<int*> level = state.mesh.tree.nodeLevel;
  const double spacing = state.mesh.grid.spacing;
  forFew(
      "rhegma::cracks::waitingNodes", nodes.numSecond, KOKKOS_LAMBDA(const int i) {
        const int own = nodes.parent(i);
        if (!(cohesive(own, cohesion::peak) < 0.0))
          return;
        const int s = simplexOf(nearest(own));
        const Vector<3> x = places(own);
        const double cell = refined ? spacing / (1 << level(own)) : spacing;
        double steepest = 0.0;
        for (int d = 0; d < 3; ++d)
        {
          steepest = std::fmax(steepest, std::fabs(sight.normal(s, d)));
          rows(i, 3 + d) = x[d];
        }
        const double away = std::fabs(sight.look(s, x).distance) / (cell * steepest);
        rows(i, 0) = -cohesive(own, cohesion::peak);
        rows(i, 1) = norm(holding(i));
        const double mass =
            nodes.sums(own, Nodes<3>::massAt) + nodes.sums(nodes.numLattice + i, Nodes<3>::massAt);
        const double filled = std::fmin(1.0, mass / (density * cell * cell * cell));
        rows(i, 2) = away < 1.0 ? filled * cell * cell / steepest * (1.0 - away) : 0.0;
      });
  return rows;
}

int nearestFrontNode(const CrackFront<3>& front, const Vector<3>& x)
{
  int found = 0;
  double shortest = 1e300;
  for (std::size_t k = 0; k < front.nodes.size(); ++k)
  {
    const double distance = norm(x - front.nodes[k].position);
    if (distance < shortest)
    {
      shortest = distance;
      found = static_cast<int>(k);
    }
  }
  return found;
}

/// The fronts and front nodes of the nodes that wait on this rank.
std::vector<Waiting> list(const State<3>& state, const Rows& rows)
{
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, rows);
  const auto parent = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.mesh.nodes.parent);
  std::vector<Waiting> waiting;
  for (int i = 0; i < state.mesh.nodes.numSecond; ++i)
  {
    if (!(host(i, 0) > 0.0))
      continue;
    // The nearest front node of any front of its crack: FrontTies knows fronts by one place only.
    const int crack = state.cracks.fronts[static_cast<int>(host(i, 0)) - 1].crack;
    const Vector<3> x{host(i, 3), host(i, 4), host(i, 5)};
    Waiting node{i,          static_cast<int>(host(i, 0)) - 1,       0, host(i, 1),
                 host(i, 2), countsHere(state.mesh.nodes, parent(i))};
    double shortest = 1e300;
    for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
    {
      const CrackFront<3>& front = state.cracks.fronts[f];
      if (front.crack != crack || !front.grown)
        continue;
      // One that has ended is known by where it did.
      const int k = nearestFrontNode(front, x);
      const double distance = norm(x - (front.nodes.empty() ? front.position : front.nodes[k].position));
      if (distance < shortest)
      {
        shortest = distance;
        node.front = static_cast<int>(f);
        node.frontNode = k;
      }
    }
    waiting.push_back(node);
  }
  return waiting;
}

} // namespace

void releaseBehind(const CrackGrowth<3>& growth, State<3>& state, const Surroundings& surroundings,
                   const View<double* [3]>& whole, const View<double* [3]>& jump,
                   const View<double* [7]>& cohesive)
{
  std::vector<CrackFront<3>>& fronts = state.cracks.fronts;
  double density = 0.0; // bodies of several materials have nodes between them that look less than full
  for (const Properties& material : state.materials.list)
    density = density > 0.0 ? std::min(density, material.density) : material.density;
  const std::vector<Waiting> waiting = list(state, look(state, surroundings, whole, cohesive, density));
  // Force and area of the nodes at each front node, of all fronts one after another.
  std::vector<std::size_t> first{0};
  for (const CrackFront<3>& front : fronts)
    first.push_back(first.back() + std::max<std::size_t>(1, front.nodes.size()));
  std::vector<double> sums(2 * first.back(), 0.0);
  for (const Waiting& node : waiting)
    if (node.counts)
    {
      const std::size_t at = 2 * (first[node.front] + node.frontNode);
      sums[at] += node.force;
      sums[at + 1] += node.area;
    }
  sumParts(state, sums.data(), static_cast<int>(sums.size()));
  std::vector<double> range(first.back(), 0.0);
  for (std::size_t f = 0; f < fronts.size(); ++f)
  {
    CrackFront<3>& front = fronts[f];
    const std::vector<double> toughness = growth.toughnessAlong(state.cracks, static_cast<int>(f));
    double wanted = 0.0;
    for (std::size_t at = first[f]; at < first[f + 1]; ++at)
      wanted += toughness[at - first[f]] * sums[2 * at + 1];
    if (!(wanted > 0.0))
      continue;
    // A row of cells along the front is what it may be ahead or behind.
    double row = 0.0;
    const double cell = spacingAt(state, front.position);
    for (std::size_t k = 0; k < front.nodes.size(); ++k)
      row += toughness[k] * front.nodes[k].tributaryLength * cell;
    // After a front has ended there is no row to come, and these nodes are the last to take what is left.
    const double ahead = front.unspent - wanted;
    const double share = std::clamp(1.0 + ahead / (row > 0.0 ? row : wanted), least, most);
    for (std::size_t at = first[f]; at < first[f + 1]; ++at)
    {
      const double energy = share * toughness[at - first[f]] * sums[2 * at + 1];
      if (!(sums[2 * at] > 0.0) || !(energy > 0.0))
        continue;
      range[at] = 2.0 * energy / (cohesion::strengthAtFirst * sums[2 * at]);
      front.unspent -= energy;
    }
  }
  const Nodes<3> nodes = state.mesh.nodes;
  const View<double*> rangeOf("rhegma::cracks::rangeOfNodes", nodes.numSecond);
  const auto host = Kokkos::create_mirror_view(rangeOf);
  for (const Waiting& node : waiting)
    host(node.second) = range[first[node.front] + node.frontNode];
  Kokkos::deep_copy(rangeOf, host);

  const View<int*> side = state.cracks.nodeSide;
  const View<double* [4]> tie = state.cracks.tie;
  const HoldingForce<3> holding{nodes, side, state.cracks.normal, surroundings.nearest, whole};
  const bool refined = state.mesh.tree.refined();
  const View<int*> level = state.mesh.tree.nodeLevel;
  const int firstShort = firstOfShortSteps(state);
  const double limit = stable / (state.clock.dt * state.clock.dt);
  forFew(
      "rhegma::cracks::releaseBehind", nodes.numSecond, KOKKOS_LAMBDA(const int i) {
        const int own = nodes.parent(i), other = nodes.numLattice + i;
        if (!(cohesive(own, cohesion::peak) < 0.0))
          return;
        const Vector<3> held = holding(i);
        const double a = nodes.sums(own, Nodes<3>::massAt), b = nodes.sums(other, Nodes<3>::massAt);
        const int halvings = refined && level(own) >= firstShort ? level(own) - firstShort + 1 : 0;
        const double stiffness = std::ldexp(limit, 2 * halvings) * a * b / (a + b);
        cohesive(own, cohesion::peak) = 0.0;
        if (!(norm(held) > 0.0) || !(rangeOf(i) > 0.0))
          return;
        const double share = cohesion::shareAtFirst(rangeOf(i), norm(held) / stiffness);
        const Vector<3> force = share * held;
        const double size = norm(force);
        cohesive(own, cohesion::peak) = size;
        cohesive(own, cohesion::range) = rangeOf(i) * cohesion::strengthAtFirst / share;
        cohesive(own, cohesion::start) = cohesive(own, cohesion::reached) = size / stiffness;
        tie(own, 3) = stiffness;
        for (int d = 0; d < 3; ++d)
        {
          cohesive(own, cohesion::shift + d) = force[d] / stiffness - jump(own, d);
          tie(own, d) = -signOf(side(own)) * force[d];
          if (!countsHere(nodes, own))
            continue;
          nodes.sums(own, Nodes<3>::forceAt + d) += tie(own, d);
          nodes.sums(other, Nodes<3>::forceAt + d) -= tie(own, d);
        }
      });
}

} // namespace Rhegma::cracks
