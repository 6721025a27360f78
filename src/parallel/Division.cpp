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
  throw std::logic_error("a cell of the domain has no owner");
}

template <int D>
Grid<D> Division<D>::window(int rank) const
{
  Grid<D> window = lattice;
  window.numNodes = 1;
  for (int d = 0; d < D; ++d)
  {
    const int first = boxes[rank].low[d] - gridMargin;
    window.origin[d] = lattice.origin[d] + first * lattice.spacing;
    window.cells[d] = boxes[rank].high[d] - boxes[rank].low[d] + 2 * gridMargin;
  }
  numberNodes(window);
  return window;
}

template <int D>
Division<D> divide(const Ranks& ranks, const Grid<D>& lattice, const std::vector<Vector<D>>& places)
{
  Division<D> division{lattice, std::vector<CellBox<D>>(ranks.size(), wholeDomain(lattice))};
  if (!ranks.many())
    return division;
  // In cells, so that a cut at a whole number is a face between cells.
  const int count = static_cast<int>(places.size());
  std::vector<double> x[3];
  for (int d = 0; d < 3; ++d)
    for (int k = 0; k < count; ++k)
      x[d].push_back(d < D ? std::floor(lattice.inCells(places[k][d], d)) + 0.5 : 0.0);
  std::vector<long long> ids(count);
  std::iota(ids.begin(), ids.end(), static_cast<long long>(ranks.rank()) << 32);
  const Adapter adapter(count, ids.data(), x[0].data(), x[1].data(), D == 3 ? x[2].data() : nullptr);
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
  double first[3], last[3];
  for (int d = 0; d < D; ++d)
  {
    first[d] = 1e300;
    last[d] = -1e300;
    for (const auto& part : parts)
    {
      first[d] = std::min(first[d], part.getlmins()[d]);
      last[d] = std::max(last[d], part.getlmaxs()[d]);
    }
  }
  for (const auto& part : parts)
  {
    CellBox<D>& box = division.boxes[part.getpId()];
    for (int d = 0; d < D; ++d)
    {
      // The outermost boxes end at the last places; the domain reaches further.
      const auto face = [&](double cut)
      { return std::clamp(static_cast<int>(std::ceil(cut - 0.5)), all.low[d], all.high[d]); };
      box.low[d] = part.getlmins()[d] <= first[d] ? all.low[d] : face(part.getlmins()[d]);
      box.high[d] = part.getlmaxs()[d] >= last[d] ? all.high[d] : face(part.getlmaxs()[d]);
    }
  }
  return division;
}

template struct Division<2>;
template struct Division<3>;
template Division<2> divide(const Ranks&, const Grid<2>&, const std::vector<Vector<2>>&);
template Division<3> divide(const Ranks&, const Grid<3>&, const std::vector<Vector<3>>&);

} // namespace Rhegma
