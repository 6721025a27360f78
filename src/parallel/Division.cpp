#include "parallel/Division.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Zoltan2_BasicVectorAdapter.hpp>
#include <Zoltan2_PartitioningProblem.hpp>
#include <Zoltan2_PartitioningSolution.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace Rhegma
{

namespace
{

using Types = Zoltan2::BasicUserTypes<double, int, long long>;
using Adapter = Zoltan2::BasicVectorAdapter<Types>;

template <int D>
CellBox<D> wholeDomain(const Grid<D>& lattice)
{
  CellBox<D> all;
  for (int d = 0; d < D; ++d)
  {
    all.low[d] = gridMargin;
    all.high[d] = lattice.cells[d] - gridMargin;
  }
  return all;
}

/// Axes with fewer cells are not cut: columns of cells are cut across.
constexpr double leastCells = 8.0;

/// The axes to cut, in order of decreasing extent of the positions of all ranks.
template <int D>
std::vector<int> axesToCut(const Ranks& ranks, const std::vector<double> (&x)[D])
{
  double ends[2 * D]; // -lowest, highest
  std::fill(ends, ends + 2 * D, -1e300);
  for (int d = 0; d < D; ++d)
    for (const double cell : x[d])
    {
      ends[2 * d] = std::max(ends[2 * d], -cell);
      ends[2 * d + 1] = std::max(ends[2 * d + 1], cell);
    }
  ranks.max(ends, 2 * D);
  std::vector<int> axes(D);
  std::iota(axes.begin(), axes.end(), 0);
  const auto length = [&](int d) { return ends[2 * d] + ends[2 * d + 1] + 1.0; };
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return length(a) > length(b); });
  while (axes.size() > 1 &&
         (length(axes.back()) < leastCells || length(axes.back()) * ranks.size() < length(axes.front())))
    axes.pop_back();
  return axes;
}

} // namespace

template <int D>
void Division<D>::cellAt(const Vector<D>& x, int (&cell)[D]) const
{
  const CellBox<D> all = wholeDomain(lattice);
  for (int d = 0; d < D; ++d)
    cell[d] = std::clamp(static_cast<int>(std::floor(lattice.inCells(x[d], d))), all.low[d], all.high[d] - 1);
}

template <int D>
int Division<D>::ownerOf(const int (&cell)[D]) const
{
  for (std::size_t r = 0; r < boxes.size(); ++r)
    if (boxes[r].holds(cell))
      return static_cast<int>(r);
  throw std::logic_error("a cell of the domain belongs to no rank");
}

template <int D>
CellBox<D> Division<D>::windowCells(int rank) const
{
  CellBox<D> cells;
  for (int d = 0; d < D; ++d)
  {
    cells.low[d] = std::max(boxes[rank].low[d] - margin, 0);
    cells.high[d] = std::min(boxes[rank].high[d] + margin, lattice.cells[d]);
  }
  return cells;
}

template <int D>
Grid<D> Division<D>::window(int rank) const
{
  Grid<D> window = lattice;
  window.numNodes = 1;
  const CellBox<D> cells = windowCells(rank);
  for (int d = 0; d < D; ++d)
  {
    window.before[d] = cells.low[d];
    window.origin[d] = lattice.origin[d] + cells.low[d] * lattice.spacing;
    window.cells[d] = cells.high[d] - cells.low[d];
  }
  numberNodes(window);
  return window;
}

template <int D>
Division<D> divide(const Ranks& ranks, const Grid<D>& lattice, const std::vector<Vector<D>>& positions,
                   const std::vector<double>& costs)
{
  Division<D> division{lattice, std::vector<CellBox<D>>(ranks.size(), wholeDomain(lattice))};
  if (!ranks.many())
    return division;
  // In cells, so that a cut at a whole number is a face between cells.
  const int count = static_cast<int>(positions.size());
  std::vector<double> x[D];
  for (int d = 0; d < D; ++d)
    for (int k = 0; k < count; ++k)
      x[d].push_back(std::floor(lattice.inCells(positions[k][d], d)) + 0.5);
  const std::vector<int> axes = axesToCut<D>(ranks, x);
  const auto along = [&](std::size_t k) { return k < axes.size() ? x[axes[k]].data() : nullptr; };
  std::vector<long long> ids(count);
  std::iota(ids.begin(), ids.end(), static_cast<long long>(ranks.rank()) << 32);
  // All ranks must agree on whether there are costs, also one without positions.
  const bool weighed = ranks.max(costs.empty() ? 0.0 : 1.0) > 0.0;
  const Adapter adapter(count, ids.data(), along(0), along(1), along(2), 1, 1, 1, weighed,
                        weighed ? costs.data() : nullptr, 1);
  Teuchos::ParameterList settings;
  settings.set("algorithm", "multijagged");
  settings.set("num_global_parts", ranks.size());
  settings.set("imbalance_tolerance", 1.01);
  settings.set("mj_keep_part_boxes", true);
  settings.set("rectilinear", true);
  Zoltan2::PartitioningProblem<Adapter> problem(const_cast<Adapter*>(&adapter), &settings, ranks.comm());
  problem.solve();
  const auto& parts = problem.getSolution().getPartBoxesView();
  const CellBox<D> all = wholeDomain(lattice);
  for (std::size_t k = 0; k < axes.size(); ++k)
  {
    const int d = axes[k];
    double first = 1e300, last = -1e300;
    for (const auto& part : parts)
    {
      first = std::min(first, part.getlmins()[k]);
      last = std::max(last, part.getlmaxs()[k]);
    }
    for (const auto& part : parts)
    {
      // The outermost boxes end at the last positions; the domain extends further.
      const auto face = [&](double cut)
      { return std::clamp(static_cast<int>(std::ceil(cut - 0.5)), all.low[d], all.high[d]); };
      CellBox<D>& box = division.boxes[part.getpId()];
      box.low[d] = part.getlmins()[k] <= first ? all.low[d] : face(part.getlmins()[k]);
      box.high[d] = part.getlmaxs()[k] >= last ? all.high[d] : face(part.getlmaxs()[k]);
    }
  }
  return division;
}

template struct Division<2>;
template struct Division<3>;
template Division<2> divide(const Ranks&, const Grid<2>&, const std::vector<Vector<2>>&,
                            const std::vector<double>&);
template Division<3> divide(const Ranks&, const Grid<3>&, const std::vector<Vector<3>>&,
                            const std::vector<double>&);

} // namespace Rhegma
