#pragma once
/// Rows of numbers from each rank to others.

#include "parallel/Ranks.hpp"

#include <vector>

namespace Rhegma
{

/// Sends row i, `width` numbers, to rank to[i]. Collective. \return the rows that came, one after another; in
/// the order in which they were sent where there is one rank
std::vector<double> sendRows(const Ranks& ranks, const std::vector<int>& to, const std::vector<double>& rows,
                             int width);

} // namespace Rhegma
