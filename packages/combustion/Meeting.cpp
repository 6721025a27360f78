#include "combustion/Meeting.hpp"

#include "archive/Archive.hpp"
#include "combustion/Cavity.hpp"

#include <limits>

namespace Rhegma::combustion
{

namespace
{

/// An end of a crack that lies on another one.
struct JoinedEnd
{
  int crack, end;
  Vector<2> position;
};

std::vector<JoinedEnd> joinedEnds(const CrackSet<2>& cracks)
{
  const auto neighbour = onHost(cracks.neighbour);
  const auto vertex = onHost(cracks.vertex);
  std::vector<JoinedEnd> ends;
  ends.reserve(2 * cracks.cracks.size());
  for (std::size_t c = 0; c < cracks.cracks.size(); ++c)
  {
    const Crack<2>& crack = cracks.cracks[c];
    const int last = crack.numSimplices - 1;
    const int beyond[2] = {neighbour(crack.firstSimplex, 1), neighbour(crack.firstSimplex + last, 0)};
    for (int end = 0; end < 2; ++end)
    {
      const int v = crack.firstVertex + (end == 0 ? 0 : crack.numVertices - 1);
      if (beyond[end] == facet::joined)
        ends.push_back({static_cast<int>(c), end, {vertex(v, 0), vertex(v, 1)}});
    }
  }
  return ends;
}

/// The crack that is nearest to such an end, its own left out.
int crackAt(const CrackSet<2>& cracks, const JoinedEnd& end)
{
  int nearest = -1;
  double least = std::numeric_limits<double>::max();
  for (std::size_t c = 0; c < cracks.cracks.size(); ++c)
  {
    if (static_cast<int>(c) == end.crack)
      continue;
    const double distance = distanceFromCrack(cracks, static_cast<int>(c), end.position, end.position);
    if (distance < least)
    {
      least = distance;
      nearest = static_cast<int>(c);
    }
  }
  return nearest;
}

} // namespace

std::vector<Meeting> findMeetings(const CrackSet<2>& cracks, double reach)
{
  const std::vector<JoinedEnd> ends = joinedEnds(cracks);
  std::vector<Meeting> all;
  all.reserve(ends.size());
  for (const JoinedEnd& end : ends)
  {
    Meeting meeting{end.crack, end.end, crackAt(cracks, end)};
    for (const JoinedEnd& other : ends)
      if (other.crack == meeting.other && norm(other.position - end.position) < reach &&
          crackAt(cracks, other) == end.crack)
        meeting.otherEnd = other.end;
    if (meeting.otherEnd < 0 || meeting.crack < meeting.other)
      all.push_back(meeting);
  }
  return all;
}

std::vector<Meeting> findMeetings(const CrackSet<3>&, double) { return {}; }

void storeMeetings(std::vector<Meeting>& meetings, Archive& archive)
{
  constexpr int columns = 5;
  std::vector<int> rows;
  rows.reserve(columns * meetings.size());
  for (const Meeting& m : meetings)
    rows.insert(rows.end(), {m.crack, m.end, m.other, m.otherEnd, m.reported ? 1 : 0});
  archive("meetings", rows, columns);
  meetings.clear();
  for (std::size_t k = 0; k < rows.size(); k += columns)
    meetings.push_back({rows[k], rows[k + 1], rows[k + 2], rows[k + 3], rows[k + 4] != 0});
}

} // namespace Rhegma::combustion
