#pragma once
/// The material left ahead of fronts at the end of a run.

#include "boundary/MirrorPlanes.hpp"
#include "state/State.hpp"

#include <nlohmann/json.hpp>

namespace Rhegma::cracks
{

/// Adds to the entry of each front the length of the material ahead of it, where that is less than three
/// cells [m], else null, and warns of fronts that have grown and do not run: fewer cells neither bend nor
/// strain as the material does. Up to a plane of symmetry, behind which another front comes, it is twice the
/// distance. In 3D no front nodes count that are less than three cells from where the front ends at the
/// surface, along which they point. Collective.
template <int D>
void reportLigaments(const State<D>& state, const std::vector<MirrorPlane>& mirrors, nlohmann::json& summary);

} // namespace Rhegma::cracks
