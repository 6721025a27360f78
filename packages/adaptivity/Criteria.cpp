#include "adaptivity/Criteria.hpp"

#include "adaptivity/VelocityCriterion.hpp"
#include "state/Subdomain.hpp"

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
  const auto vertex = onHost(cracks.vertex);
  const auto simplex = onHost(cracks.simplex);
  const auto facet = onHost(cracks.frontFacet);
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

/// How far a front may move away before refined cells are coarsened [cells].
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

/// Refines the cells over which a quantity changes much, and rings of cells of their size around them.
template <int D>
void refineByChange(const State<D>& state, const Criteria<D>& criteria, double threshold,
                    const std::string& gradient, Branches<D>& branches)
{
  // Gradients are not known before the first step.
  if (!(threshold > 0.0) || state.clock.step == 0)
    return;
  const Grid<D>& grid = branches.grid();
  const double keeping = criteria.coarsening * threshold;
  for (const LevelCell<D>& cell :
       cellsOfFastChange(state, threshold, keeping, criteria.maximumLevel, gradient))
  {
    const CellRange<D> domain = cellsIn(grid, cell.level, grid.lower, grid.upper);
    CellRange<D> range;
    for (int d = 0; d < D; ++d)
    {
      range.first[d] = std::max(cell.at[d] - criteria.buffer, domain.first[d]);
      range.last[d] = std::min(cell.at[d] + criteria.buffer, domain.last[d]);
    }
    forEachCell<D>(range, [&](const Cell<D>& near) { branches.refine(cell.level, near); });
  }
}

} // namespace

template <int D>
Branches<D> wantedBranches(const State<D>& state, const Criteria<D>& criteria, const Branches<D>& now)
{
  Branches<D> branches(wholeLattice(state));
  refineRegions(criteria, branches);
  refineFronts(state, criteria, now, branches);
  refineByChange(state, criteria, criteria.velocityChange, fields::rate, branches);
  refineByChange(state, criteria, criteria.temperatureChange, fields::temperatureGradient, branches);
  branches.balance();
  return branches;
}

template Branches<2> wantedBranches(const State<2>&, const Criteria<2>&, const Branches<2>&);
template Branches<3> wantedBranches(const State<3>&, const Criteria<3>&, const Branches<3>&);

} // namespace Rhegma::adaptivity
