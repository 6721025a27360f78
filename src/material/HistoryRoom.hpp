#pragma once
/// Room for the memory of any law, for kernels that hold a copy.

#include "material/Law.hpp"

namespace Rhegma
{

/// The largest number that any law keeps per particle.
constexpr int largestHistory()
{
  int largest = 0;
  for (int kind = 0; kind < 64; ++kind) // more than there are; others keep none
    for (int dimension = 2; dimension <= 3; ++dimension)
    {
      const int size = historySize(static_cast<LawKind>(kind), dimension);
      largest = size > largest ? size : largest;
    }
  return largest;
}

constexpr int historyRoom = largestHistory();
static_assert(historyRoom >= dissipationIndex<3> + 1, "the history of the J2 law must fit");

} // namespace Rhegma
