#pragma once
/// Supports that no body touches, or that bodies leave (docs/reference/warnings.md).

#include "boundary/Supports.hpp"

#include <Teuchos_ParameterList.hpp>

namespace Rhegma
{

/// Warns of each support that holds no node of a body and that none can come to: bodies move by no more than
/// their velocity, that of supports, and gravity allow. Warns also of each that is to move a body, but whose
/// box contains only nodes at its surface and no particle, so that the box stays where it is. Call it before
/// particles are divided among ranks.
template <int D>
void warnOfIdleSupports(const Teuchos::ParameterList& scene,
                        const std::vector<TimedConstraint<D>>& constraints, State<D>& state);

} // namespace Rhegma
