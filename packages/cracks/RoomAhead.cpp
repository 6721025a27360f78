#include "cracks/RoomAhead.hpp"

#include "state/Subdomain.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace Rhegma::cracks
{

namespace
{

constexpr int places = 48;      ///< that are looked at along a way
constexpr double stretch = 1.1; ///< bodies deform a little

/// The box round all ways.
struct Box
{
  Vector<3> lower{1e300, 1e300, 1e300}, upper{-1e300, -1e300, -1e300};

  void hold(const Vector<3>& x)
  {
    for (int d = 0; d < 3; ++d)
    {
      lower[d] = std::min(lower[d], x[d]);
      upper[d] = std::max(upper[d], x[d]);
    }
  }

  KOKKOS_INLINE_FUNCTION bool isNear(const Vector<3>& x, double reach) const
  {
    bool near = true;
    for (int d = 0; d < 3; ++d)
      near = near && x[d] > lower[d] - reach && x[d] < upper[d] + reach;
    return near;
  }
};

} // namespace

std::vector<double> roomAhead(const State<3>& state, const std::vector<Way>& ways)
{
  const int count = static_cast<int>(ways.size());
  std::vector<double> room(count, 0.0);
  if (count == 0)
    return room;
  const View<double* [7]> rows("rhegma::cracks::ways", count);
  const View<std::uint64_t*> filled("rhegma::cracks::filledPlaces", count);
  const auto host = Kokkos::create_mirror_view(rows);
  Box box;
  for (int k = 0; k < count; ++k)
  {
    box.hold(ways[k].from);
    box.hold(ways[k].from + ways[k].length * ways[k].direction);
    for (int d = 0; d < 3; ++d)
    {
      host(k, d) = ways[k].from[d];
      host(k, 3 + d) = ways[k].direction[d];
    }
    host(k, 6) = ways[k].length / places;
  }
  Kokkos::deep_copy(rows, host);
  const auto position = state.particles.real<3>(fields::position);
  const auto edge = state.particles.real<3>(fields::edge);
  Kokkos::parallel_for(
      "rhegma::cracks::roomAhead", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p) {
        const Vector<3> x{position(p, 0), position(p, 1), position(p, 2)};
        const double reach =
            0.5 * stretch *
            std::sqrt(edge(p, 0) * edge(p, 0) + edge(p, 1) * edge(p, 1) + edge(p, 2) * edge(p, 2));
        if (!box.isNear(x, reach))
          return;
        for (int k = 0; k < count; ++k)
        {
          const Vector<3> from{x[0] - rows(k, 0), x[1] - rows(k, 1), x[2] - rows(k, 2)};
          const Vector<3> direction{rows(k, 3), rows(k, 4), rows(k, 5)};
          const double step = rows(k, 6), along = dot(from, direction);
          const double aside = dot(from, from) - along * along;
          if (aside > reach * reach || along < -reach || along > places * step + reach)
            continue;
          const double half = std::sqrt(reach * reach - aside);
          std::uint64_t bits = 0;
          for (int i = 1; i <= places; ++i)
            if (std::fabs(i * step - along) <= half)
              bits |= std::uint64_t(1) << i;
          if ((bits & ~filled(k)) != 0)
            Kokkos::atomic_fetch_or(&filled(k), bits);
        }
      });
  const auto found = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, filled);
  std::vector<double> bits(static_cast<std::size_t>(count) * places, 0.0);
  for (int k = 0; k < count; ++k)
    for (int i = 1; i <= places; ++i)
      bits[k * places + i - 1] = (found(k) >> i & 1) != 0 ? 1.0 : 0.0;
  maxParts(state, bits.data(), static_cast<int>(bits.size()));
  for (int k = 0; k < count; ++k)
  {
    int whole = 0;
    while (whole < places && bits[k * places + whole] > 0.0)
      ++whole;
    room[k] = whole * ways[k].length / places;
  }
  return room;
}

} // namespace Rhegma::cracks
