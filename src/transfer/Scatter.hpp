#pragma once
/// Particles to nodes.

#include "state/State.hpp"

namespace Rhegma
{

/// What a scatter adds to the nodes.
enum class ScatterWhat
{
  MassAndMomentum,
  Force,
  All
};

/// Zeroes mass, momentum, force and projection of the nodes in use.
template <int D>
void clearNodes(State<D>& state);

/// Zeroes the projection alone, for another one in the same step.
template <int D>
void clearProjection(State<D>& state);

/// Adds to the nodes: mass [kg] and momentum [kg m/s] of the particles, and/or their internal force
/// -V0 tau . grad N [N], tau the Kirchhoff stress and V0 the undeformed volume.
///
/// Total mass and momentum are kept, internal forces sum to zero, to round-off (weights sum to one, slopes to
/// zero). Source: Sulsky, Chen and Schreyer, Comput. Methods Appl. Mech. Engrg. 118 (1994) 179.
template <int D>
void scatter(State<D>& state, ScatterWhat what);

} // namespace Rhegma
