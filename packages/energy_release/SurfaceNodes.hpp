#pragma once
/// Nodes of fronts near the surface of the body, where G of a front depends on the cells.

#include "state/State.hpp"

#include <Teuchos_ParameterList.hpp>

#include <nlohmann/json.hpp>

#include <vector>

namespace Rhegma::energy_release
{

/// A plane of symmetry: where a front ends at it, it goes on beyond.
struct MirrorPlane
{
  int axis = 0;          ///< its normal
  double position = 0.0; ///< along the axis [m]
};

/// The planes of symmetry among the boundaries of a scene.
std::vector<MirrorPlane> mirrorPlanes(const Teuchos::ParameterList& scene);

/// Not 0 for the nodes of a front that are less than two cells along it from where it meets the surface of
/// the body; none in 2D, and none of a front that has no other nodes.
template <int D>
std::vector<char> nodesAtSurface(const State<D>& state, const CrackFront<D>& front,
                                 const std::vector<MirrorPlane>& mirrors);

/// Adds `at_surface` to `front_nodes` of the entry of a front in 3D: a boolean for each front node.
template <int D>
void reportNodesAtSurface(const State<D>& state, const CrackFront<D>& front,
                          const std::vector<MirrorPlane>& mirrors, nlohmann::json& entry);

} // namespace Rhegma::energy_release
