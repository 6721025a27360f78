#pragma once
/// The ligament ahead of front nodes.

#include "state/State.hpp"

#include <vector>

namespace Rhegma::cracks
{

/// A front node with a shorter ligament advances to the surface [cells].
constexpr double leastLigament = 0.5;

/// The straight path of a front node.
template <int D>
struct Path
{
  Vector<D> from;      ///< [m]
  Vector<D> direction; ///< unit vector
  double length;       ///< of its advance [m]
  double cell;         ///< size of the cells there [m]
  /// Gaps in the material that are no longer than this are the opening that the cells have of the crack,
  /// right at the front or where it has drawn particles of one body apart; longer ones are surfaces [m].
  double gap = 0.0;
};

/// The ligament along a path.
struct Ligament
{
  double length; ///< of the advance, or up to the surface [m]
  bool ends;     ///< whether it ends at the surface: less than half a cell of material is left beyond it
};

/// Whether front nodes have material for their advances, or advance to a surface. Collective.
///
/// 48 points along each advance and half a cell beyond it are checked. A point is filled that lies within
/// 0.55 of the diagonal of a particle of that particle's centre. Particles count in 2D as they are deformed,
/// in 3D as they were at the start. Two bodies further apart than an eighth of a cell are not joined over a
/// gap. Bodies that are kept apart from the one that the crack cuts are no material ahead.
template <int D>
std::vector<Ligament> ligamentsAhead(const State<D>& state, int crack, const std::vector<Path<D>>& paths);

} // namespace Rhegma::cracks
