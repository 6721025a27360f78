#pragma once
/// Cracks in checkpoints.

#include "state/State.hpp"

namespace Rhegma
{
class Archive;
}

namespace Rhegma::cracks
{

/// Saves or loads the vertices and simplices of the cracks, their fronts and the history of these.
template <int D>
void storeCracks(State<D>& state, Archive& archive);

} // namespace Rhegma::cracks
