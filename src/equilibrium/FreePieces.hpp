#pragma once
/// Pieces of bodies that no support holds.

#include "equilibrium/RigidModes.hpp"
#include "state/State.hpp"

#include <string>
#include <vector>

namespace Rhegma::equilibrium
{

/// A piece that can move freely, and what of its loads does not balance.
struct FreePiece
{
  std::string body;    ///< that has most of it
  bool isPart = false; ///< whether it has less mass than the body
  std::string motions; ///< such as "can move along x"
  std::string centre;  ///< of mass, such as "0.5, 0.75 m"
  double mass = 0.0;   ///< [kg]
  Imbalance imbalance;

  /// "Bodies > Plate" or "a part of Bodies > Plate (12 kg around 0.5, 0.75 m)".
  std::string name() const;
};

/// The body with the most particles in a piece: its index, or -1. Collective.
template <int D>
int bodyOfPiece(const State<D>& state, const RowGraph& graph, const RowOwners& owners,
                const std::vector<int>& pieceOf, int piece);

/// Name, mass and centre of the piece of a motion. Collective. \param mass of all rows [kg]
template <int D>
FreePiece describePiece(const State<D>& state, const RowGraph& graph, const RowOwners& owners,
                        const std::vector<int>& pieceOf, const RigidMode<D>& mode,
                        const std::vector<double>& mass);

/// The pieces with free motions that are larger than two cells, in which nodes of a few particles may lie
/// apart from others. Collective.
/// \param modes free motions of the pieces \param loads on all rows, the same on all ranks that have one [N]
template <int D>
std::vector<FreePiece> findFreePieces(const State<D>& state, const RowGraph& graph, const RowOwners& owners,
                                      const std::vector<int>& pieceOf, const std::vector<RigidMode<D>>& modes,
                                      const std::vector<Vector<D>>& position, const std::vector<double>& mass,
                                      const View<double*>& loads);

} // namespace Rhegma::equilibrium
