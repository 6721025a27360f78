#include "cracks/Sides.hpp"

#include <algorithm>

namespace Rhegma::cracks
{

namespace
{

/// A polyline and the box beyond which it does not matter.
struct Reach
{
  Polyline line;
  double lower[2], upper[2];
  int firstNode, lastNode; ///< numbers between which all nodes in the box lie
};

/// Cells beyond the box in which a particle may still see one of its nodes, or may be out of its block.
constexpr double sightBeyond = 3.0;

std::vector<Reach> reaches(const State<2>& state)
{
  const auto vertex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.cracks.vertex);
  std::vector<Reach> all;
  for (const Polyline& line : polylines(state.cracks))
  {
    Reach reach{line, {1e300, 1e300}, {-1e300, -1e300}, 0, 0};
    for (int v = line.first; v <= line.last; ++v)
      for (int d = 0; d < 2; ++d)
      {
        reach.lower[d] = std::min(reach.lower[d], vertex(v, d) - bandWidth * state.grid.spacing);
        reach.upper[d] = std::max(reach.upper[d], vertex(v, d) + bandWidth * state.grid.spacing);
      }
    // Nodes are numbered with one axis slowest, so the box along it bounds the numbers.
    const int slow = state.grid.axisOrder[0];
    reach.firstNode = static_cast<int>(state.grid.inCells(reach.lower[slow], slow)) * state.grid.stride[slow];
    reach.lastNode =
        (static_cast<int>(state.grid.inCells(reach.upper[slow], slow)) + 1) * state.grid.stride[slow];
    all.push_back(reach);
  }
  return all;
}

KOKKOS_INLINE_FUNCTION bool isIn(const Reach& reach, const Vector<2>& x)
{
  return x[0] > reach.lower[0] && x[0] < reach.upper[0] && x[1] > reach.lower[1] && x[1] < reach.upper[1];
}

void clearNodeSides(State<2>& state)
{
  const Nodes<2> nodes = state.nodes;
  const View<int*> side = state.cracks.nodeSide;
  const View<int*> second = state.cracks.second;
  Kokkos::parallel_for(
      "rhegma::cracks::clearNodeSides", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        side(nodes.active(i)) = 0;
        second(nodes.active(i)) = -1;
      });
}

void findNodeSides(const State<2>& state, const Reach& reach, int crack, const View<int*>& cellMark,
                   int stamp)
{
  const Nodes<2> nodes = state.nodes;
  const Grid<2> grid = state.grid;
  const View<int*> side = state.cracks.nodeSide;
  const double tie = tieTolerance * grid.spacing, atFront = frontTolerance * grid.spacing;
  const double band = bandWidth * grid.spacing;
  Kokkos::parallel_for(
      "rhegma::cracks::findNodeSides", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        const int n = nodes.active(i);
        if (n < reach.firstNode || n > reach.lastNode)
          return;
        const Vector<2> x = grid.nodePosition(n);
        if (!isIn(reach, x))
          return;
        const Sight sight = look(reach.line, x);
        if (std::abs(sight.distance) > band || sight.behind <= atFront)
          return;
        side(n) = sight.distance > -tie ? crack + 1 : -(crack + 1);
        // A particle in cell c touches nodes c - 1 to c + 2 along each axis.
        int at[2];
        grid.nodeCoordinates(n, at);
        for (int a = -2; a <= 1; ++a)
          for (int b = -2; b <= 1; ++b)
          {
            const int cell[2] = {at[0] + a, at[1] + b};
            Kokkos::atomic_exchange(&cellMark(grid.nodeIndex(cell)), stamp);
          }
      });
}

int numberSecondFields(State<2>& state)
{
  const Nodes<2> nodes = state.nodes;
  const View<int*> side = state.cracks.nodeSide;
  const View<int*> second = state.cracks.second;
  int count = 0;
  Kokkos::parallel_scan(
      "rhegma::cracks::numberSecondFields", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i, int& at, const bool final) {
        const int n = nodes.active(i);
        if (side(n) == 0)
          return;
        if (final)
          second(n) = nodes.numLattice + at;
        ++at;
      },
      count);
  return count;
}

void listParents(State<2>& state, int count)
{
  if (static_cast<int>(state.nodes.parent.extent(0)) < count)
    state.nodes.parent = View<int*>("rhegma::secondFieldParent", 2 * count);
  if (static_cast<int>(state.nodes.sums.extent(0)) < state.grid.numNodes + count)
    state.nodes.reserve(state.grid.numNodes, 2 * count);
  state.nodes.numSecond = count;
  const Nodes<2> nodes = state.nodes;
  const View<int*> second = state.cracks.second;
  Kokkos::parallel_for(
      "rhegma::cracks::listParents", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        const int n = nodes.active(i);
        if (second(n) >= 0)
          nodes.parent(second(n) - nodes.numLattice) = n;
      });
}

/// True if a particle of the block may be near the crack.
KOKKOS_INLINE_FUNCTION bool isNear(const Reach& reach, const Grid<2>& grid, const Blocks<2>& blocks,
                                   int block)
{
  bool near = true;
  for (int a = 0; a < 2; ++a)
  {
    const int axis = grid.axisOrder[a];
    const double low = blocks.corner(block, a);
    near = near && grid.inCells(reach.upper[axis], axis) > low - sightBeyond &&
           grid.inCells(reach.lower[axis], axis) < low + Blocks<2>::edge + sightBeyond;
  }
  return near;
}

/// Marks the particles in marked cells.
void markParticles(const State<2>& state, const Reach& reach, const View<int*>& cellMark, int stamp,
                   const View<int*>& row)
{
  const Grid<2> grid = state.grid;
  const Blocks<2> blocks = state.blocks;
  const auto position = state.particles.real<2>(fields::position);
  Kokkos::parallel_for(
      "rhegma::cracks::markParticles", Kokkos::RangePolicy<ExecSpace>(0, blocks.numBlocks),
      KOKKOS_LAMBDA(const int b) {
        if (!isNear(reach, grid, blocks, b))
          return;
        for (int p = blocks.first(b); p < blocks.first(b + 1); ++p)
        {
          const int cell[2] = {static_cast<int>(grid.inCells(position(p, 0), 0)),
                               static_cast<int>(grid.inCells(position(p, 1), 1))};
          if (cellMark(grid.nodeIndex(cell)) == stamp)
            row(p) = 0;
        }
      });
}

/// Gives marked particles without a side the side of the nearest crack.
void findParticleSides(const State<2>& state, const Reach& reach, int crack, const View<int*>& row)
{
  const Grid<2> grid = state.grid;
  const Blocks<2> blocks = state.blocks;
  const auto position = state.particles.real<2>(fields::position);
  const auto side = state.particles.integer(fields::side);
  const double band = (bandWidth + 2.0) * grid.spacing;
  Kokkos::parallel_for(
      "rhegma::cracks::findParticleSides", Kokkos::RangePolicy<ExecSpace>(0, blocks.numBlocks),
      KOKKOS_LAMBDA(const int b) {
        if (!isNear(reach, grid, blocks, b))
          return;
        for (int p = blocks.first(b); p < blocks.first(b + 1); ++p)
        {
          const Vector<2> x{position(p, 0), position(p, 1)};
          if (row(p) < 0 || side(p) != 0 || !isIn(reach, x))
            continue;
          const Sight sight = look(reach.line, x);
          if (std::abs(sight.distance) < band)
            side(p) = sight.distance >= 0.0 ? crack + 1 : -(crack + 1);
        }
      });
}

} // namespace

std::vector<Polyline> polylines(const CrackSet<2>& cracks)
{
  std::vector<Polyline> lines;
  for (const Crack<2>& crack : cracks.cracks)
    lines.push_back(
        {cracks.vertex, crack.firstVertex, crack.firstVertex + crack.numVertices - 1, false, false});
  for (const CrackFront<2>& front : cracks.fronts)
    (front.vertex == lines[front.crack].first ? lines[front.crack].frontFirst
                                              : lines[front.crack].frontLast) = true;
  return lines;
}

void findSides(State<2>& state, Surroundings& surroundings, const View<int*>& row)
{
  if (static_cast<int>(surroundings.cellMark.extent(0)) != state.grid.numNodes)
    surroundings.cellMark = View<int*>("rhegma::cracks::cellMark", state.grid.numNodes);
  ++surroundings.stamp;
  const std::vector<Reach> all = reaches(state);
  clearNodeSides(state);
  for (std::size_t c = 0; c < all.size(); ++c)
    findNodeSides(state, all[c], static_cast<int>(c), surroundings.cellMark, surroundings.stamp);
  if (state.cracks.dualField)
    listParents(state, numberSecondFields(state));
  for (const Reach& reach : all)
    markParticles(state, reach, surroundings.cellMark, surroundings.stamp, row);
  for (std::size_t c = 0; c < all.size(); ++c)
    findParticleSides(state, all[c], static_cast<int>(c), row);
}

} // namespace Rhegma::cracks
