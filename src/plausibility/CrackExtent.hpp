#pragma once
/// Sizes at a crack, by which a scene is judged.

#include "plausibility/BodyMeasures.hpp"
#include "plausibility/CrackBounds.hpp"

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
  const Geometry::Bounds<D> bounds = boundsOfCrack(crack, x);
  const Vector<D> edges = bounds.upper - bounds.lower;
  return *std::max_element(edges.c, edges.c + D);
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

/// The bodies that cracks lie in, by their bounds; all where none does. Call it before particles are divided
/// among ranks.
template <int D>
std::vector<BodyMeasure<D>> crackedBodies(const State<D>& state)
{
  const auto x = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.cracks.vertex);
  const std::vector<BodyMeasure<D>> bodies = measureBodies(state);
  std::vector<BodyMeasure<D>> cracked;
  const auto crosses = [&](const Crack<D>& crack, const BodyMeasure<D>& body)
  {
    const Geometry::Bounds<D> bounds = boundsOfCrack(crack, x); // empty ones meet nothing
    bool meets = true;
    for (int d = 0; d < D; ++d)
      meets = meets && bounds.lower[d] < body.upper[d] && bounds.upper[d] > body.lower[d];
    return meets;
  };
  for (const BodyMeasure<D>& body : bodies)
    if (std::any_of(state.cracks.cracks.begin(), state.cracks.cracks.end(),
                    [&](const Crack<D>& crack) { return crosses(crack, body); }))
      cracked.push_back(body);
  return cracked.empty() ? bodies : cracked;
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
/// plane strain) asks for lengths of 2.5 (K / yield stress)^2 and more, which is 0.02.
constexpr double smallZone = 0.1;

} // namespace Rhegma
