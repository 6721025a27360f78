#include "adaptivity/Ids.hpp"

#include "parallel/Subdomain.hpp"

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
  const Ranks ranks = ranksOf(state);
  std::vector<double> named;
  std::vector<double> unnamed(ranks.size(), 0.0);
  for (int p = 0; p < count; ++p)
    if (host(p) >= 0)
      named.push_back(host(p));
    else
      ++unnamed[ranks.rank()];
  named = ranks.gatherOnAll(named);
  ranks.sum(unnamed.data(), ranks.size());
  int largest = -1;
  for (const double name : named)
    largest = std::max(largest, static_cast<int>(name));
  std::vector<char> taken(largest + 1, 0);
  for (const double name : named)
    taken[static_cast<int>(name)] = 1;
  int next = 0;
  const auto findNext = [&]
  {
    while (next <= largest && taken[next] != 0)
      ++next;
    return next++;
  };
  for (int r = 0; r < ranks.rank(); ++r)
    for (int k = 0; k < static_cast<int>(unnamed[r]); ++k)
      findNext();
  for (int p = 0; p < count; ++p)
    if (host(p) < 0)
      host(p) = findNext();
  Kokkos::deep_copy(id, host);
}

template void nameParticles(State<2>&);
template void nameParticles(State<3>&);

} // namespace Rhegma::adaptivity
