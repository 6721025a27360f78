#pragma once
/// What faces of cracks lie ahead of fronts in 3D.

#include "state/CrackSet.hpp"

#include <utility>

namespace Rhegma::cracks
{

/// The nearest crack but `own`. \return its distance from x [m] and its number; huge and -1 where there is
/// none
std::pair<double, int> nearestOther(const CrackSet<3>& set, int own, const Vector<3>& x);

/// Whether a front that stands at x and goes along `direction` has faces of its own crack less than three
/// cells ahead: seen from two cells ahead of it they are nearer than half of the way back to the front. A
/// front that closes round a middle so halts before its front nodes pass each other. \param cell [m]
bool meetsItself(const CrackSet<3>& set, int own, const Vector<3>& x, const Vector<3>& direction,
                 double cell);

} // namespace Rhegma::cracks
