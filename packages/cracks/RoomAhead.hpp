#pragma once
/// How much material is ahead of the front nodes of a front.

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

/// How far each way goes through material, to a forty-eighth of its length: as far as every place on it, from
/// the first on, lies within 0.55 of the diagonal of a particle of that particle's centre. Collective.
///
/// Particles count as they were at the start, a tenth larger. (Growth.cpp, in 2D, takes the deformed ones and
/// passes over the opening of the crack that a front has right ahead of it.)
std::vector<double> roomAhead(const State<3>& state, const std::vector<Way>& ways);

} // namespace Rhegma::cracks
