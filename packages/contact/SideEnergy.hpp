#pragma once
/// The energies of the body on both sides of a crack.

#include "state/State.hpp"

namespace Rhegma::contact
{

/// A crack as it was undeformed, and which part of it is watched: all of it in 3D.
template <int D>
struct WatchedCrack
{
  View<double* [D]> vertex; ///< undeformed [m]
  double length = 0.0;      ///< undeformed; of a 2D crack [m]
  Vector<D> normal;         ///< undeformed unit normal; of a 3D crack
  double part = 1.0;        ///< middle part of its length beside which material counts; 1: all of the body
};

template <int D>
WatchedCrack<D> watch(const CrackSet<D>& cracks, int crack, double part);

struct SideEnergy
{
  double below = 0.0;      ///< on side -1 [J]
  double above = 0.0;      ///< on side +1 [J]
  double alongBelow = 0.0; ///< kinetic energy of motion along the crack, on side -1 [J]
  double alongAbove = 0.0; ///< the same on side +1 [J]
};

/// Kinetic and strain energy of the particles that lay on either side of a crack, continued straight on, in
/// the undeformed body, and beside the part of it that is watched.
template <int D>
SideEnergy measureSides(const State<D>& state, const WatchedCrack<D>& crack);

/// Kinetic and strain energy of all particles [J].
template <int D>
double totalEnergy(const State<D>& state);

} // namespace Rhegma::contact
