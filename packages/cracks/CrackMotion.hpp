#pragma once
/// Cracks that move with the material.

#include "state/State.hpp"

namespace Rhegma::cracks
{

/// Moves each vertex's two positions with the faces of the crack and puts the crack midway. A front has one
/// position: it moves with the mean of both sides.
///
/// Faces move by the velocity that strains and moves the particles: its integral is the displacement of the
/// cells at rest (K U = f), whereas the motion of nodes before the projection is scattered by the light nodes
/// of cut cells; with it, openings in inclined cracks were off by 7 to 30 %.
template <int D>
class CrackMotion
{
public:
  void move(State<D>& state);

private:
  ObservedPoints<D> points_; ///< side -1 and +1 of each vertex, in this order
  StencilTable<D> stencils_;
  View<double*> shift_; ///< of each point, D numbers, and whether it has nodes
};

} // namespace Rhegma::cracks
