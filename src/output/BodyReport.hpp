#pragma once
/// Report of each body.

#include "state/State.hpp"

#include <nlohmann/json_fwd.hpp>

namespace Rhegma
{

/// `bodies` of summary.json: for each body its name, mass [kg], centre of mass [m], velocity of that [m/s],
/// mean stress
/// (`stress`, Cauchy, over the volume now [Pa]) and mean deformation gradient (`deformation`, over the
/// undeformed volume; of a bar, the stretch from end to end), by component: xx, yy, ...
///
/// Sums over the particles at the call; reads position, velocity, mass, initial volume, deformation gradient,
/// stress.
template <int D>
void bodyReport(const State<D>& state, nlohmann::json& summary);

} // namespace Rhegma
