#pragma once
/// Blocks of cells: the order of the particles, and which blocks may add to the nodes at the same time.

#include "base/FieldTable.hpp"
#include "grid/Grid.hpp"

#include <vector>

namespace Rhegma
{

/// Particles that a thread processes together, one per lane, so that the compiler uses vector instructions.
#ifdef KOKKOS_ENABLE_CUDA
constexpr int lanes = 1;
#else
constexpr int lanes = 16;
#endif

/// Particles sorted by block of cells and by cell inside a block.
///
/// Blocks of one colour share no node as long as no particle is more than one cell outside of its block, so
/// their particles add to nodes at the same time without atomics and in an order that does not depend on the
/// number of threads. (Measured: atomics cost 8 times a scatter into sorted blocks; duplicated grids are as
/// fast, but their sum depends on the number of threads.)
template <int D>
struct Blocks
{
  /// Cells along an edge. A particle that has drifted one cell out of its block and has ghosts of a crack
  /// reaches from the node four before the block's first cell to the node four beyond its last: two blocks of
  /// one colour, one block apart, have no common node if blocks have nine cells or more.
  static constexpr int edge = 9;
  /// Axes that are cut into blocks; in 3D the fastest is left whole.
  static constexpr int axes = 2;
  static constexpr int colours = 4;

  View<int*> first; ///< first particle of each block, by colour, the largest first; one more at the end
  View<int* [axes]> corner; ///< lowest cell of each block along the cut axes
  /// First particle of each bundle of up to `lanes` in one block; one more at the end.
  View<int*> bundleFirst;
  View<int*> bundleBlock; ///< block of each bundle
  /// By the lowest node of a cell: not 0 in cells that held a particle at the sort and in their neighbours;
  /// all nodes of a stencil in such a cell are listed.
  View<char*> nearby;
  /// Not 0 for blocks whose particles may touch a refined cell or one next to it; empty where none is
  /// refined.
  View<char*> refined;
  /// Not 0 where a particle is further outside of its block than the blocks allow or where nodes are not
  /// listed (0), or is outside of the domain (1).
  View<int[2]> strays;
  int colourStart[colours + 1] = {0, 0, 0, 0, 0};
  int numBlocks = 0;
  int numBundles = 0;
};

/// Sorts all fields of the particles by block and cell, and lists the nodes that they can reach until one of
/// them is a cell outside of its block or of the cells that held particles. The sort is stable: particles of
/// one cell keep their order.
template <int D>
void sortParticles(const Grid<D>& grid, FieldTable& particles, Blocks<D>& blocks, View<int*>& activeNodes);

/// Runs body(begin, end) on the particles of every block, colour by colour.
template <int D, class Body>
void forEachBlock(const char* label, const Blocks<D>& blocks, const Body& body)
{
  const View<int*> first = blocks.first;
  for (int colour = 0; colour < Blocks<D>::colours; ++colour)
    if (blocks.colourStart[colour + 1] > blocks.colourStart[colour])
      Kokkos::parallel_for(
          label,
          Kokkos::RangePolicy<ExecSpace, Kokkos::Schedule<Kokkos::Dynamic>>(
              blocks.colourStart[colour], blocks.colourStart[colour + 1], Kokkos::ChunkSize(1)),
          KOKKOS_LAMBDA(const int b) { body(first(b), first(b + 1)); });
}

} // namespace Rhegma
