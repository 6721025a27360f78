#pragma once
/// Sweeps over the contacts of a tool, one after the other.

#include "rigid_tools/ToolContacts.hpp"

#include <algorithm>
#include <vector>

namespace Rhegma::rigid_tools
{

/// Sweeps over the contacts of a tool that have nodes in common end when no impulse changes by more than this
/// fraction of the largest one, or after so many: what is left is a difference of velocities along the face.
inline constexpr double settledSweep = 1e-7;
inline constexpr int mostSweepsOfContacts = 60;

template <int D>
KOKKOS_INLINE_FUNCTION Vector<D> vectorAt(const View<double* [D]>& vectors, int k)
{
  Vector<D> v;
  for (int d = 0; d < D; ++d)
    v[d] = vectors(k, d);
  return v;
}

/// Runs body(c, ...) for all contacts, one after the other.
template <class Body, class... Sums>
void inOrder(const char* label, int count, const Body& body, Sums&... sums)
{
  Kokkos::parallel_reduce(
      label, Kokkos::RangePolicy<ExecSpace>(0, 1),
      KOKKOS_LAMBDA(const int, Sums&... sum) {
        for (int c = 0; c < count; ++c)
          body(c, sum...);
      },
      Kokkos::Max<Sums>(sums)...);
}

/// Whether contacts have nodes in common.
template <int D>
bool haveCommonNodes(const ToolContacts<D>& contacts)
{
  const auto rows = onHost(contacts.partRow);
  const auto parts = onHost(contacts.parts);
  std::vector<int> all;
  for (int c = 0; c < contacts.count; ++c)
    for (int e = 0; e < parts(c); ++e)
      all.push_back(rows(c, e));
  std::sort(all.begin(), all.end());
  return std::adjacent_find(all.begin(), all.end()) != all.end();
}

} // namespace Rhegma::rigid_tools
