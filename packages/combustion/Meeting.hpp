#pragma once
/// Where one crack has ended on another.

#include "state/CrackSet.hpp"

#include <vector>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::combustion
{

/// An end of a crack that lies on another one; where two fronts have met, on the end of that.
struct Meeting
{
  int crack = 0, end = 0;       ///< the crack that has ended, at its first end (0) or its last
  int other = 0, otherEnd = -1; ///< the one on which it lies, and which end of that; -1: between its ends
  bool reported = false;        ///< a warning has said that their gases stay apart
};

/// All meetings of a scene; two ends that have met count once. \param reach largest distance of two ends that
/// have met [m]
std::vector<Meeting> findMeetings(const CrackSet<2>& cracks, double reach);
/// None: no crack ends on another in 3D.
std::vector<Meeting> findMeetings(const CrackSet<3>& cracks, double reach);

/// Saves or loads them.
void storeMeetings(std::vector<Meeting>& meetings, Archive& archive);

} // namespace Rhegma::combustion
