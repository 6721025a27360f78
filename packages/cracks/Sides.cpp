#include "cracks/Sides.hpp"

#include "base/RelaxedLoad.hpp"
#include "cracks/CohesiveLaw.hpp"
#include "cracks/Nearest.hpp"
#include "state/BodyGroup.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace Rhegma::cracks
{

namespace
{

/// Cells beyond the box of a crack and its band in which a particle may still see one of its nodes, or may be
/// out of its block.
constexpr double sightBeyond = 3.0;

/// Finds the boxes of the cracks along the axes that are cut into blocks, enlarged by the band in which nodes
/// have a side and by sightBeyond.
template <int D>
void findReach(const State<D>& state, Surroundings& around)
{
  const std::vector<Crack<D>>& cracks = state.cracks.cracks;
  const Grid<D>& grid = state.mesh.grid;
  if (around.reach.extent(0) != cracks.size())
    around.reach = View<double* [4]>("rhegma::cracks::reach", cracks.size());
  const auto vertex = onHost(state.cracks.vertex);
  const auto reach = Kokkos::create_mirror_view(around.reach);
  const double band = bandWidth * grid.spacing;
  for (std::size_t c = 0; c < cracks.size(); ++c)
    for (int a = 0; a < 2; ++a)
    {
      const int axis = grid.axisOrder[a];
      double lower = 1e300, upper = -1e300;
      for (int v = cracks[c].firstVertex; v < cracks[c].firstVertex + cracks[c].numVertices; ++v)
      {
        lower = std::min(lower, vertex(v, axis) - band);
        upper = std::max(upper, vertex(v, axis) + band);
      }
      reach(c, 2 * a) = grid.inCells(lower, axis) - sightBeyond;
      reach(c, 2 * a + 1) = grid.inCells(upper, axis) + sightBeyond;
    }
  Kokkos::deep_copy(around.reach, reach);
}

/// True if a particle of the block may be near a crack.
template <int D>
KOKKOS_INLINE_FUNCTION bool isNearAny(const View<double* [4]>& reach, const Blocks<D>& blocks, int block)
{
  const double low[2] = {double(blocks.corner(block, 0)), double(blocks.corner(block, 1))};
  for (int c = 0; c < static_cast<int>(reach.extent(0)); ++c)
    if (reach(c, 1) > low[0] && reach(c, 0) < low[0] + Blocks<D>::edge && reach(c, 3) > low[1] &&
        reach(c, 2) < low[1] + Blocks<D>::edge)
      return true;
  return false;
}

template <int D>
void clearNodeSides(const State<D>& state, const Surroundings& around)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int*> side = state.cracks.nodeSide;
  const View<int*> second = state.cracks.enrichedField;
  const View<std::uint64_t*> nearest = around.nearest;
  Kokkos::parallel_for(
      "rhegma::cracks::clearNodeSides", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        const int n = nodes.active(i);
        side(n) = 0;
        second(n) = -1;
        nearest(n) = noSimplex;
      });
}

/// Largest component of the normal of a simplex.
template <int D>
KOKKOS_INLINE_FUNCTION double steepestOf(const CrackSight<D>& sight, int simplex)
{
  double steepest = 0.0;
  for (int d = 0; d < D; ++d)
    steepest = std::fmax(steepest, std::fabs(sight.normal(simplex, d)));
  return steepest;
}

/// How far behind a front a node must lie to open, with springs, seen from a simplex [cells]. \param distance
/// from the crack [cells]
template <int D>
KOKKOS_INLINE_FUNCTION double toleranceWithSprings(const CrackSight<D>& sight, int simplex, double distance,
                                                   FrontLaw law)
{
  const double steepest = steepestOf(sight, simplex);
  const double ahead = splitAhead<D>(steepest, std::fabs(distance) / steepest, law);
  return hasFrontCell<D>(steepest, law) ? law.least() - ahead : -ahead;
}

/// Marks the cells whose particles may touch a node at x: a particle in cell c touches nodes c - 1 to c + 2
/// along each axis, and in refined cells those in c - 1 to c + 1. A cell may be outside the lattice where a
/// crack begins at the boundary of the domain.
template <int D>
KOKKOS_INLINE_FUNCTION void markCells(const Grid<D>& grid, const Vector<D>& x, const View<int*>& cellMark,
                                      int stamp)
{
  int first[D], last[D], at[D];
  for (int d = 0; d < D; ++d)
  {
    const int cell = static_cast<int>(grid.inCells(x[d], d) + 1e-6);
    first[d] = cell < 2 ? 0 : cell - 2;
    last[d] = cell + 1 < grid.cells[d] ? cell + 1 : grid.cells[d] - 1;
  }
  const auto mark = [&](int n)
  {
    if (relaxedLoad(cellMark(n)) != stamp)
      Kokkos::atomic_exchange(&cellMark(n), stamp);
  };
  for (at[0] = first[0]; at[0] <= last[0]; ++at[0])
    for (at[1] = first[1]; at[1] <= last[1]; ++at[1])
      if constexpr (D == 2)
        mark(at[0] * grid.stride[0] + at[1] * grid.stride[1]);
      else
        for (at[2] = first[2]; at[2] <= last[2]; ++at[2])
          mark(grid.nodeIndex(at));
}

template <int D>
void findNodeSides(const State<D>& state, const Surroundings& around)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const Grid<D> grid = state.mesh.grid;
  const NodePositions<D> positions = nodePositions(state);
  const bool refined = state.mesh.tree.refined();
  const View<int*> level = state.mesh.tree.nodeLevel;
  const CrackSight<D> sight(state.cracks, grid.spacing);
  const View<int*> side = state.cracks.nodeSide, cellMark = around.cellMark;
  const View<std::uint64_t*> nearest = around.nearest;
  const bool frontSprings = state.cracks.frontSprings;
  const View<double*> conductance = state.cracks.frontConductance;
  const int stamp = around.stamp;
  const FrontLaw lawOfHeld = around.law, lawOfGrown = D == 2 && around.releases ? FrontLaw{} : around.law;
  Kokkos::parallel_for(
      "rhegma::cracks::findNodeSides", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        const int n = nodes.active(i);
        if (nearest(n) == noSimplex)
          return;
        const int s = simplexOf(nearest(n));
        const Vector<D> x = positions(n);
        const double cell = refined ? grid.spacing / (1 << level(n)) : grid.spacing;
        const Sight seen = sight.locate(s, x);
        const FrontLaw law = sight.nearFront(s) == nearFront::grown ? lawOfGrown : lawOfHeld;
        if (sight.nearFront(s) != nearFront::away) // else it is behind all fronts
        {
          const bool springs = frontSprings && sight.nearFront(s) != nearFront::springsDisabled;
          const double tolerance =
              springs ? toleranceWithSprings<D>(sight, s, seen.distance / cell, law) : frontTolerance;
          if (seen.behind <= tolerance * cell)
            return;
        }
        const int name = sight.crackOf(s) + 1;
        side(n) = seen.distance > -sideTolerance * cell ? name : -name;
        if (conductance.extent(0) > 0)
        {
          const double steepest = steepestOf(sight, s);
          conductance(n) = frontSprings && nearFront::mayHaveSprings(sight.nearFront(s))
                               ? frontCell::conductance *
                                     frontBond<D>(seen.behind / cell,
                                                  std::fabs(seen.distance) / (cell * steepest), steepest, law)
                               : 0.0;
        }
        markCells(grid, x, cellMark, stamp);
      });
}

template <int D>
int numberEnrichedFields(const State<D>& state)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int*> side = state.cracks.nodeSide;
  const View<int*> second = state.cracks.enrichedField;
  int count = 0;
  Kokkos::parallel_scan(
      "rhegma::cracks::numberEnrichedFields", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
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

template <int D>
void listParents(State<D>& state, int count)
{
  if (state.mesh.nodes.numEnriched != 0) // rows of cracks come first
    throw std::logic_error("the effect Cracks prepares stencils after another effect that divides nodes");
  state.mesh.nodes.claimFieldsOfCracks(count);
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int*> second = state.cracks.enrichedField;
  Kokkos::parallel_for(
      "rhegma::cracks::listParents", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        const int n = nodes.active(i);
        if (second(n) >= 0)
          nodes.parent(second(n) - nodes.numLattice) = n;
      });
}

/// Cells: a position nearer to the crack than this lies on side +1. Otherwise rounding would scatter a row of
/// particles on a crack over both sides, and light nodes would become unstable.
constexpr double onCrack = 1e-6;

/// The side of a position in a cell: that of the simplex, of those nearest to the cell's nodes, which is
/// nearest to the position. 0 where no crack is near.
template <int D>
struct SideOfPosition
{
  Grid<D> grid;
  CrackSight<D> sight;
  View<std::uint64_t*> nearest;

  KOKKOS_INLINE_FUNCTION int operator()(const int (&cell)[D], const Vector<D>& x) const
  {
    int found = -1;
    double least = 1e300;
    for (int k = 0; k < (1 << D); ++k)
    {
      int n = grid.nodeIndex(cell);
      for (int d = 0; d < D; ++d)
        n += ((k >> d) & 1) * grid.stride[d];
      if (nearest(n) == noSimplex || simplexOf(nearest(n)) == found)
        continue;
      const double square = sight.square(simplexOf(nearest(n)), x);
      if (square < least)
      {
        least = square;
        found = simplexOf(nearest(n));
      }
    }
    if (found < 0)
      return 0;
    const int name = sight.crackOf(found) + 1;
    return sight.locate(found, x).distance >= -onCrack * grid.spacing ? name : -name;
  }
};

/// Gives a particle in a cell near a crack its side, and marks it if a node in its reach lies on the other.
template <int D>
struct MarkParticle
{
  Grid<D> grid;
  SideOfPosition<D> sideOf;
  BorrowedView<double* [D]> position;
  BorrowedView<int*> side, bodyGroup;
  View<int*> bodyGroupOf; ///< of each crack; empty where it may cut all particles
  View<int*> nodeSide, row;
  bool onlySplit; ///< false: mark it in any case

  KOKKOS_INLINE_FUNCTION void operator()(int p, int cell) const
  {
    if (side(p) == 0)
      side(p) = findSide(p);
    if (!onlySplit)
      row(p) = 0;
    if (row(p) >= 0 || side(p) == 0)
      return;
    const int other = -side(p);
    constexpr int rows = D == 2 ? 4 : 16; // of four nodes along the first axis
    bool sees = false;
    for (int k = 0; k < rows && !sees; ++k)
    {
      int n = cell - grid.stride[0];
      for (int d = 1; d < D; ++d)
        n += (((k >> (2 * (d - 1))) & 3) - 1) * grid.stride[d];
      for (int i = 0; i < 4; ++i, n += grid.stride[0])
        sees = sees || nodeSide(n) == other;
    }
    if (sees)
      row(p) = 0;
  }

  KOKKOS_INLINE_FUNCTION int findSide(int p) const
  {
    int cell[D];
    Vector<D> x;
    for (int d = 0; d < D; ++d)
    {
      x[d] = position(p, d);
      cell[d] = static_cast<int>(grid.inCells(x[d], d));
    }
    const int found = sideOf(cell, x);
    return found == 0 || isCutBy(p, found > 0 ? found : -found) ? found : 0;
  }

  /// Whether a particle belongs to the bodies that a crack cuts. \param name its number + 1
  KOKKOS_INLINE_FUNCTION bool isCutBy(int p, int name) const
  {
    return bodyGroupOf.extent(0) == 0 || bodyGroupOf(name - 1) == bodyGroup(p);
  }
};

/// Gives particles near cracks their side and marks those in whose reach a node lies on the other side; all
/// near cracks where particles on one side stand in for nodes of the other (broken cells).
template <int D>
void markParticles(const State<D>& state, const Surroundings& around, const View<int*>& row)
{
  const Grid<D> grid = state.mesh.grid;
  const Blocks<D> blocks = state.mesh.blocks;
  const auto position = state.particles.template real<D>(fields::position);
  const SideOfPosition<D> sideOf{grid, CrackSight<D>(state.cracks, grid.spacing), around.nearest};
  const View<int*> bodyGroupOf = state.cracks.bodyGroupOf;
  BorrowedView<int*> bodyGroup;
  if (bodyGroupOf.extent(0) > 0)
    bodyGroup = state.particles.integer(fields::bodyGroup);
  const MarkParticle<D> mark{grid,
                             sideOf,
                             position,
                             state.particles.integer(fields::side),
                             bodyGroup,
                             bodyGroupOf,
                             state.cracks.nodeSide,
                             row,
                             state.cracks.dualField};
  const View<int*> cellMark = around.cellMark;
  const View<double* [4]> reach = around.reach;
  const int stamp = around.stamp;
  Kokkos::parallel_for(
      "rhegma::cracks::markParticles",
      Kokkos::RangePolicy<ExecSpace, Kokkos::Schedule<Kokkos::Dynamic>>(0, blocks.numBlocks,
                                                                        Kokkos::ChunkSize(1)),
      KOKKOS_LAMBDA(const int b) {
        if (!isNearAny(reach, blocks, b))
          return;
        const int last = blocks.first(b + 1);
        for (int begin = blocks.first(b); begin < last; begin += lanes)
        {
          const int count = begin + lanes < last ? lanes : last - begin;
          int cell[lanes] = {}; // by its lowest node
          for (int d = 0; d < D; ++d)
            for (int l = 0; l < count; ++l)
              cell[l] += grid.stride[d] * static_cast<int>(grid.inCells(position(begin + l, d), d));
          for (int l = 0; l < count; ++l)
            if (cellMark(cell[l]) == stamp)
              mark(begin + l, cell[l]);
        }
      });
}

/// Resizes the arrays over nodes and cells after refinement.
template <int D>
void reserveRows(State<D>& state, Surroundings& around)
{
  const int nodes = state.mesh.nodes.numLattice, capacity = nodes + nodes / 4;
  // After a new division of the domain, values would belong to other nodes.
  if (state.mesh.subdomain && around.generation != state.mesh.tree.generation)
  {
    around.nearest = View<std::uint64_t*>();
    state.cracks.nodeSide = state.cracks.enrichedField = around.cellMark = View<int*>();
    around.generation = state.mesh.tree.generation;
  }
  if (static_cast<int>(around.cellMark.extent(0)) != state.mesh.grid.numNodes)
    around.cellMark = View<int*>("rhegma::cracks::cellMark", state.mesh.grid.numNodes);
  if (static_cast<int>(around.nearest.extent(0)) < nodes)
  {
    around.nearest = View<std::uint64_t*>("rhegma::cracks::nearest", capacity);
    Kokkos::deep_copy(around.nearest, noSimplex);
  }
  CrackSet<D>& cracks = state.cracks;
  if (static_cast<int>(cracks.nodeSide.extent(0)) < nodes)
  {
    cracks.nodeSide = View<int*>("rhegma::nodeSide", capacity);
    cracks.enrichedField = View<int*>("rhegma::enrichedField", capacity);
    Kokkos::deep_copy(cracks.enrichedField, -1);
  }
  if (around.law.ofCells && cracks.frontConductance.extent(0) < cracks.nodeSide.extent(0))
    cracks.frontConductance = View<double*>("rhegma::frontConductance", cracks.nodeSide.extent(0));
}

} // namespace

template <int D>
void findSides(State<D>& state, Surroundings& surroundings, const View<int*>& row,
               const std::function<void()>& claim)
{
  reserveRows(state, surroundings);
  ++surroundings.stamp;
  clearNodeSides(state, surroundings);
  findNearest(state, surroundings);
  if (claim)
    claim();
  findNodeSides(state, surroundings);
  if (state.cracks.dualField)
    listParents(state, numberEnrichedFields(state));
  findReach(state, surroundings);
  markParticles(state, surroundings, row);
}

template void findSides(State<2>&, Surroundings&, const View<int*>&, const std::function<void()>&);
template void findSides(State<3>&, Surroundings&, const View<int*>&, const std::function<void()>&);

} // namespace Rhegma::cracks
