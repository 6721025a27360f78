#include "cracks/IdleCracks.hpp"

#include "state/Subdomain.hpp"

namespace Rhegma::cracks
{

template <int D>
void warnOfIdleCracks(State<D>& state)
{
  const auto side = onHost(state.particles.integer(fields::side));
  const std::size_t cracks = state.cracks.cracks.size();
  std::vector<double> adjacent(2 * cracks, 0.0); // whether there are particles on side +1 and side -1 of each
  for (int p = 0; p < state.particles.size(); ++p)
  {
    if (side(p) > 0)
      adjacent[2 * (side(p) - 1)] = 1.0;
    if (side(p) < 0)
      adjacent[2 * (-side(p) - 1) + 1] = 1.0;
  }
  maxParts(state, adjacent.data(), static_cast<int>(adjacent.size()));
  for (std::size_t c = 0; c < cracks; ++c)
    if (adjacent[2 * c] * adjacent[2 * c + 1] == 0.0)
      state.warnings.push_back(
          "Cracks > " + state.cracks.cracks[c].name +
          ": it separates nothing, because there are no particles on one of its sides: it is too short or "
          "too close to a surface; use smaller cells (Domain > Cell Size)");
}

template void warnOfIdleCracks(State<2>&);
template void warnOfIdleCracks(State<3>&);

} // namespace Rhegma::cracks
