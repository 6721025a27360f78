#pragma once
/// How far a crack is open.

#include "state/CrackSet.hpp"

#include <cstddef>
#include <vector>

namespace Rhegma::cracks
{

struct Opening
{
  double largest;      ///< of the vertices, along the normal [m]
  double smallest;     ///< of the vertices, negative where the faces overlap [m]
  double volume;       ///< between the faces, negative where they overlap; an area in 2D [m2, m3]
  double size;         ///< length or area of the crack now [m, m2]
  double closed = 0.0; ///< of that the part whose faces overlap by more than a distance [m, m2]
};

/// Adds up the opening of a crack that is linear between its vertices, and in 2D grows as the root of the
/// distance from a front. \param overlap the distance of `closed` [m]
template <int D>
Opening measureOpening(const CrackSet<D>& cracks, int crack, double overlap = 0.0);

/// That of each crack, in their order.
template <int D>
std::vector<Opening> openingsOf(const CrackSet<D>& cracks)
{
  std::vector<Opening> openings;
  for (std::size_t c = 0; c < cracks.cracks.size(); ++c)
    openings.push_back(measureOpening(cracks, static_cast<int>(c)));
  return openings;
}

} // namespace Rhegma::cracks
