#pragma once
/// Faces that have passed through each other.

#include "state/State.hpp"

#include <algorithm>
#include <string>

namespace Rhegma::cracks
{

/// A warning where the faces of a crack overlap by more than the strains next to it make over its length;
/// else nothing. A crack that is closed by a stress s overlaps by 4 s a / E', twice s / E' times its length 2
/// a; passing waves and cells' errors make a few tenths of that.
/// \param startsInEquilibrium as by Time > Initial State = Equilibrium, for the advice
template <int D>
std::string warningOfOverlap(const State<D>& state, int crack, bool startsInEquilibrium = false);

/// By how much single vertices of a crack may overlap without meaning: its faces follow single nodes, by as
/// much as a cell is strained next to it, without thermal strain [m]. Collective.
template <int D>
double noiseOfFaces(const State<D>& state, int crack);

/// Whether a crack has a front that may still advance; without one it ends at surfaces or other cracks.
template <int D>
bool hasFront(const CrackSet<D>& cracks, int crack)
{
  return std::any_of(cracks.fronts.begin(), cracks.fronts.end(),
                     [&](const CrackFront<D>& front) { return front.crack == crack && !front.ended; });
}

/// How to write contact for this crack, as the end of a message.
template <int D>
std::string adviceAgainstOverlap(const State<D>& state, int crack, bool startsInEquilibrium);

} // namespace Rhegma::cracks
