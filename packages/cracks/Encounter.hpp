#pragma once
/// Encounters of a front node that is about to advance with other faces.

#include "cracks/AvailableLength.hpp"
#include "cracks/GrowingCrack.hpp"
#include "state/State.hpp"

#include <vector>

namespace Rhegma::cracks
{

/// Faces that a front node meets.
template <int D>
struct Encounter
{
  enum class Kind
  {
    None,
    Stops, ///< too near for the cells to resolve both cracks
    Joins, ///< the front ends on the face of another crack (2D)
    Meets  ///< two fronts end on one another (2D)
  };
  Kind kind = Kind::None;
  int crack = -1;        ///< that they are of
  int front = -1;        ///< that is met
  double length = 0.0;   ///< of the advance that ends there [m]
  Vector<D> direction{}; ///< of that
};

/// A front node that is to advance.
template <int D>
struct AdvancingNode
{
  int front, node;   ///< indices in the set and in the front
  int vertex;        ///< of its crack's mesh
  Path<D> path;      ///< from it
  Ligament ligament; ///< that it has
  Vector<D> to;      ///< where it would go to [m]
  bool due = true;   ///< its own driving force advances it, not the smoothing of its front
  Vector<D> aside{}; ///< along the front, back to the surface at which it ends, before it advances [m]
};

/// In 2D: a front that comes closer than three cells to another crack that lies across its path, less than
/// six cells ahead, joins the first such crack, if there is material up to it. Two fronts in each other's
/// path, within 15 degrees and six cells, meet. One that comes as close to a crack next to its path, or to an
/// earlier part of its own, stops: cells can't resolve both cracks.
///
/// In 3D: a front node stops less than three cells from another crack, or from faces of its own that lie
/// ahead. Collective.
template <int D>
Encounter<D> findEncounter(const State<D>& state, const std::vector<GrowingCrack<D>>& cracks,
                           const AdvancingNode<D>& node);

} // namespace Rhegma::cracks
