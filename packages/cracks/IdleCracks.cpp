#include "cracks/IdleCracks.hpp"

namespace Rhegma::cracks
{

template <int D>
void warnOfIdleCracks(State<D>& state)
{
  const auto side =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.particles.integer(fields::side));
  const std::size_t cracks = state.cracks.cracks.size();
  std::vector<bool> above(cracks, false), below(cracks, false);
  for (int p = 0; p < state.particles.size(); ++p)
  {
    if (side(p) > 0)
      above[side(p) - 1] = true;
    if (side(p) < 0)
      below[-side(p) - 1] = true;
  }
  for (std::size_t c = 0; c < cracks; ++c)
    if (!above[c] || !below[c])
      state.warnings.push_back(
          "Cracks > " + state.cracks.cracks[c].name +
          ": it parts nothing, as there are no particles on one of its sides: it is too short "
          "or too close to a surface for the cells; take smaller ones (Domain > Cell Size)");
}

template void warnOfIdleCracks(State<2>&);
template void warnOfIdleCracks(State<3>&);

} // namespace Rhegma::cracks
