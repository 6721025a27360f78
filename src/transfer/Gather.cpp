#include "transfer/StrainAndMove.hpp"

namespace Rhegma
{

template <int D>
double strainAndMove(State<D>& state, StrainVelocity velocity, bool strain, bool move)
{
  return state.materials.thermo.empty()
             ? detail::strainAndMoveAll<detail::NoHeat>(state, velocity, strain, move)
             : detail::strainAndMoveHeated(state, velocity, strain, move);
}

template double strainAndMove(State<2>&, StrainVelocity, bool, bool);
template double strainAndMove(State<3>&, StrainVelocity, bool, bool);

} // namespace Rhegma
