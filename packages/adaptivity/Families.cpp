#include "adaptivity/Families.hpp"

#include "state/Ancestry.hpp"

#include <algorithm>

namespace Rhegma::adaptivity
{

template <int D>
View<int*> tooSmall(const State<D>& state)
{
  const int n = state.particles.size();
  const TreeSight<D> sight(state.mesh.grid, state.mesh.tree);
  const auto position = state.particles.template real<D>(fields::position);
  const auto level = state.particles.integer(fields::level);
  const View<int*> all("rhegma::small", n);
  int count = 0;
  Kokkos::parallel_scan(
      "rhegma::adaptivity::listSmall", Kokkos::RangePolicy<ExecSpace>(0, n),
      KOKKOS_LAMBDA(const int p, int& at, const bool final) {
        if (level(p) == 0)
          return;
        Vector<D> x;
        for (int d = 0; d < D; ++d)
          x[d] = position(p, d);
        if (level(p) <= sight.leafAt(x).level)
          return;
        if (final)
          all(at) = p;
        ++at;
      },
      count);
  View<int*> list("rhegma::small", count);
  Kokkos::deep_copy(list, Kokkos::subview(all, std::make_pair(0, count)));
  return list;
}

template <int D>
std::vector<Family<D>> wholeFamilies(const State<D>& state, const View<int*>& list)
{
  const int count = static_cast<int>(list.extent(0));
  const auto fromAncestor = state.particles.integer(fields::ancestor),
             fromLineage = state.particles.integer(fields::lineage);
  const auto fromLevel = state.particles.integer(fields::level);
  const View<int* [4]> rows("rhegma::familyRows", count);
  Kokkos::parallel_for(
      "rhegma::adaptivity::gatherSmall", Kokkos::RangePolicy<ExecSpace>(0, count),
      KOKKOS_LAMBDA(const int i) {
        rows(i, 0) = fromAncestor(list(i));
        rows(i, 1) = fromLevel(list(i));
        rows(i, 2) = fromLineage(list(i));
        rows(i, 3) = list(i);
      });
  const auto host = onHost(rows);
  std::vector<std::array<int, 4>> sorted(count);
  for (int i = 0; i < count; ++i)
    sorted[i] = {host(i, 0), host(i, 1), host(i, 2), host(i, 3)};
  std::sort(sorted.begin(), sorted.end());
  std::vector<Family<D>> families;
  for (int i = 0; i + parts<D> <= count;)
  {
    const auto sameParent = [&](const std::array<int, 4>& a, const std::array<int, 4>& b)
    { return a[0] == b[0] && a[1] == b[1] && a[2] >> D == b[2] >> D; };
    int size = 1;
    while (i + size < count && sameParent(sorted[i], sorted[i + size]))
      ++size;
    if (size == parts<D>)
    {
      Family<D> family;
      for (int k = 0; k < size; ++k)
        family[k] = sorted[i + k][3];
      families.push_back(family);
    }
    i += size;
  }
  return families;
}

template View<int*> tooSmall(const State<2>&);
template View<int*> tooSmall(const State<3>&);
template std::vector<Family<2>> wholeFamilies<2>(const State<2>&, const View<int*>&);
template std::vector<Family<3>> wholeFamilies<3>(const State<3>&, const View<int*>&);

} // namespace Rhegma::adaptivity
