#pragma once
/// What a crack does to a stencil: second fields, broken cells, or broken cells with extrapolation.

#include "state/State.hpp"

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
/// Dual field: an invisible node is replaced by its second field: linearly complete
/// (Nairn, CMES 4 (2003) 649, with one field a side).
/// Broken cell: N~(n,p) = Vis [N + sum_m N_m (1 - Vis_m) / S_vis], S_vis the number of visible nodes around p
/// (Nairn and Tan, C-SAFE report, equations 1 to 3). Sums to one; not linearly complete.
/// Corrected broken cell: N~(n,p) = Vis N_n + sum over invisible m of N_m E_mn, with E_mn the linear
/// extrapolation from the two nearest nodes beyond m on the point's side, along the axis closest to the
/// crack's normal: linearly complete. A point that sees no node keeps its stencil, so that its mass is not
/// lost.
void editStencils(const State<2>& state, Formulation formulation, const ObservedPoints<2>& points,
                  const StencilTable<2>& table);

} // namespace Rhegma::cracks
