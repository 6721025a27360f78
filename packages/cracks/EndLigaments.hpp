#pragma once
/// The material left ahead of fronts at the end of a run.

#include "boundary/MirrorPlanes.hpp"
#include "state/State.hpp"

#include <nlohmann/json.hpp>

namespace Rhegma::cracks
{

/// Adds to the entry of each front that has grown the length of the material ahead of it [m], else null, and
/// warns of fronts that do not run and have less than ten cells of it: fewer do not bend as the material
/// does. Measured with an edge crack of 20 cells in tension against Tada, Paris and Irwin, The Stress
/// Analysis of Cracks Handbook: loads at which it grows are too high by 1, 4.5, 8 and 9 to 22 % with 9.5, 8,
/// 7 and 6 cells. Up to a plane of symmetry, behind which another front comes, it is twice the distance. In
/// 3D no front nodes count that are less than three cells from where the front ends at the surface, along
/// which they point. Another crack within a tenth of a cell of the path ends the ligament. Collective.
template <int D>
void reportLigaments(const State<D>& state, const std::vector<MirrorPlane>& mirrors, nlohmann::json& summary);

} // namespace Rhegma::cracks
