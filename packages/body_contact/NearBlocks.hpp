#pragma once
/// Loops over the particles in blocks of cells near another group.

#include "state/State.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma::body_contact
{

/// Runs body(p) for the particles of marked blocks, colour by colour: particles of blocks that run at the
/// same time have no node in common, and those of one block run in their order.
template <int D, class Body>
void forEachParticleNear(const char* label, const State<D>& state, const View<char*>& nearBlock,
                         const Body& body)
{
  const Blocks<D> blocks = state.mesh.blocks;
  for (int colour = 0; colour < Blocks<D>::colours; ++colour)
    if (blocks.colourStart[colour + 1] > blocks.colourStart[colour])
      Kokkos::parallel_for(
          label,
          Kokkos::RangePolicy<ExecSpace, Kokkos::Schedule<Kokkos::Dynamic>>(
              blocks.colourStart[colour], blocks.colourStart[colour + 1], Kokkos::ChunkSize(1)),
          KOKKOS_LAMBDA(const int b) {
            const int last = nearBlock(b) != 0 ? blocks.first(b + 1) : blocks.first(b);
            for (int p = blocks.first(b); p < last; ++p)
              body(p);
          });
}

/// The same for those of them that are in marked cells, by the lowest node of each cell.
template <int D, class Body>
struct InMarkedCells
{
  Grid<D> grid;
  BorrowedView<double* [D]> position;
  View<char*> marked;
  Body body;

  KOKKOS_INLINE_FUNCTION void operator()(int p) const
  {
    int cell = 0;
    for (int d = 0; d < D; ++d)
      cell += grid.stride[d] * static_cast<int>(grid.inCells(position(p, d), d));
    if (marked(cell) != 0)
      body(p);
  }
};

template <int D, class Body>
void forEachParticleIn(const char* label, const State<D>& state, const View<char*>& nearBlock,
                       const View<char*>& marked, const Body& body)
{
  forEachParticleNear(label, state, nearBlock,
                      InMarkedCells<D, Body>{
                          state.mesh.grid, state.particles.template real<D>(fields::position), marked, body});
}

/// Calls visit(connectivity) with the shape functions of the scene, without stored stencils.
template <int D, class Visit>
void withUnbrokenStencils(const State<D>& state, const Visit& visit)
{
  if (state.method.shape == ShapeKind::Linear)
    visit(connectivity<D, ShapeKind::Linear, false>(state));
  else
    visit(connectivity<D, ShapeKind::Gimp, false>(state));
}

/// Whether a particle adds to a node.
template <int D>
KOKKOS_INLINE_FUNCTION bool touches(double weight, const double* slope)
{
  bool any = weight != 0.0;
  for (int d = 0; d < D; ++d)
    any = any || slope[d] != 0.0;
  return any;
}

} // namespace Rhegma::body_contact
