#pragma once
/// The energies of the body on both sides of a crack.

#include "state/State.hpp"

namespace Rhegma::contact
{

/// A crack as it was undeformed, and which part of it is watched.
struct WatchedCrack
{
  View<double* [2]> vertex; ///< undeformed [m]
  double length = 0.0;      ///< undeformed [m]
  double part = 1.0;        ///< middle part of its length beside which material counts; 1: all of the body
};

WatchedCrack watch(const CrackSet<2>& cracks, int crack, double part);

struct SideEnergy
{
  double below = 0.0;      ///< on side -1 [J]
  double above = 0.0;      ///< on side +1 [J]
  double alongBelow = 0.0; ///< kinetic energy of motion along the crack, on side -1 [J]
  double alongAbove = 0.0; ///< the same on side +1 [J]
};

/// Kinetic and strain energy of the particles that lay on either side of a crack, continued straight on, in
/// the undeformed body, and beside the part of it that is watched.
SideEnergy measureSides(const State<2>& state, const WatchedCrack& crack);

/// Kinetic and strain energy of all particles [J].
double totalEnergy(const State<2>& state);

} // namespace Rhegma::contact
