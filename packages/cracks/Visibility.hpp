#pragma once
/// How a crack changes a stencil: enriched fields, broken cells, or broken cells with extrapolation.

#include "cracks/Ghosts.hpp"

namespace Rhegma::cracks
{

enum class Formulation
{
  DualField,
  BrokenCell,
  CorrectedBrokenCell
};

/// Edits stencils of points near cracks.
///
/// A node is invisible from a point if both are on different sides of a crack and the node lies behind its
/// front (the node rule: a test of segments that cross would cut wrongly at the front).
///
/// Dual field: an invisible node is replaced by its enriched field: linearly complete (Nairn, CMES 4 (2003)
/// 649, with one field a side). Broken cell: N~(n,p) = Vis [N + sum_m N_m (1 - Vis_m) / S_vis], S_vis the
/// number of visible nodes around p (Nairn and Tan, C-SAFE report, equations 1 to 3). Sums to one; not
/// linearly complete. The nodes around p are the corners of its cell, also with GIMP, where counting every
/// node that a box touches would make the functions jump as soon as it touches one more. A point that sees no
/// corner distributes to the other nodes that it sees; one that sees none keeps its stencil, so that its mass
/// is not lost. Corrected broken cell: N~(n,p) = Vis N_n + sum over invisible m of N_m E_mn, with E_mn the
/// linear extrapolation from the two nearest nodes beyond m on the point's side, along the axis closest to
/// the crack's normal: linearly complete (Ghosts.hpp). Where three nodes on are still invisible, the point
/// keeps the node.
///
/// \param ghosts stand-ins of invisible nodes; only the corrected broken cell reads them
template <int D>
void editStencils(const State<D>& state, Formulation formulation, const Ghosts& ghosts,
                  const ObservedPoints<D>& points, const StencilTable<D>& table);

} // namespace Rhegma::cracks
