#pragma once
/// Crack normals stored by particles.

#include "state/State.hpp"

namespace Rhegma::cracks
{

/// Field of the outward unit normal of the face near a particle; zero away from cracks.
inline const std::string crackNormal = "crack normal";

/// Gives each particle near a crack the unit normal of the face on its side, out of its material towards the
/// other face (Nairn and Tan, C-SAFE report, figure 3). The normal turns with the crack. Normals of other
/// particles do not change: zero until a crack comes near. \param row 0 for particles near cracks that have a
/// side, as findSides marks them
void updateNormals(const State<2>& state, const View<int*>& row);

} // namespace Rhegma::cracks
