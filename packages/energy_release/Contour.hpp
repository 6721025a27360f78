#pragma once
/// The disk around a front over which the domain integrals run.

#include "state/State.hpp"
#include "transfer/NearNodes.hpp"

namespace Rhegma::energy_release
{

struct ContourRadii
{
  double inner; ///< the weight is 1 up to here [m]
  double outer; ///< and 0 from here on [m]
};

/// The weight q of the domain integrals at a distance from the front.
KOKKOS_INLINE_FUNCTION double weightAt(double distance, const ContourRadii& radii)
{
  const double q = (radii.outer - distance) / (radii.outer - radii.inner);
  return q > 1.0 ? 1.0 : (q > 0.0 ? q : 0.0);
}

/// The weight q of the domain integrals. It is evaluated at nodes only and interpolated like the motion, cuts
/// included, so that the integrals are sums over nodal residual forces: evaluated at particles it gives
/// errors of tens of percent, and interpolated by unbroken functions errors of percents with extrapolated
/// weights.
template <int D>
struct NodalWeight
{
  NodePositions<D> positions;
  Vector<D> centre;
  ContourRadii radii;

  KOKKOS_INLINE_FUNCTION double operator()(int node) const
  {
    return weightAt(norm(positions(node) - centre), radii);
  }
};

/// A node counts as surrounded by material when it is covered by more: half is what a node on a straight
/// surface has.
constexpr double surrounded = 0.6;

/// Fraction of the cells of nodes that particles cover, of the nodes in a box.
template <int D>
struct NodeCover
{
  BoxNodes<D> box;
  View<double*> fraction; ///< of each node of the box
  Nodes<D> nodes;

  /// Whether node k of the box is known not to be surrounded. At the boundary of its part of the lattice a
  /// rank does not know all cells around a node.
  KOKKOS_INLINE_FUNCTION bool isOpen(int k) const
  {
    return isOwnedByThisRank(nodes, box.node(k)) && fraction(k) <= surrounded;
  }
};

/// The cover of the nodes within `radius` [m] of a position, on the lattice and in refined cells; that of
/// others in the box around them may be too small. Collective. \param crack only bodies that it may cut
/// count; -1: all
template <int D>
NodeCover<D> coverOfNodes(const State<D>& state, const Vector<D>& centre, double radius, int crack = -1);

/// Largest outer radius around a front in 2D up to which every node is surrounded by material, and clear of
/// other fronts, at most `radius` [m]. Collective.
double largestContour(const State<2>& state, const CrackFront<2>& front, double radius);

/// Radii that a scene gives; 0 where it leaves them to the program.
struct GivenRadii
{
  double inner = 0.0, outer = 0.0;
  double innerCells = 3.0, outerCells = 6.0; ///< defaults [cells]
};

/// Radii without other surfaces nearby: those in cells, or so that a given one fits.
ContourRadii usualRadii(const GivenRadii& given, double cell);

/// Smallest outer radius that is chosen: 2 cells, or a cell beyond a given inner radius.
double smallestOuter(const GivenRadii& given, double cell);

} // namespace Rhegma::energy_release
