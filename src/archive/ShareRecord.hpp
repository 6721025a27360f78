#pragma once
/// A record that one rank holds, for all.

#include "archive/Record.hpp"
#include "parallel/Ranks.hpp"

namespace Rhegma
{

/// Gives all ranks the record of the first; what others had is dropped. Tables go one after another, so that
/// no message is longer than the longest of them. Collective.
void shareRecord(const Ranks& ranks, Record& record);

} // namespace Rhegma
