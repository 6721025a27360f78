#pragma once
/// States whose fields are written.

#include "SmallState.hpp"

namespace Rhegma
{

/// Two particles in two cells that share an edge.
inline State<2> twoParticles()
{
  State<2> state = smallState<2>(2);
  fill(state.particles.table(fields::position), {0.25, 0.5, 1.5, 0.75});
  fill(state.particles.table(fields::reference), {0.0, 0.5, 1.5, 0.25});
  fill(state.particles.table(fields::velocity), {1.0, 2.0, 3.0, 4.0});
  // Stretch 2 and 1: J = 2 and 1.
  fill(state.particles.table(fields::deformation), {2, 0, 0, 1, 1, 1, 0, 0, 1, 1});
  fill(state.particles.table(fields::stress), {20.0, 40.0, 60.0, 80.0, 0.0, 0.0, 5.0, 0.0});
  fill(state.particles.integer(fields::body), {0, 1});
  return state;
}

/// A crack of two segments, open by 0.1 at its surface-breaking end.
inline void addCrack(State<2>& state)
{
  CrackSet<2>& set = state.cracks;
  set.cracks.push_back({"Notch", 0, 3, 0, 2});
  set.vertex = View<double* [2]>("vertex", 3);
  set.face = View<double* [2][2]>("face", 3);
  set.simplex = View<int* [2]>("simplex", 2);
  set.crackOf = View<int*>("crackOf", 2);
  fillView<decltype(set.vertex), double>(set.vertex, {0, 1, 1, 1, 2, 1});
  fillView<decltype(set.face), double>(set.face, {0, 0.95, 0, 1.05, 1, 0.98, 1, 1.02, 2, 1, 2, 1});
  fillView<decltype(set.simplex), int>(set.simplex, {0, 1, 1, 2});
}

} // namespace Rhegma
