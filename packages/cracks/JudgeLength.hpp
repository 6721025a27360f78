#pragma once
/// Whether cells resolve a crack (docs/reference/warnings-of-cracks-and-runs.md).

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/CrackExtent.hpp"

#include <vector>

namespace Rhegma::cracks
{

/// Warns of cracks with a front that extend over fewer than three cells, in 3D behind any point of it. \param
/// cell edge at fronts, once refined [m]
template <int D>
void judgeLengths(double cell, State<D>& state)
{
  constexpr double fewest = 3.0;
  std::vector<bool> hasFront(state.cracks.cracks.size(), false);
  for (const CrackFront<D>& front : state.cracks.fronts)
    hasFront[front.crack] = true;
  for (std::size_t c = 0; c < state.cracks.cracks.size(); ++c)
    if (const double length = extentOf(state, static_cast<int>(c));
        hasFront[c] && length < (fewest - 1e-6) * cell)
      state.warnings.push_back(
          "Cracks > " + state.cracks.cracks[c].name + ": it extends over " + readableLength(length) +
          " inside the bodies, " + formatShort(length / cell) + " cells of " + readableLength(cell) +
          (length < (1.0 - 1e-6) * cell
               ? "; below one cell its opening, G and K are meaningless"
               : "; below three cells its opening, G and K can be wrong by 20 % or more") +
          ": use smaller cells (Domain > Cell Size), or check its size (metres)");
}

} // namespace Rhegma::cracks
