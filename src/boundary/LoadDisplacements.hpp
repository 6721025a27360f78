#pragma once
/// How far loads move in equilibrium, for curves of force against displacement.

#include "boundary/Loads.hpp"
#include "plan/Effect.hpp"

#include <Teuchos_ParameterList.hpp>

#include <memory>
#include <vector>

namespace Rhegma
{

/// The calls that report the mean displacement of each load along its direction since the start [m]: the one
/// with which its force does its work. \param scene its core Adds to what the effect reports and remembers
template <int D>
void addLoadDisplacements(Effect<D>& effect, const Teuchos::ParameterList& scene,
                          const std::shared_ptr<std::vector<Load<D>>>& loads);

} // namespace Rhegma
