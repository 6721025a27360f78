#pragma once
/// The modes of shear at a front next to its opening mode.

#include "energy_release/FrontSample.hpp"
#include "energy_release/SurfaceNodes.hpp"
#include "state/State.hpp"

#include <nlohmann/json.hpp>

#include <vector>

namespace Rhegma::energy_release
{

/// Adds `K_II_over_K_I` to the entry of a front, in 3D also `K_III_over_K_I`: of the node with the largest G
/// that is not at the surface, signed; null where the faces do not open there (K_I is not positive), or
/// nothing is known.
template <int D>
void reportModeRatios(const State<D>& state, const FrontSample<D>& sample,
                      const std::vector<MirrorPlane>& mirrors, nlohmann::json& entry);

} // namespace Rhegma::energy_release
