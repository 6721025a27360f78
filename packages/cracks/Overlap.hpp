#pragma once
/// Faces that have passed through each other.

#include "state/State.hpp"

#include <string>

namespace Rhegma::cracks
{

/// A warning where the faces of a crack overlap by more than the strains next to it make over its length;
/// else nothing. A crack that is closed by a stress s overlaps by 4 s a / E', twice s / E' times its length 2
/// a; passing waves and cells' errors make a few tenths of that.
/// \param startsInEquilibrium as by Time > Initial State = Equilibrium, for the advice
template <int D>
std::string warningOfOverlap(const State<D>& state, int crack, bool startsInEquilibrium = false);

} // namespace Rhegma::cracks
