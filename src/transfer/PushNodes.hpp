#pragma once
/// Loops over points that push nodes: loads, faces of cracks.

#include "base/SmallLoops.hpp"

namespace Rhegma
{

/// Runs push(k) for k = 0 .. count - 1, each of which adds atomically to nodes that others add to as well.
///
/// On a host they run one after another, so that the sums, like those of the particles (Blocks.hpp), do not
/// depend on the number or order of threads: points are few compared with particles. A device runs all at
/// once.
template <class Push>
void forEachPushing(const char* label, int count, const Push& push)
{
  if (std::is_same_v<ExecSpace, Kokkos::DefaultHostExecutionSpace>)
    parallelForSmall(
        label, count > 0 ? 1 : 0, KOKKOS_LAMBDA(const int) {
          for (int k = 0; k < count; ++k)
            push(k);
        });
  else
    Kokkos::parallel_for(label, Kokkos::RangePolicy<ExecSpace>(0, count), push);
}

} // namespace Rhegma
