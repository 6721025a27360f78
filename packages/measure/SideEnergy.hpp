#pragma once
/// The energies of the body on both sides of a crack.

#include "state/State.hpp"

namespace Rhegma::measure
{

/// A crack as it was undeformed, and the part of it that counts: all of it in 3D.
template <int D>
struct MeasuredCrack
{
  View<double* [D]> vertex; ///< undeformed [m]
  double length = 0.0;      ///< undeformed; of a 2D crack [m]
  Vector<D> normal;         ///< undeformed unit normal; of a 3D crack
  double reach = 0.0;       ///< distance from the middle, along the crack, up to which material counts [m]
};

/// \param part of the length of a 2D crack, around its middle, that counts; 1: all of the body
template <int D>
MeasuredCrack<D> measuredCrack(const CrackSet<D>& cracks, int crack, double part);

struct SideEnergy
{
  double below = 0.0;      ///< on side -1 [J]
  double above = 0.0;      ///< on side +1 [J]
  double alongBelow = 0.0; ///< kinetic energy of motion along the crack, on side -1 [J]
  double alongAbove = 0.0; ///< the same on side +1 [J]
};

/// Kinetic and strain energy of the particles that lay on either side of a crack, continued straight on, in
/// the undeformed body, within the reach of the part of it that counts.
template <int D>
SideEnergy measureSides(const State<D>& state, const MeasuredCrack<D>& crack);

} // namespace Rhegma::measure
