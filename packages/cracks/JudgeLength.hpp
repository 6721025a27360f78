#pragma once
/// Whether cells resolve a crack (docs/plausibility.md).

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "state/State.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::cracks
{

/// Warns of cracks with a front that extend over fewer than three cells. \param cell edge at fronts, once
/// refined [m]
template <int D>
void judgeLengths(double cell, State<D>& state)
{
  constexpr double fewest = 3.0;
  std::vector<bool> hasFront(state.cracks.cracks.size(), false);
  for (const CrackFront<D>& front : state.cracks.fronts)
    hasFront[front.crack] = true;
  const auto x = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.cracks.vertex);
  for (std::size_t c = 0; c < state.cracks.cracks.size(); ++c)
  {
    const Crack<D>& crack = state.cracks.cracks[c];
    if (!hasFront[c])
      continue;
    Vector<D> low, high;
    for (int d = 0; d < D; ++d)
    {
      low[d] = high[d] = x(crack.firstVertex, d);
      for (int v = crack.firstVertex; v < crack.firstVertex + crack.numVertices; ++v)
      {
        low[d] = std::min(low[d], x(v, d));
        high[d] = std::max(high[d], x(v, d));
      }
    }
    if (const double length = norm(high - low); length < (fewest - 1e-6) * cell)
      state.warnings.push_back("Cracks > " + crack.name + ": it extends over " + readableLength(length) +
                               " inside the bodies, " + formatShort(length / cell) + " cells of " +
                               readableLength(cell) +
                               "; below three cells its opening, G and K are meaningless: use smaller cells "
                               "(Domain > Cell Size), or check its size (metres)");
  }
}

} // namespace Rhegma::cracks
