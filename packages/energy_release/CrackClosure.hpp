#pragma once
/// The energy release rate by crack closure.

#include "energy_release/Recovery.hpp"

namespace Rhegma::energy_release
{

struct CrackClosure
{
  double chosen; ///< with the opening that the chosen matrix gives [J/m2]
  double lumped; ///< with the opening of a lumped projection, for comparison [J/m2]
};

/// Crack closure integral: work of the forces on the nodes ahead of the front that would close the last
/// columns of nodes behind it:
///
///     G = sum over rows, columns of (f_plus - f_minus) / 2 . [u] / (2 m dx thickness)
///
/// A column is a line of nodes across the crack; m columns are closed. On a node ahead that both sides touch,
/// f_plus is the force of the particles of side +1 alone and f_minus that of side -1 (equal and opposite at
/// rest). On the node m columns behind in the same row, [u] is the displacement of side +1 less that of side
/// -1. A crack along a line of nodes has one row of such nodes, one between lines has two, and their works
/// add. Where a spring holds the last column half open (cracks/FrontSprings.hpp), its force counts like that
/// of a closed node: by Betti's theorem, the energy released by an extension of m columns is half of the
/// forces on all nodes that are held now times their opening after it, which is the present opening m columns
/// behind them.
///
/// Not a number where the front's direction is more than 5 degrees off a direction of the grid: nodes then
/// open one by one and not in columns (counted all the same, between 0.01 and 1.2 times J at 30, 45 and 60
/// degrees to the grid); and where no node m columns behind has particles of both sides in its reach: where
/// the crack has fewer than m open columns, or its faces are cells apart.
///
/// Source: Rybicki and Kanninen, Eng. Fract. Mech. 9 (1977) 931; Krueger, Appl. Mech. Rev. 57 (2004) 109.
CrackClosure closeCrack(const State<2>& state, const CrackFront<2>& front, int columns,
                        const RecoveryMatrix& choice);

/// Whether a front runs along a direction of the grid, to within 5 degrees.
bool runsAlongGrid(const CrackFront<2>& front);

} // namespace Rhegma::energy_release
