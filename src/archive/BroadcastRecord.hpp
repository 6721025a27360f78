#pragma once
/// Copies the record of the first rank to all ranks.

#include "archive/Record.hpp"
#include "parallel/Ranks.hpp"

namespace Rhegma
{

/// Replaces the record of all ranks by that of the first. Tables are sent one after another, so that no
/// message is longer than the largest table. Collective.
void broadcastRecord(const Ranks& ranks, Record& record);

} // namespace Rhegma
