#pragma once
/// Cracks that move with the material.

#include "state/State.hpp"

namespace Rhegma::cracks
{

/// Moves each vertex's two places with the faces of the crack and puts the crack midway. A front has one
/// place: it moves with the mean of both sides.
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
