#pragma once
/// Sizes at a crack, by which a scene is judged.

#include "plausibility/BodyMeasures.hpp"

#include <algorithm>

namespace Rhegma
{

/// Longest extent of a crack along an axis [m], as it lies in the bodies; 0 while it has no vertices.
template <int D>
double extentOf(const State<D>& state, const Crack<D>& crack)
{
  const auto x = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.cracks.vertex);
  const int end = crack.firstVertex + crack.numVertices;
  if (crack.numVertices == 0 || end > static_cast<int>(x.extent(0)))
    return 0.0;
  double longest = 0.0;
  for (int d = 0; d < D; ++d)
  {
    double low = x(crack.firstVertex, d), high = low;
    for (int v = crack.firstVertex; v < end; ++v)
    {
      low = std::min(low, x(v, d));
      high = std::max(high, x(v, d));
    }
    longest = std::max(longest, high - low);
  }
  return longest;
}

/// The longest extent of all cracks [m]; 0 without cracks.
template <int D>
double longestCrack(const State<D>& state)
{
  double longest = 0.0;
  for (const Crack<D>& crack : state.cracks.cracks)
    longest = std::max(longest, extentOf(state, crack));
  return longest;
}

/// Length of the plastic zone ahead of a front (Irwin 1960): (K / yield stress)^2 / (2 pi) in plane stress, a
/// third of it elsewhere [m]. \param K stress intensity [Pa m^0.5] \param body with a yield stress
template <int D>
double plasticZone(double K, const BodyMeasure<D>& body, Plane plane)
{
  constexpr double pi = 3.14159265358979;
  const double ratio = K / body.yield;
  return ratio * ratio / ((plane == Plane::Stress ? 2.0 : 6.0) * pi);
}

/// Part of the crack and of the body up to which a plastic zone is small. The standard of K_Ic (ASTM E399,
/// lengths of 2.5 (K / yield stress)^2 and more) has 0.06 in plane stress and 0.02 in plane strain.
constexpr double smallZone = 0.1;

} // namespace Rhegma
