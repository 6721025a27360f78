#pragma once
/// The cells that hold particles, as a mesh.

#include "output/Snapshot.hpp"
#include "state/State.hpp"

namespace Rhegma
{

/// Leaves with particles in them: quadrilaterals, counter-clockwise, or hexahedra, lower face first, with
/// their level; each corner is one point.
template <int D>
OutputMesh cellMesh(const State<D>& state);

} // namespace Rhegma
