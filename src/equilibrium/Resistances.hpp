#pragma once
/// What couples and stiffens the rows of an equilibrium: particles, the ghost penalty and forces of the step.

#include "equilibrium/GhostPenalty.hpp"
#include "equilibrium/Particles.hpp"
#include "state/StepForce.hpp"

#include <memory>
#include <vector>

namespace Rhegma::equilibrium
{

/// What couples rows.
enum class Couplings
{
  All,
  WithoutJoins, ///< of forces of the step that join pieces
  OfMaterial    ///< that bears loads: neither by the ghost penalty nor by particles that hardly reach a node
};

/// The ghost penalty and the forces of a step.
template <int D>
struct Resistances
{
  std::vector<SlopeJump> jumps;
  std::vector<std::shared_ptr<StepForce<D>>> forces;
  std::vector<Groups> groups; ///< rows that each force couples

  Resistances() = default;
  /// Begins the forces of a step. Collective. \param graph with its rows
  Resistances(const State<D>& state, const RowGraph& graph);

  /// All rows that are coupled though no particle sees both.
  Groups coupled(Couplings couplings) const;

  /// Whether a force chooses between branches.
  bool haveBranches() const;
};

/// Finds the coupled rows of a graph (connectRows). Collective. \param boxes in place of those of the
/// particles, if any
template <int D>
void connect(const State<D>& state, const Resistances<D>& resistances, Couplings couplings,
             const ClippedBoxes<D>& boxes, const RowOwners& owners, RowGraph& graph);

/// A stiffness, and what is known of it.
struct Stiffness
{
  StiffnessBlocks blocks; ///< complete for the rows that this rank owns [N/m]
  bool exists = true;     ///< on all ranks; not where a particle is inverted
  bool symmetric = true;
};

/// The stiffness at a trial displacement. Collective. \param graph connected with the same boxes
/// \param symmetricOnly whether only the symmetric part of that of forces is wanted
template <int D>
Stiffness assemble(const State<D>& state, const Resistances<D>& resistances, const Values& displacement,
                   const ClippedBoxes<D>& boxes, const RowOwners& owners, const RowGraph& graph,
                   bool symmetricOnly);

} // namespace Rhegma::equilibrium
