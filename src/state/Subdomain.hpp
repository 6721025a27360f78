#pragma once
/// The part of a run that belongs to a rank.

#include "grid/Branches.hpp"
#include "parallel/Division.hpp"
#include "parallel/Halo.hpp"
#include "parallel/OwnCells.hpp"
#include "state/State.hpp"

namespace Rhegma
{

/// Which cells each rank owns, and which nodes this rank has in common with others.
template <int D>
struct Subdomain
{
  Division<D> division;
  Branches<D> refined; ///< cells of the whole lattice
  Halo<D> halo;
  OwnCells<D> own;

  /// \param tree the part of the refined cells in this rank's window
  Subdomain(const Ranks& ranks, const Division<D>& cells, const Branches<D>& refined, const Tree<D>& tree);
};

/// Sets the refined cells of the whole lattice and updates the nodes. Particles must be sorted anew.
/// Collective.
template <int D>
void refineCells(State<D>& state, const Branches<D>& refined);

/// The refined cells of the whole lattice.
template <int D>
Branches<D> refinedCells(const State<D>& state);

/// The ranks for sums over particles: until the particles are divided every rank has all of them, and the
/// result is this rank alone.
template <int D>
Ranks ranksOf(const State<D>& state)
{
  return state.mesh.subdomain ? state.ranks : Ranks();
}

/// Divides a run in which every rank holds all particles: each rank keeps those in its cells, and the part of
/// the lattice that they can reach. Does nothing on one rank. Collective.
template <int D>
void divideState(State<D>& state);

/// Gives each rank the whole lattice again, with empty nodes, so that the run can be divided anew. Does
/// nothing on one rank.
template <int D>
void gatherLattice(State<D>& state);

/// Divides the cells anew by the present particles, and sends these to their owners. Does nothing on one
/// rank. Collective.
template <int D>
void redivideState(State<D>& state);

/// Sends particles that are in cells of other ranks to these. Total mass, momentum and all fields are kept;
/// the order of particles is not. Collective.
template <int D>
void migrateParticles(State<D>& state);

/// The nodes as they are now, for Mesh::nodalFields.
template <int D>
NodalFieldNodes<D> nodesOfFields(const State<D>& state);

/// Moves the nodal fields of effects to the nodes as they are now. Call once a step, when its cells are
/// known. Collective.
template <int D>
void moveNodalFields(State<D>& state);

/// Adds the nodes shared with other ranks to those in use: they may have mass from particles of other ranks.
template <int D>
void useSharedNodes(State<D>& state);

enum class SharedSums
{
  MassAndMomentum,
  Force,
  Projection
};

/// Completes nodal sums to which this rank has added only its own particles and loads. Does nothing on one
/// rank. Collective.
template <int D>
void sumOverRanks(const State<D>& state, SharedSums what);

/// The same for columns first .. first + count - 1 of an array with a row of `width` numbers for each node
/// and enriched field. \param rowOf where given, its row of each of them, or -1; the same nodes have one on
/// all ranks
template <int D>
void sumOverRanks(const State<D>& state, double* values, int width, int first, int count,
                  const View<int*>& rowOf = {});

/// Where values of shared nodes are in such an array (parallel/NeighbourSums.hpp).
template <int D>
SharedRows sharedRows(const State<D>& state, const View<int*>& rowOf = {});

/// The same for one number of each node of the lattice.
template <int D>
void sumOverRanks(const State<D>& state, const View<double*>& ofNodes);

/// Replaces values computed from the particles and nodes of each rank by their sums over the ranks; does
/// nothing until the run is divided. Collective.
template <int D>
void sumParts(const State<D>& state, double* values, int count);
template <int D>
void sumParts(const State<D>& state, const View<double*>& values);

/// The same for the largest value.
template <int D>
void maxParts(const State<D>& state, double* values, int count);

/// The lattice of the whole domain.
template <int D>
const Grid<D>& wholeLattice(const State<D>& state);

} // namespace Rhegma
