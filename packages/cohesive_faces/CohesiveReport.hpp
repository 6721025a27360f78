#pragma once
/// What runs report of cohesive faces.

#include "cohesive_faces/FaceCohesion.hpp"
#include "state/State.hpp"

#include <nlohmann/json.hpp>

namespace Rhegma::cohesive_faces
{

/// Adds the columns of history.csv. \param laws of each crack
template <int D>
void sampleCohesion(State<D>& state, const FaceCohesion<D>& cohesion, const std::vector<TractionLaw>& laws);

/// Adds `cohesive` to the cracks of summary.json.
template <int D>
void reportCohesion(const FaceCohesion<D>& cohesion, const std::vector<TractionLaw>& laws,
                    nlohmann::json& summary);

} // namespace Rhegma::cohesive_faces
