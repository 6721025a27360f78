#include "combustion/IgnitionPlace.hpp"

#include "parallel/Subdomain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace Rhegma::combustion
{

namespace
{

/// Calls look(place) for enough places in each simplex of a crack: a tenth of its edges apart.
template <int D, class Look>
void forEachPlace(const CrackSet<D>& cracks, int crack, const Look& look)
{
  const auto vertex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.vertex);
  const auto simplex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.simplex);
  const Crack<D>& c = cracks.cracks[crack];
  constexpr int cuts = 10;
  for (int s = c.firstSimplex; s < c.firstSimplex + c.numSimplices; ++s)
    for (int i = 0; i <= cuts; ++i)
      for (int j = 0; j <= (D == 3 ? cuts - i : 0); ++j)
      {
        const double weight[3] = {double(i) / cuts, D == 3 ? double(j) / cuts : 1.0 - double(i) / cuts,
                                  1.0 - double(i + j) / cuts};
        Vector<D> place{};
        for (int d = 0; d < D; ++d)
          for (int k = 0; k < D; ++k)
            place[d] += weight[k] * vertex(simplex(s, k), d);
        look(place);
      }
}

/// Distance of a place from a box [m].
template <int D>
double distance(const Vector<D>& place, const Vector<D>& lower, const Vector<D>& upper)
{
  double square = 0.0;
  for (int d = 0; d < D; ++d)
  {
    const double out = std::max({lower[d] - place[d], place[d] - upper[d], 0.0});
    square += out * out;
  }
  return std::sqrt(square);
}

/// Whether a particle of this rank is nearer to a place than a cell.
template <int D>
bool hasMatter(const State<D>& state, const Vector<D>& place)
{
  const auto position = state.particles.template real<D>(fields::position);
  const double reach = state.grid.spacing;
  int found = 0;
  Kokkos::parallel_reduce(
      "rhegma::combustion::matterAt", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, int& count) {
        double square = 0.0;
        for (int d = 0; d < D; ++d)
          square += (position(p, d) - place[d]) * (position(p, d) - place[d]);
        count += square < reach * reach ? 1 : 0;
      },
      found);
  return found > 0;
}

} // namespace

template <int D>
IgnitionPlace lookNearBox(const State<D>& state, int crack, const Vector<D>& lower, const Vector<D>& upper)
{
  IgnitionPlace found;
  found.away = std::numeric_limits<double>::max();
  std::vector<Vector<D>> near;
  forEachPlace(state.cracks, crack,
               [&](const Vector<D>& place)
               {
                 const double away = distance(place, lower, upper);
                 found.away = std::min(found.away, away);
                 if (away <= state.grid.spacing)
                   near.push_back(place);
               });
  double matter =
      std::any_of(near.begin(), near.end(), [&](const Vector<D>& p) { return hasMatter(state, p); });
  maxParts(state, &matter, 1);
  found.inBody = matter > 0.0;
  return found;
}

template IgnitionPlace lookNearBox(const State<2>&, int, const Vector<2>&, const Vector<2>&);
template IgnitionPlace lookNearBox(const State<3>&, int, const Vector<3>&, const Vector<3>&);

} // namespace Rhegma::combustion
