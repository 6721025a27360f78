#pragma once
/// The part of a run that a rank has.

#include "parallel/Division.hpp"
#include "parallel/Halo.hpp"
#include "state/State.hpp"

namespace Rhegma
{

/// Which cells every rank owns, and what this one shares with others.
template <int D>
struct Subdomain
{
  Division<D> division;
  Halo<D> halo;

  Subdomain(const Ranks& ranks, const Division<D>& cells) : division(cells), halo(ranks, cells) {}
};

/// Leaves each rank the particles in its cells, of all that every rank holds, and the part of the lattice
/// that they can reach. Nothing where there is one rank. Collective.
template <int D>
void divideState(State<D>& state);

/// Divides the cells anew by the particles as they lie now, and sends these to their owners. Nothing where
/// there is one rank. Collective.
template <int D>
void redivideState(State<D>& state);

/// Sends particles that are in cells of other ranks to these. Total mass, momentum and all fields are kept;
/// the order of particles is not. Collective.
template <int D>
void migrateParticles(State<D>& state);

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

} // namespace Rhegma
