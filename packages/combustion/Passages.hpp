#pragma once
/// Where cracks have met and their gases flow into each other.

#include "combustion/BurnState.hpp"

namespace Rhegma::combustion
{

/// Follows which cracks have met. Gases of one pressure, of the same R, gamma and covolume, flow into each
/// other from then on; of other gases a warning says once that they stay apart. Only the ends of fronts are
/// checked, and only when one more has ended.
template <int D>
void updateMeetings(State<D>& state, BurnState<D>& burn);

/// Lets gas flow through the openings where cracks have met, after it has burnt and done its work in this
/// step. All ranks find the same.
template <int D>
void letGasesPass(const State<D>& state, BurnState<D>& burn);

} // namespace Rhegma::combustion
