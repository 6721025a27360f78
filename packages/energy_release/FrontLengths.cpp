#include "energy_release/FrontLengths.hpp"

#include "energy_release/Contour.hpp"
#include "energy_release/FrontLine.hpp"
#include "plausibility/CrackExtent.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <limits>

namespace Rhegma::energy_release
{

namespace
{

int endsOf(const State<2>& state, const CrackFront<2>& front)
{
  int ends = 0;
  for (const CrackFront<2>& other : state.cracks.fronts)
    ends += other.crack == front.crack && !other.ended ? 1 : 0;
  return std::max(1, ends);
}
int endsOf(const State<3>&, const CrackFront<3>& front)
{
  const FrontLine line = lineOf(front);
  return std::any_of(line.loop.begin(), line.loop.end(), [](double length) { return length > 0.0; }) ? 2 : 1;
}

double crackLength(const State<2>&, const CrackFront<2>& front) { return front.length; }

double crackLength(const State<3>& state, const CrackFront<3>& front) { return extentOf(state, front.crack); }

/// Distance from a position to a node that is not surrounded by material, within a cell of the line in a
/// direction [m].
template <int D>
double distanceToSurface(const State<D>& state, const Vector<D>& x, const Vector<D>& direction,
                         const NodeCover<D>& cover)
{
  const NodePositions<D> positions = nodePositions(state);
  const double aside = 0.75 * state.mesh.grid.spacing;
  double nearest = std::numeric_limits<double>::infinity();
  Kokkos::parallel_reduce(
      "rhegma::distanceToSurface", Kokkos::RangePolicy<ExecSpace>(0, cover.box.count()),
      KOKKOS_LAMBDA(const int k, double& smallest) {
        if (!cover.isOpen(k))
          return;
        const Vector<D> v = positions(cover.box.node(k)) - x;
        const double along = dot(v, direction);
        if (along > 0.0 && along < smallest && dot(v, v) - along * along < aside * aside)
          smallest = along;
      },
      Kokkos::Min<double>(nearest));
  double closeness = -nearest;
  maxParts(state, &closeness, 1);
  return -closeness;
}

std::vector<FrontNode<2>> innerNodes(const CrackFront<2>& front, double) { return front.nodes; }

/// The nodes of a front that are further than a length, and a quarter of it, from the surfaces at which it
/// ends; all nodes where there are none. What is ahead of the others, whose directions are along the surface,
/// is this surface.
std::vector<FrontNode<3>> innerNodes(const CrackFront<3>& front, double from)
{
  const FrontLine line = lineOf(front);
  std::vector<FrontNode<3>> inner;
  for (std::size_t k = 0; k < line.nodes.size(); ++k)
    if (const double open = line.open[line.line[k]];
        !(open > 0.0) || std::min(line.arc[k], open - line.arc[k]) > std::min(from, 0.25 * open))
      inner.push_back(line.nodes[k]);
  return inner.empty() ? line.nodes : inner;
}

/// Distance to the nearest front ahead, within 45 degrees of the direction [m].
template <int D>
double distanceToFronts(const State<D>& state, const FrontNode<D>& from)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const CrackFront<D>& other : state.cracks.fronts)
    for (const FrontNode<D>& node : other.nodes)
    {
      const Vector<D> v = node.position - from.position;
      const double along = dot(v, from.direction), length = norm(v);
      if (!other.ended && length > 0.0 && along > 0.5 * std::sqrt(2.0) * length)
        nearest = std::min(nearest, length);
    }
  return nearest;
}

} // namespace

double FrontLengths::slope() const
{
  const double plain = 1.0 / crack + (ends == 1 ? 3.0 : 1.0) / ligament;
  return ends == 1 && crack > 3.0 * arm ? std::max(plain, 4.0 / (crack + 0.64 * arm)) : plain;
}

template <int D>
FrontLengths lengthsAt(const State<D>& state, const CrackFront<D>& front, const NodeCover<D>& cover)
{
  constexpr std::size_t most = 8; // nodes of a front that are looked at
  const int ends = endsOf(state, front);
  FrontLengths lengths{crackLength(state, front) / ends, 0.0, ends, 0.0, 0.0};
  constexpr double atEnds = 2.0; // cells
  const std::vector<FrontNode<D>> nodes = innerNodes(front, atEnds * state.mesh.grid.spacing);
  const std::size_t count = nodes.size(), looked = std::min(count, most);
  double inverse = 0.0, armInverse = 0.0;
  for (std::size_t k = 0; k < looked; ++k)
  {
    const FrontNode<D>& node = nodes[k * count / looked];
    const auto surface = [&](const Vector<D>& along)
    { return distanceToSurface(state, node.position, along, cover); };
    inverse += 1.0 / std::min(surface(node.direction), distanceToFronts(state, node));
    armInverse += 1.0 / std::max(surface(node.normal), surface(-1.0 * node.normal));
  }
  lengths.ligament = static_cast<double>(looked) / inverse;
  lengths.arm = static_cast<double>(looked) / armInverse;
  for (const CrackFront<D>& other : state.cracks.fronts)
    if (other.crack == front.crack && !other.ended)
      lengths.front += D == 3 ? other.length : state.method.depth().at(other.position[0]);
  return lengths;
}

template FrontLengths lengthsAt(const State<2>&, const CrackFront<2>&, const NodeCover<2>&);
template FrontLengths lengthsAt(const State<3>&, const CrackFront<3>&, const NodeCover<3>&);

} // namespace Rhegma::energy_release
