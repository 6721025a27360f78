#include "grid/Grid.hpp"

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace Rhegma
{

namespace
{

/// A position in the rows of all nodes, up to eight numbers each and with enriched fields next to cracks,
/// fits into an int.
constexpr double mostNodes = 0.1 * std::numeric_limits<int>::max();

} // namespace

template <int D>
void numberNodes(Grid<D>& grid)
{
  for (int d = 0; d < D; ++d)
    grid.axisOrder[d] = d;
  std::stable_sort(grid.axisOrder, grid.axisOrder + D,
                   [&](int a, int b) { return grid.cells[a] > grid.cells[b]; });
  int stride = 1;
  for (int k = D - 1; k >= 0; --k)
  {
    grid.stride[grid.axisOrder[k]] = stride;
    stride *= grid.cells[grid.axisOrder[k]] + 1;
  }
  grid.numNodes = stride;
}

template <int D>
Grid<D> makeGrid(const Vector<D>& lower, const Vector<D>& upper, double spacing)
{
  Grid<D> grid;
  grid.lower = lower;
  grid.upper = upper;
  grid.spacing = spacing;
  grid.inverse = 1.0 / spacing;
  double nodes = 1.0;
  for (int d = 0; d < D; ++d)
  {
    grid.origin[d] = grid.whole[d] = lower[d] - gridMargin * spacing;
    grid.before[d] = 0;
    // A length that is whole cells but for round-off gets no extra cell.
    const double cells = std::ceil((upper[d] - lower[d]) / spacing - 1e-9) + 2 * gridMargin;
    nodes *= cells + 1.0;
    grid.cells[d] = static_cast<int>(std::min(cells, 1e9));
  }
  if (!(nodes <= mostNodes))
  {
    std::ostringstream message;
    message << "Domain > Cell Size: the domain would have about " << nodes << " nodes, more than "
            << mostNodes << "; use larger cells or a smaller domain";
    throw std::invalid_argument(message.str());
  }
  numberNodes(grid);
  return grid;
}

template void numberNodes(Grid<2>&);
template void numberNodes(Grid<3>&);
template Grid<2> makeGrid(const Vector<2>&, const Vector<2>&, double);
template Grid<3> makeGrid(const Vector<3>&, const Vector<3>&, double);

} // namespace Rhegma
