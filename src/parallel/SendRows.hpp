#pragma once
/// Rows of numbers from each rank to others.

#include "parallel/Ranks.hpp"

#include <vector>

namespace Rhegma
{

/// Sends row i, `width` numbers, to rank to[i]. Collective. \return the received rows one after another; with
/// one rank in the order in which they were sent
std::vector<double> sendRows(const Ranks& ranks, const std::vector<int>& to, const std::vector<double>& rows,
                             int width);

} // namespace Rhegma
