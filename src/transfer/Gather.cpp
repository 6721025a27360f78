#include "transfer/StrainAndMove.hpp"
#include "transfer/StressInBlocks.hpp"

#include <algorithm>

namespace Rhegma
{

template <int D>
double strainAndMove(State<D>& state, StrainVelocity velocity, bool strain, bool move)
{
  if (!state.materials.thermo.empty())
    return detail::strainAndMoveHeated(state, velocity, strain, move);
  View<double * [gradientSize<D>]> before;
  if (strain)
    before = deformationBefore(state);
  const double fastest = detail::strainAndMoveAll<detail::NoHeat>(state, velocity, strain, move);
  if (before.extent(0) == 0 || !std::isfinite(fastest))
    return fastest;
  const double duration = state.clock.strainPass.fraction * state.clock.dt;
  return std::max(fastest, stressInBlocks(state, before, duration));
}

template double strainAndMove(State<2>&, StrainVelocity, bool, bool);
template double strainAndMove(State<3>&, StrainVelocity, bool, bool);

} // namespace Rhegma
