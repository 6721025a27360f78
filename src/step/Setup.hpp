#pragma once
/// From a validated scene to the state before the first step.

#include "geometry/Seeds.hpp"
#include "plan/Effect.hpp"

namespace Rhegma
{

/// Grid, materials and particles of a scene, with the fields of the method itself.
///
/// \param extra fields that effects add
/// \param isDivided of the cells that are refined at the start, to which particles at edges of bodies are
/// cut; empty: none Throws std::invalid_argument, with the path of the section, where a body has no particle
/// or a particle would start outside of the domain.
template <int D>
void makeState(const Teuchos::ParameterList& scene, const std::vector<Field>& extra, State<D>& state,
               const IsDivided<D>& isDivided = {});

} // namespace Rhegma
