#pragma once
/// Whether cells resolve a crack (docs/reference/warnings-of-cracks-and-runs.md).

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/CrackExtent.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <vector>

namespace Rhegma::cracks
{

/// Warns of cracks with a front that extend over fewer than three cells, in 3D behind any point of it. \param
/// cellAtFronts edge at fronts, once refined [m]; where cells are smaller than that already, theirs counts
template <int D>
void judgeLengths(double cellAtFronts, State<D>& state)
{
  constexpr double fewest = 3.0,
                   polygon = 0.01; // round parts from files are polygons inside of their circles
  std::vector<double> cells(state.cracks.cracks.size(), 0.0); // the largest at a front of each crack
  for (const CrackFront<D>& front : state.cracks.fronts)
    cells[front.crack] =
        std::max(cells[front.crack], std::min(cellAtFronts, spacingAt(state, front.position)));
  for (std::size_t c = 0; c < state.cracks.cracks.size(); ++c)
    if (const double length = extentOf(state, static_cast<int>(c)), cell = cells[c];
        length < (fewest - polygon) * cell)
      state.warnings.push_back(
          "Cracks > " + state.cracks.cracks[c].name + ": it extends over " + readableLength(length) +
          " inside the bodies, " + formatShort(length / cell) + " cells of " + readableLength(cell) +
          (length < (1.0 - 1e-6) * cell
               ? "; below one cell its opening, G and K are meaningless"
               : "; below three cells its opening, G and K can be wrong by 20 % or more") +
          ": use smaller cells (Domain > Cell Size), or check its size (metres)");
}

} // namespace Rhegma::cracks
