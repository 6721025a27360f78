#pragma once
/// From the scene's points to cracks in the state.

#include "step/Effect.hpp"

namespace Rhegma::cracks
{

/// Reads the cracks of a 2D scene into state.cracks: clips them to the bodies, splits long segments, and
/// finds which ends are fronts (material ahead of them) and which are mouths.
///
/// Throws std::invalid_argument, with the section's path, for a crack that lies outside of all bodies, has no
/// length, or comes closer than three cells to another.
void readCracks(const Teuchos::ParameterList& section, State<2>& state);

/// Places, directions, normals and lengths of the fronts from the vertices as they are now.
void updateFronts(CrackSet<2>& cracks);

} // namespace Rhegma::cracks
