#include "adaptivity/Ids.hpp"

#include <algorithm>
#include <vector>

namespace Rhegma::adaptivity
{

template <int D>
void nameParticles(State<D>& state)
{
  const auto id = state.particles.integer(fields::id);
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, id);
  const int count = static_cast<int>(host.extent(0));
  int largest = -1;
  for (int p = 0; p < count; ++p)
    largest = std::max(largest, host(p));
  std::vector<char> taken(largest + 1, 0);
  for (int p = 0; p < count; ++p)
    if (host(p) >= 0)
      taken[host(p)] = 1;
  int next = 0;
  for (int p = 0; p < count; ++p)
    if (host(p) < 0)
    {
      while (next <= largest && taken[next] != 0)
        ++next;
      host(p) = next++;
    }
  Kokkos::deep_copy(id, host);
}

template void nameParticles(State<2>&);
template void nameParticles(State<3>&);

} // namespace Rhegma::adaptivity
