#pragma once
/// Ghost values of nodes beyond a crack, extrapolated from nodes on the side of the particle.

#include "state/State.hpp"

namespace Rhegma::cracks
{

/// For each lattice node that lies behind a front, as it is seen from the other side of the crack: the two
/// nodes on that side from which it is extrapolated. They belong to the node and the side, not to a particle,
/// so that the functions of all particles on one side are those of one continuous field.
struct Ghosts
{
  View<int*> step; ///< from the node towards the other side, one node on along an axis; 0: nothing stands in
  View<int*> distance;  ///< steps to the near node; the far node is one more
  View<double*> linear; ///< 1: linear extrapolation; 0: the near node's value
  View<double*> seen;   ///< mass around the node, by unbroken functions, of particles that see it [kg]
  View<double*> unseen; ///< the same of particles on the other side of the crack [kg]
  static constexpr int reportedWidth = 3;
  View<double*> reported; ///< what ranks exchange of a node; empty where there is one rank
};

/// Number of nodes within which the nearest visible one is searched.
constexpr int ghostReach = 3;

/// Fraction of a node's own mass that extrapolation may remove. Extrapolated weights (1 + k near, -k far)
/// remove k times the mass beyond the crack from the far node; inside of a body this is at most 0.6 of what
/// the node has, but at its rim, where few particles touch a column of nodes, it may be more than all. There
/// the extrapolation becomes gradually constant, so that no mass is ever negative.
constexpr double largestExtrapolatedFraction = 0.75;

/// Largest CFL number with extrapolated weights. The strain of MUSL and USF moves with M^-1 Mc M^-1 f, M the
/// lumped and Mc the full mass matrix. With weights that are never negative the eigenvalues of M^-1 Mc stay
/// below 1; with 2 and -1 they reach 2.3 where a crack lies on a row of nodes and 3.2 a tenth of a cell above
/// it. That brings the limit of square cells with four particles from 1.7 to 0.53 and 0.40, whatever
/// Poisson's ratio; a tenth of it is kept as a margin.
constexpr double largestCflOfGhosts = 0.36;

/// The same where a crack runs across the cells near their diagonal: nodes are extrapolated along one axis
/// and the other by turns there. Measured: a plate under a step load keeps its energy over 400 steps of CFL
/// 0.36 with a crack at 0 to 38 degrees; at 45 degrees it is unstable at 0.28 and keeps it at 0.22.
constexpr double largestCflOfDiagonalGhosts = 0.18;

/// Slope against the nearer axis from which a segment counts as diagonal (35 degrees).
constexpr double diagonalSlope = 0.7;

/// Largest CFL number with extrapolated weights next to these cracks, as they lie now.
double largestCfl(const CrackSet<2>& cracks);

/// Finds the stand-ins of each node that lies behind a front. Call after findSides. Collective. \param row 0
/// for particles near cracks, as findSides marks them
void findGhosts(const State<2>& state, const View<int*>& row, Ghosts& ghosts);

} // namespace Rhegma::cracks
