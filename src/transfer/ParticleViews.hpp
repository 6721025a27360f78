#pragma once
/// The connectivity of transfers, made from the state.

#include "state/State.hpp"
#include "transfer/Connectivity.hpp"

namespace Rhegma
{

/// The policy of transfers for the current particles.
template <int D, ShapeKind S, bool Stored, ShearStrain H = ShearStrain::AtParticles>
Connectivity<D, S, Stored, H> connectivity(const State<D>& state)
{
  Connectivity<D, S, Stored, H> c;
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

/// Calls visit(connectivity) with the shape functions of the scene, and with stored stencils where a cut
/// needs them.
template <ShearStrain H = ShearStrain::AtParticles, int D, class Visit>
void withConnectivity(const State<D>& state, const Visit& visit)
{
  const bool stored = state.stored.count > 0;
  if (state.method.shape == ShapeKind::Linear)
    stored ? visit(connectivity<D, ShapeKind::Linear, true, H>(state))
           : visit(connectivity<D, ShapeKind::Linear, false, H>(state));
  else
    stored ? visit(connectivity<D, ShapeKind::Gimp, true, H>(state))
           : visit(connectivity<D, ShapeKind::Gimp, false, H>(state));
}

/// The same for transfers of strain to particles and of their stress to nodes, with the slopes that the scene
/// chooses for them.
template <int D, class Visit>
void withStraining(const State<D>& state, const Visit& visit)
{
  if (state.method.shear == ShearStrain::AtCellCentres)
    withConnectivity<ShearStrain::AtCellCentres>(state, visit);
  else
    withConnectivity(state, visit);
}

} // namespace Rhegma
