#pragma once
/// Report of each body.

#include "state/State.hpp"

#include <cstddef>
#include <limits>
#include <nlohmann/json_fwd.hpp>

namespace Rhegma
{

/// `bodies` of summary.json: for each body its name, mass [kg], centre of mass [m], velocity of that [m/s],
/// mean stress
/// (`stress`, Cauchy, over the volume now [Pa]) and mean deformation gradient (`deformation`, over the
/// undeformed volume; of a bar, the stretch from end to end), by component: xx, yy, ...
///
/// Sums over the particles at the call; reads position, velocity, mass, initial volume, deformation gradient,
/// stress. \param most bodies that are reported: the first ones
template <int D>
void bodyReport(const State<D>& state, nlohmann::json& summary,
                std::size_t most = std::numeric_limits<std::size_t>::max());

} // namespace Rhegma
