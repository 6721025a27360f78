#pragma once
/// How much material is ahead of the stations of a front.

#include "state/State.hpp"

#include <vector>

namespace Rhegma::cracks
{

/// A straight way from a place.
struct Way
{
  Vector<3> from;      ///< [m]
  Vector<3> direction; ///< unit vector
  double length;       ///< [m]
};

/// How far each way goes through material, to a forty-eighth of its length: as in 2D, as far as every place
/// on it lies within half a particle's diagonal of the centre of a particle. Collective.
std::vector<double> roomAhead(const State<3>& state, const std::vector<Way>& ways);

} // namespace Rhegma::cracks
