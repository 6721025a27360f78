#include "adaptivity/Criteria.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace Rhegma::adaptivity
{

namespace
{

template <int D>
using Cell = std::array<int, D>;

/// A box of cells of one level: first .. last along each axis.
template <int D>
struct CellRange
{
  Cell<D> first, last;
};

template <int D>
double edgeOf(const Grid<D>& grid, int level)
{
  return std::ldexp(grid.spacing, -level);
}

/// Cells of a level that touch a box, the domain's only.
template <int D>
CellRange<D> cellsIn(const Grid<D>& grid, int level, const Vector<D>& lower, const Vector<D>& upper)
{
  const double inverse = 1.0 / edgeOf(grid, level), slack = 1e-9;
  CellRange<D> range;
  for (int d = 0; d < D; ++d)
  {
    const double low = std::max(lower[d], grid.lower[d]), high = std::min(upper[d], grid.upper[d]);
    range.first[d] = static_cast<int>(std::floor((low - grid.origin[d]) * inverse + slack));
    range.last[d] = static_cast<int>(std::ceil((high - grid.origin[d]) * inverse - slack)) - 1;
  }
  return range;
}

template <int D, class Work>
void forEachCell(const CellRange<D>& range, const Work& work)
{
  Cell<D> cell = range.first;
  for (int d = 0; d < D; ++d)
    if (range.last[d] < range.first[d])
      return;
  for (;;)
  {
    work(cell);
    int d = 0;
    while (d < D && ++cell[d] > range.last[d])
    {
      cell[d] = range.first[d];
      ++d;
    }
    if (d == D)
      return;
  }
}

template <int D>
void refineRegions(const Criteria<D>& criteria, Branches<D>& branches)
{
  for (const Region<D>& region : criteria.regions)
    for (int level = 0; level < std::min(region.level, criteria.maximumLevel); ++level)
      forEachCell<D>(cellsIn(branches.grid(), level, region.lower, region.upper),
                     [&](const Cell<D>& cell) { branches.refine(level, cell); });
}

/// Straight pieces of the crack fronts: points in 2D.
template <int D>
std::vector<std::array<Vector<D>, 2>> frontPieces(const CrackSet<D>& cracks)
{
  std::vector<std::array<Vector<D>, 2>> pieces;
  const auto vertex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.vertex);
  const auto simplex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.simplex);
  const auto facet = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.frontFacet);
  for (const CrackFront<D>& front : cracks.fronts)
    for (int f = front.firstFacet; f < front.firstFacet + front.numFacets; ++f)
    {
      std::array<Vector<D>, 2> piece;
      for (int end = 0; end < 2; ++end)
      {
        const int v = simplex(facet(f, 0), (facet(f, 1) + 1 + (D == 3 ? end : 0)) % D);
        for (int d = 0; d < D; ++d)
          piece[end][d] = vertex(v, d);
      }
      pieces.push_back(piece);
    }
  return pieces;
}

/// Distance from a cell to a straight piece, from its middle less half its edge along each axis: exact for a
/// point, close to it for a piece.
template <int D>
double distanceOf(const Grid<D>& grid, int level, const Cell<D>& cell, const std::array<Vector<D>, 2>& piece)
{
  const double edge = edgeOf(grid, level);
  Vector<D> middle;
  for (int d = 0; d < D; ++d)
    middle[d] = grid.origin[d] + (cell[d] + 0.5) * edge;
  const Vector<D> along = piece[1] - piece[0];
  const double square = dot(along, along);
  const double at = square > 0.0 ? std::clamp(dot(middle - piece[0], along) / square, 0.0, 1.0) : 0.0;
  const Vector<D> away = middle - (piece[0] + at * along);
  double sum = 0.0;
  for (int d = 0; d < D; ++d)
  {
    const double beyond = std::max(0.0, std::fabs(away[d]) - 0.5 * edge);
    sum += beyond * beyond;
  }
  return std::sqrt(sum);
}

/// By what a front may sway before cells that are refined become larger, in cells.
constexpr double sway = 0.5;

template <int D>
void refineFronts(const State<D>& state, const Criteria<D>& criteria, const Branches<D>& now,
                  Branches<D>& branches)
{
  if (!(criteria.frontCells > 0.0) || state.cracks.empty())
    return;
  const Grid<D>& grid = branches.grid();
  for (const std::array<Vector<D>, 2>& piece : frontPieces(state.cracks))
    for (int level = 0; level < criteria.maximumLevel; ++level)
    {
      const double edge = edgeOf(grid, level), reach = (criteria.frontCells + sway) * edge;
      Vector<D> lower, upper;
      for (int d = 0; d < D; ++d)
      {
        lower[d] = std::min(piece[0][d], piece[1][d]) - reach;
        upper[d] = std::max(piece[0][d], piece[1][d]) + reach;
      }
      forEachCell<D>(cellsIn(grid, level, lower, upper),
                     [&](const Cell<D>& cell)
                     {
                       const double cells = criteria.frontCells + (now.isRefined(level, cell) ? sway : 0.0);
                       if (distanceOf<D>(grid, level, cell, piece) < cells * edge)
                         branches.refine(level, cell);
                     });
    }
}

/// Levels that velocities want, a number for each cell of the lattice and for each leaf of its tree.
struct WantedLevels
{
  View<int*> cell, leaf;
};

template <int D>
WantedLevels levelsByVelocity(const State<D>& state, const Criteria<D>& criteria)
{
  WantedLevels wanted{View<int*>("rhegma::wantedOfCells", state.grid.numNodes),
                      View<int*>("rhegma::wantedOfLeaves", state.tree.leafLevel.extent(0))};
  const TreeSight<D> sight(state.grid, state.tree);
  const auto position = state.particles.template real<D>(fields::position);
  const auto rate = state.particles.table(fields::rate);
  const double threshold = criteria.velocityChange, coarsening = criteria.coarsening;
  const double spacing = state.grid.spacing;
  const int most = criteria.maximumLevel;
  Kokkos::parallel_for(
      "rhegma::adaptivity::levelsByVelocity", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p) {
        double square = 0.0;
        for (int k = 0; k < D * D; ++k)
          square += rate(p, k) * rate(p, k);
        double change = std::sqrt(square) * spacing; // over a cell of the level that is looked at
        int finest = 0;                              // level that is fine enough
        while (finest < most && change > threshold)
        {
          ++finest;
          change *= 0.5;
        }
        int coarsest = finest; // level that is coarse enough
        while (coarsest < most && change > coarsening * threshold)
        {
          ++coarsest;
          change *= 0.5;
        }
        Vector<D> x;
        for (int d = 0; d < D; ++d)
          x[d] = position(p, d);
        const auto leaf = sight.leafAt(x);
        const int level =
            finest > leaf.level ? leaf.level + 1 : (coarsest < leaf.level ? coarsest : leaf.level);
        if (level == 0)
          return;
        if (leaf.level == 0)
          Kokkos::atomic_fetch_max(&wanted.cell(-1 - leaf.number), level);
        else
          Kokkos::atomic_fetch_max(&wanted.leaf(leaf.number), level);
      });
  return wanted;
}

/// Refines so that a place has a leaf of a level, and so the cells around by rings of the size of its parent.
template <int D>
void refineAround(const Criteria<D>& criteria, const Vector<D>& x, int level, Branches<D>& branches)
{
  const Grid<D>& grid = branches.grid();
  const double edge = edgeOf(grid, level - 1);
  CellRange<D> range;
  for (int d = 0; d < D; ++d)
  {
    const int at = static_cast<int>((x[d] - grid.origin[d]) / edge);
    const int lowest = static_cast<int>(std::floor((grid.lower[d] - grid.origin[d]) / edge + 1e-9));
    const int highest = static_cast<int>(std::ceil((grid.upper[d] - grid.origin[d]) / edge - 1e-9)) - 1;
    range.first[d] = std::max(at - criteria.buffer, lowest);
    range.last[d] = std::min(at + criteria.buffer, highest);
  }
  forEachCell<D>(range, [&](const Cell<D>& cell) { branches.refine(level - 1, cell); });
}

template <int D>
void refineByVelocity(const State<D>& state, const Criteria<D>& criteria, Branches<D>& branches)
{
  if (!(criteria.velocityChange > 0.0) || state.step == 0)
    return;
  const WantedLevels wanted = levelsByVelocity(state, criteria);
  const Grid<D>& grid = state.grid;
  const auto cell = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, wanted.cell);
  const auto leaf = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, wanted.leaf);
  const auto level = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.tree.leafLevel);
  const auto corner = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.tree.leafCorner);
  const auto middleOf = [&](Vector<D> x, int of)
  {
    for (int d = 0; d < D; ++d)
      x[d] += 0.5 * edgeOf(grid, of);
    return x;
  };
  for (int n = 0; n < grid.numNodes; ++n)
    if (cell(n) > 0)
      refineAround(criteria, middleOf(grid.nodePosition(n), 0), cell(n), branches);
  for (int l = 0; l < static_cast<int>(leaf.extent(0)); ++l)
    if (leaf(l) > 0)
    {
      Vector<D> x;
      for (int d = 0; d < D; ++d)
        x[d] = corner(l, d);
      refineAround(criteria, middleOf(x, level(l)), leaf(l), branches);
    }
}

} // namespace

template <int D>
Branches<D> wantedBranches(const State<D>& state, const Criteria<D>& criteria, const Branches<D>& now)
{
  Branches<D> branches(state.grid);
  refineRegions(criteria, branches);
  refineFronts(state, criteria, now, branches);
  refineByVelocity(state, criteria, branches);
  branches.balance();
  return branches;
}

template Branches<2> wantedBranches(const State<2>&, const Criteria<2>&, const Branches<2>&);
template Branches<3> wantedBranches(const State<3>&, const Criteria<3>&, const Branches<3>&);

} // namespace Rhegma::adaptivity
