#pragma once
/// The unknowns of an equilibrium: displacement increments of the fields of nodes.

#include "equilibrium/ClippedBoxes.hpp"
#include "state/State.hpp"

#include <cmath>
#include <vector>

namespace Rhegma::equilibrium
{

/// Whether a node of a particle's stencil counts. Where both its weight and its slopes are rounding errors,
/// as of a box that ends on a row of nodes, it would be an unknown that nothing holds. The weight alone is
/// not enough: a particle of linear functions on a row of nodes has no weight, but slopes, at the nodes next
/// to it, without which a uniform motion would strain it. \param slopes [1/m] \param spacing of the cells [m]
KOKKOS_INLINE_FUNCTION bool counts(double weight, const double* slopes, int numSlopes, double spacing)
{
  constexpr double leastWeight = 1e-20, leastSlope = 1e-8;
  bool found = weight >= leastWeight;
  for (int k = 0; k < numSlopes; ++k)
    found = found || std::fabs(slopes[k]) * spacing > leastSlope;
  return found;
}

/// Largest slope of a node in a particle's stencil, times the edge of the cells [-].
KOKKOS_INLINE_FUNCTION double largestSlope(const double* slopes, int numSlopes, double spacing)
{
  double largest = 0.0;
  for (int k = 0; k < numSlopes; ++k)
    largest = std::fmax(largest, std::fabs(slopes[k]) * spacing);
  return largest;
}

/// Rows, one for each field of a node that some particle sees, in the order of the nodes' numbers; and which
/// rows are coupled.
struct RowGraph
{
  View<int*> rowOf;  ///< of each node, enriched fields included; -1: none
  View<int*> nodeOf; ///< node of each row
  View<int*> first;  ///< of each row in `column`; one more at the end
  View<int*> column; ///< coupled rows, ascending, the row itself included
  int rows = 0;

  /// Position in `column` of a coupled pair.
  KOKKOS_INLINE_FUNCTION int find(int row, int other) const
  {
    int low = first(row), high = first(row + 1) - 1;
    while (low < high)
    {
      const int middle = (low + high) / 2;
      if (column(middle) < other)
        low = middle + 1;
      else
        high = middle;
    }
    return low;
  }
};

class RowOwners;

/// Rows that are coupled although no particle sees both, one group a list.
using Groups = std::vector<std::vector<int>>;

/// The rows of the nodes that particles see, those of other ranks included, without couplings. Needs the
/// stencils of the step. Collective.
template <int D>
RowGraph numberRows(const State<D>& state);

/// Finds the coupled rows: those of all ranks for rows of this rank, for others those of this rank's
/// particles and groups. Collective. \param groups further ones \param boxes in place of those of the
/// particles, if any \param least slope of a particle's node, times the edge of the cells, from which on the
/// particle couples its row
template <int D>
void connectRows(const State<D>& state, const Groups& groups, const ClippedBoxes<D>& boxes,
                 const RowOwners& owners, RowGraph& graph, double least = 0.0);

/// Pieces: rows of all ranks that are coupled directly or through others. Collective. \return the piece of
/// each row, and their number
std::pair<std::vector<int>, int> findPieces(const RowGraph& graph, const RowOwners& owners);

/// The same for a graph with its rows alone: those that a particle sees or a group has. Collective.
template <int D>
std::pair<std::vector<int>, int> findPieces(const State<D>& state, const Groups& groups,
                                            const RowOwners& owners, const RowGraph& graph);

/// Positions of the nodes of rows [m].
template <int D>
std::vector<Vector<D>> rowPositions(const State<D>& state, const RowGraph& graph);

/// Mass of each row [kg].
template <int D>
std::vector<double> rowMasses(const State<D>& state, const RowGraph& graph);

/// What supports prescribe for each unknown (D * row + axis).
struct Held
{
  std::vector<char> is;       ///< not 0 where a support holds the unknown
  std::vector<double> change; ///< displacement over the step there [m]
};

/// \param state with the prescribed motion of the step, a mean velocity
template <int D>
Held findHeld(const State<D>& state, const RowGraph& graph);

} // namespace Rhegma::equilibrium
