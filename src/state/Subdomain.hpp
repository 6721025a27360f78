#pragma once
/// The part of a run that a rank has.

#include "grid/Branches.hpp"
#include "parallel/Division.hpp"
#include "parallel/Halo.hpp"
#include "parallel/OwnCells.hpp"
#include "state/State.hpp"

namespace Rhegma
{

/// Which cells every rank owns, and what this one shares with others.
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

/// Makes these the refined cells, of the whole lattice, and sees to the nodes. Particles must be sorted anew.
/// Collective.
template <int D>
void refineCells(State<D>& state, const Branches<D>& refined);

/// The refined cells of the whole lattice.
template <int D>
Branches<D> refinedCells(const State<D>& state);

/// Who takes part in what the ranks do together with their own particles: until these are divided every rank
/// has all of them, and acts alone.
template <int D>
Ranks ranksOf(const State<D>& state)
{
  return state.mesh.subdomain ? state.ranks : Ranks();
}

/// Leaves each rank the particles in its cells, of all that every rank holds, and the part of the lattice
/// that they can reach. Nothing where there is one rank. Collective.
template <int D>
void divideState(State<D>& state);

/// Gives each rank the whole lattice back, without anything on its nodes, so that what every rank then holds
/// can be divided. Nothing where there is one rank.
template <int D>
void gatherLattice(State<D>& state);

/// Divides the cells anew by the particles as they lie now, and sends these to their owners. Nothing where
/// there is one rank. Collective.
template <int D>
void redivideState(State<D>& state);

/// Sends particles that are in cells of other ranks to these. Total mass, momentum and all fields are kept;
/// the order of particles is not. Collective.
template <int D>
void migrateParticles(State<D>& state);

/// The nodes as they are now, for Mesh::nodalFields.
template <int D>
NodalFieldNodes<D> nodesOfFields(const State<D>& state);

/// Moves the nodal fields of effects to the nodes as they are now. To be called once a step, when its cells
/// are known. Collective.
template <int D>
void moveNodalFields(State<D>& state);

/// Adds the nodes shared with other ranks to those in use: they have mass that is no particle's here.
template <int D>
void useSharedNodes(State<D>& state);

enum class SharedSums
{
  MassAndMomentum,
  Force,
  Projection
};

/// Completes nodal sums that particles and loads of this rank alone have added to. Nothing where there is one
/// rank. Collective.
template <int D>
void sumOverRanks(const State<D>& state, SharedSums what);

/// The same for columns first .. first + count - 1 of an array with a row of `width` numbers for each node
/// and second field. \param rowOf where given, its row of each of them, or -1; the same nodes have one on all
/// ranks
template <int D>
void sumOverRanks(const State<D>& state, double* values, int width, int first, int count,
                  const View<int*>& rowOf = {});

/// Where values of shared nodes are in such an array (parallel/NeighbourSums.hpp).
template <int D>
SharedRows sharedRows(const State<D>& state, const View<int*>& rowOf = {});

/// The same for one number of each node of the lattice.
template <int D>
void sumOverRanks(const State<D>& state, const View<double*>& ofNodes);

/// Replaces values that each rank found of its own particles and nodes by their sums over the ranks; until
/// these are divided, every rank has all of them. Collective.
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
