#pragma once
/// Pieces of bodies: material that is connected, across bonded bodies too, and not cut by cracks.

#include "state/State.hpp"

#include <string>
#include <vector>

namespace Rhegma::measure
{

/// The particles' field that has the number of their piece.
inline const std::string pieceField = "piece";

/// A piece of one or several bodies.
template <int D>
struct Piece
{
  double mass = 0.0;       ///< [kg]
  Vector<D> centre{};      ///< of mass [m]
  std::vector<int> bodies; ///< that it has particles of, ascending
};

/// Numbers the pieces from 0 in the order of their masses, the largest first, and writes the number of each
/// particle's piece to `pieceField`. Two particles belong to one piece if they have a node, and at a cracked
/// node a field, in common, or if others connect them so: material that has come apart by less than a cell
/// without a crack still is one piece. Needs the nodes of a step. Time and memory grow with all particles.
/// Collective.
template <int D>
void numberPieces(const State<D>& state);

/// The pieces that the particles' field has, the same on all ranks; none where they are not known.
/// Collective.
template <int D>
std::vector<Piece<D>> piecesOf(const State<D>& state);

} // namespace Rhegma::measure
