#pragma once
/// The views and the connectivity that a transfer takes, fetched from the state.

#include "state/State.hpp"
#include "transfer/Connectivity.hpp"

namespace Rhegma
{

/// The policy of transfers for the particles as they are now.
template <int D, ShapeKind S, bool Stored>
Connectivity<D, S, Stored> connectivity(const State<D>& state)
{
  Connectivity<D, S, Stored> c;
  c.grid = state.grid;
  c.position = state.particles.template real<D>(fields::position);
  if (S == ShapeKind::Gimp)
    c.box = state.particles.template real<D>(fields::box);
  if (Stored)
  {
    c.row = state.storedRow;
    c.table = state.stored;
  }
  return c;
}

/// Calls work(connectivity) with the shape functions of the scene, and with stored stencils where a cut needs
/// them.
template <int D, class Work>
void withConnectivity(const State<D>& state, const Work& work)
{
  const bool stored = state.numStored > 0;
  if (state.shape == ShapeKind::Linear)
    stored ? work(connectivity<D, ShapeKind::Linear, true>(state))
           : work(connectivity<D, ShapeKind::Linear, false>(state));
  else
    stored ? work(connectivity<D, ShapeKind::Gimp, true>(state))
           : work(connectivity<D, ShapeKind::Gimp, false>(state));
}

} // namespace Rhegma
