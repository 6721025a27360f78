#pragma once
/// Cells that become smaller and larger by themselves, and particles with them.

#include "plan/Effect.hpp"

namespace Rhegma::adaptivity
{

/// The section `Adaptivity`: a tree of cells in each cell of the lattice, refined near crack fronts, where
/// the velocity varies much over a cell, and in given boxes; particles split and merge with the cells.
/// Source: Nairn and Tan's report; shape functions on the tree: Tree.hpp.
EffectEntry adaptivityEntry();

} // namespace Rhegma::adaptivity
