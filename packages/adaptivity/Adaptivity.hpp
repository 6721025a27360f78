#pragma once
/// Adaptive mesh refinement: cells are refined and coarsened during the run, and particles with them.

#include "plan/Effect.hpp"

namespace Rhegma::adaptivity
{

/// The section `Adaptivity`: a tree of cells in each cell of the lattice, refined near crack fronts, where
/// the velocity or the temperature varies much over a cell, and in given boxes; particles split and merge
/// with the cells. Source: Nairn and Tan's report; shape functions on the tree: Tree.hpp.
EffectEntry adaptivityEntry();

} // namespace Rhegma::adaptivity
