#include "transfer/StrainAndMove.hpp"

namespace Rhegma::detail
{

template <int D>
double strainAndMoveHeated(State<D>& state, StrainVelocity velocity, bool strain, bool move)
{
  return strainAndMoveAll<ParticleHeat>(state, velocity, strain, move);
}

template double strainAndMoveHeated(State<2>&, StrainVelocity, bool, bool);
template double strainAndMoveHeated(State<3>&, StrainVelocity, bool, bool);

} // namespace Rhegma::detail
