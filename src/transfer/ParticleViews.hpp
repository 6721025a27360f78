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
  c.grid = state.mesh.grid;
  c.position = state.particles.template real<D>(fields::position);
  if (S == ShapeKind::Gimp)
    c.box = state.particles.template real<D>(fields::box);
  if (Stored)
  {
    c.row = state.stored.row;
    c.table = state.stored.table;
  }
  return c;
}

/// Calls work(connectivity) with the shape functions of the scene, and with stored stencils where a cut needs
/// them.
template <int D, class Work>
void withConnectivity(const State<D>& state, const Work& work)
{
  const bool stored = state.stored.count > 0;
  if (state.method.shape == ShapeKind::Linear)
    stored ? work(connectivity<D, ShapeKind::Linear, true>(state))
           : work(connectivity<D, ShapeKind::Linear, false>(state));
  else
    stored ? work(connectivity<D, ShapeKind::Gimp, true>(state))
           : work(connectivity<D, ShapeKind::Gimp, false>(state));
}

} // namespace Rhegma
