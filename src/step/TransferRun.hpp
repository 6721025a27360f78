#pragma once
/// The state of a run as another run goes on from it.

#include "archive/Record.hpp"
#include "step/Run.hpp"

namespace Rhegma
{

/// All persistent data of a run, on all of its ranks. Collective.
template <int D>
Record recordOf(Run<D>& run);

/// Loads what another run has stored. Collective over the ranks of this one. \param run after initialize(),
/// of the same cells and particles \param record the same on all ranks
template <int D>
void loadRecord(const Record& record, Run<D>& run);

} // namespace Rhegma
