#pragma once
/// Cells near a tool, and the particles in them.

#include "rigid_tools/Tool.hpp"
#include "state/State.hpp"

namespace Rhegma::rigid_tools
{

/// The cells that a tool may touch until it has moved by half a cell, and the particles in them now.
template <int D>
struct CellsNearTool
{
  View<char*> marked;     ///< by the lowest node of each cell: not 0 near the tool
  View<char*> nearBlock;  ///< of each block: not 0 where it or a cell next to it is marked
  long sorts = -1;        ///< Particles::sorts for which nearBlock holds
  bool anyNear = false;   ///< whether there is such a block
  Placement<D> placement; ///< of the tool, for which cells are marked
  Vector<D> origin{};     ///< of the grid, for which cells are marked [m]

  View<int*> firstOfBlock; ///< of each block: its first particle in the list
  View<int*> particle;     ///< particles in marked cells, in their order
  int count = 0;           ///< number of these
};

/// Marks the cells that are closer to a tool than one and a half cells, or will be before it has moved by
/// another half, and lists the particles in them. Cells are marked again only where the tool has moved.
template <int D>
void listParticlesNear(const State<D>& state, const Tool<D>& tool, CellsNearTool<D>& near);

} // namespace Rhegma::rigid_tools
