#pragma once
/// Particles of this rank.

#include "base/FieldTable.hpp"

#include <functional>
#include <vector>

namespace Rhegma
{

template <int D>
struct State;

/// Particles that were just split: whole(i) is now one part, of which the others are in the rows from
/// first + i (2^D - 1) on.
struct SplitParts
{
  View<int*> whole; ///< rows of the first parts
  int first = 0;    ///< row of the others
};

/// The fields of the particles, and data that change with their order and number.
template <int D>
struct Particles : FieldTable
{
  int ofAllRanks = 0;  ///< number of particles of all ranks; 0 on a single rank
  bool sorted = false; ///< false: they are sorted before the next step
  long sorts = 0;      ///< number of times that they were sorted
  View<int*> indexOf; ///< index of the particle with each id, -1 where another rank has it; set by every sort
  double particleSteps = 0.0; ///< particles times steps, summed

  /// Called when particles were split; their parts are copies but for position and size.
  std::vector<std::function<void(State<D>&, const SplitParts&)>> afterSplit;
};

} // namespace Rhegma
