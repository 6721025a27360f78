#pragma once
/// Which front is nearest to a position.

#include "state/CrackSet.hpp"

#include <algorithm>
#include <vector>

namespace Rhegma::cracks
{

constexpr int noFront = -1;  ///< for the index of a front where there is none
constexpr int anyCrack = -1; ///< for the index of a crack

/// A front as one point.
template <int D>
struct FrontPosition
{
  Vector<D> position{}; ///< [m]
  int crack = 0;
  bool grown = false; ///< it has advanced since the start
};

template <int D>
std::vector<FrontPosition<D>> frontPoints(const CrackSet<D>& set)
{
  std::vector<FrontPosition<D>> points;
  for (const CrackFront<D>& front : set.fronts)
    points.push_back({front.position, front.crack, front.grown});
  return points;
}

/// The front of a crack that is nearest to a position, if it has grown, else `noFront`. Of any crack the
/// nearest that has grown: nodes that are joined again may be near no front of the crack to which they
/// belonged.
template <int D>
KOKKOS_INLINE_FUNCTION int nearestGrownFront(const FrontPosition<D>* points, int count, const Vector<D>& x,
                                             int crack)
{
  int found = noFront;
  double least = 1e300;
  for (int f = 0; f < count; ++f)
  {
    if (crack == anyCrack ? !points[f].grown : points[f].crack != crack)
      continue;
    const Vector<D> away = x - points[f].position;
    const double square = dot(away, away);
    if (square < least)
    {
      least = square;
      found = f;
    }
  }
  return found != noFront && points[found].grown ? found : noFront;
}

/// The same in kernels, which visit the fronts of one crack only.
template <int D>
struct NearestFront
{
  View<FrontPosition<D>*> points;
  View<int* [2]> ofCrack; ///< the first front of each crack and the one after its last

  NearestFront() = default;
  explicit NearestFront(const CrackSet<D>& set) { update(set); }

  /// Takes the fronts as they are now.
  void update(const CrackSet<D>& set)
  {
    const std::vector<FrontPosition<D>> all = frontPoints(set);
    if (points.extent(0) != all.size() || ofCrack.extent(0) != set.cracks.size())
    {
      points = View<FrontPosition<D>*>("rhegma::cracks::frontPoints", all.size());
      ofCrack = View<int* [2]>("rhegma::cracks::frontsOfCracks", set.cracks.size());
      const auto range = Kokkos::create_mirror_view(ofCrack);
      for (std::size_t c = 0; c < set.cracks.size(); ++c)
      {
        range(c, 0) = static_cast<int>(all.size());
        range(c, 1) = 0;
      }
      for (int f = 0; f < static_cast<int>(all.size()); ++f)
      {
        range(all[f].crack, 0) = std::min(range(all[f].crack, 0), f);
        range(all[f].crack, 1) = f + 1;
      }
      Kokkos::deep_copy(ofCrack, range);
    }
    const Kokkos::View<const FrontPosition<D>*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged> host(all.data(),
                                                                                                 all.size());
    Kokkos::deep_copy(points, host);
  }

  KOKKOS_INLINE_FUNCTION int operator()(const Vector<D>& x, int crack) const
  {
    const int first = crack == anyCrack ? 0 : ofCrack(crack, 0),
              end = crack == anyCrack ? static_cast<int>(points.extent(0)) : ofCrack(crack, 1);
    const int found = end > first ? nearestGrownFront(points.data() + first, end - first, x, crack) : noFront;
    return found == noFront ? noFront : first + found;
  }
};

} // namespace Rhegma::cracks
