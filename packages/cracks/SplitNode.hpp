#pragma once
/// Where a node with two fields lies at a front, and how much material it joins: what the law of
/// FrontCell.hpp needs.

#include "cracks/CohesiveLaw.hpp"
#include "cracks/Nearest.hpp"
#include "state/State.hpp"

#include <cmath>

namespace Rhegma::cracks
{

/// A node with two fields at a front.
struct SplitNode
{
  double behind;   ///< distance behind the front, negative ahead [cells]
  double away;     ///< distance from the crack along the axis nearest to its normal [cells]
  double steepest; ///< largest component of the crack's normal [-]
  double width;    ///< thickness, circle or size of the cell times the part of it that the fields divide [m]
};

/// Finds nodes with two fields at fronts.
template <int D>
struct SplitNodes
{
  Nodes<D> nodes;
  NodePositions<D> positions;
  CrackSight<D> sight;
  View<std::uint64_t*> nearest;
  bool refined;
  View<int*> level;
  double spacing;
  Depth depth;
  double modulus; ///< E' [Pa]
  double density; ///< of full cells; of several materials the largest [kg/m3]
  FrontLaw law;

  /// \param modulus, density see the members
  SplitNodes(const State<D>& state, const View<std::uint64_t*>& nearest_, double modulus_, double density_,
             FrontLaw law_)
      : nodes(state.mesh.nodes),
        positions(nodePositions(state)),
        sight(state.cracks, state.mesh.grid.spacing),
        nearest(nearest_),
        refined(state.mesh.tree.refined()),
        level(state.mesh.tree.nodeLevel),
        spacing(state.mesh.grid.spacing),
        depth(state.method.depth()),
        modulus(modulus_),
        density(density_),
        law(law_)
  {
  }

  KOKKOS_INLINE_FUNCTION double cellAt(int primary) const
  {
    return refined ? spacing / (1 << level(primary)) : spacing;
  }

  /// The i-th node with two fields.
  KOKKOS_INLINE_FUNCTION SplitNode operator()(int i) const
  {
    const int primary = nodes.parent(i), s = simplexOf(nearest(primary));
    const double cell = cellAt(primary);
    const Sight seen = sight.locate(s, positions(primary));
    SplitNode node{seen.behind / cell, 0.0, 0.0, 0.0};
    for (int d = 0; d < D; ++d)
      node.steepest = std::fmax(node.steepest, std::fabs(sight.normal(s, d)));
    node.away = std::fabs(seen.distance) / (cell * node.steepest);
    const double a = nodes.sums(primary, Nodes<D>::massAt),
                 b = nodes.sums(nodes.numLattice + i, Nodes<D>::massAt);
    node.width = hasFrontCell<D>(node.steepest, law) ? openingFraction(a, b) : 1.0;
    if constexpr (D == 3) // less at the surface, by the filled fraction of the cells of the node
    {
      const double filled = (a + b) / (density * cell * cell * cell);
      node.width *= cell * (filled > springs::fullCells ? 1.0 : filled);
    }
    else
      node.width *= depth.at(positions(primary)[0]);
    return node;
  }

  /// By how much the traction of the i-th node falls with its opening (frontCellSlope) [N/m].
  KOKKOS_INLINE_FUNCTION double slope(int i) const
  {
    const SplitNode node = (*this)(i);
    return frontCellSlope<D>(modulus, node.width, node.away, node.steepest, law);
  }

  /// Stiffness of the i-th node by the law of front springs (frontSpringStiffness) [N/m].
  KOKKOS_INLINE_FUNCTION double stiffness(int i) const
  {
    const SplitNode node = (*this)(i);
    return frontSpringStiffness<D>(modulus, node.width, node.behind, node.away, node.steepest, law);
  }
};

} // namespace Rhegma::cracks
