#pragma once
/// From a validated scene to the state before the first step.

#include "geometry/Seeds.hpp"
#include "plan/Effect.hpp"

namespace Rhegma
{

/// What divides particles at the start, once there is a lattice.
template <int D>
using RulesOfSeeds = std::function<SeedRules<D>(const State<D>&)>;

/// Grid, materials and particles of a scene, with the fields of the method itself.
///
/// \param extra fields that effects add
/// \param rules empty: particles at edges of bodies alone are parts of lattice cells
///
/// Throws std::invalid_argument, with the path of the section, where a body has no particle
/// or a particle would start outside of the domain.
template <int D>
void makeState(const Teuchos::ParameterList& scene, const std::vector<Field>& extra, State<D>& state,
               const RulesOfSeeds<D>& rules = {});

} // namespace Rhegma
