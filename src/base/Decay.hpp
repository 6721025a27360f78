#pragma once
/// What an oscillation that decays, or an approach to a limit, still has before it.

#include <vector>

namespace Rhegma
{

/// How far the last of a series of values may still move: over what range it moves in each of its last two
/// quarters, and how that decays. Of an oscillation that is a bound, up to some three times of what it then
/// does; of a monotone approach all that is left (Aitken).
/// \param values taken at equal intervals, in any unit
/// \return in their unit; not a number where there are fewer than 12 of them
double remainingChange(const std::vector<double>& values);

/// Intervals until the envelope of a series of positive values falls to a limit, if it goes on to decay as in
/// the last two quarters of the series. \return infinity where it does not decay, or of fewer than 12 values
double intervalsUntil(const std::vector<double>& values, double limit);

/// The same for the range over which the values move, as a fraction of the last one.
double intervalsUntilStill(const std::vector<double>& values, double fraction);

} // namespace Rhegma
