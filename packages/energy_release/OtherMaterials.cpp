#include "energy_release/OtherMaterials.hpp"

#include "energy_release/PointBounds.hpp"
#include "material/LawStiffness.hpp"
#include "state/BodyGroup.hpp"
#include "state/Subdomain.hpp"
#include "transfer/NearestMaterial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma::energy_release
{

namespace
{

/// Distance of the nearest particle of a material from the nodes of a front [m].
template <int D>
double distanceTo(const State<D>& state, const CrackFront<D>& front, int material)
{
  const auto position = state.particles.template real<D>(fields::position);
  const auto of = state.particles.integer(fields::material);
  const ParticlesOfGroup own = particlesOfCrack(state, front.crack);
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vector<D>& x : front.points())
  {
    double least = nearest;
    Kokkos::parallel_reduce(
        "rhegma::distanceToMaterial", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
        KOKKOS_LAMBDA(const int p, double& smallest) {
          if (of(p) != material || !own.hold(p))
            return;
          double square = 0.0;
          for (int d = 0; d < D; ++d)
            square += (position(p, d) - x[d]) * (position(p, d) - x[d]);
          smallest = std::fmin(smallest, std::sqrt(square));
        },
        Kokkos::Min<double>(least));
    nearest = std::min(nearest, least);
  }
  nearest = -nearest;
  maxParts(state, &nearest, 1);
  return -nearest;
}

/// Bounds of the particles of a material.
template <int D>
Geometry::Bounds<D> boundsOf(const State<D>& state, int material)
{
  const auto position = state.particles.template real<D>(fields::position);
  const auto of = state.particles.integer(fields::material);
  double largest[2 * D]; // of the coordinates, and of their negatives
  for (int k = 0; k < 2 * D; ++k)
  {
    const int d = k / 2;
    const double sign = k % 2 == 0 ? 1.0 : -1.0;
    largest[k] = -std::numeric_limits<double>::infinity();
    Kokkos::parallel_reduce(
        "rhegma::boundsOfMaterial", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
        KOKKOS_LAMBDA(const int p, double& most) {
          if (of(p) == material)
            most = std::fmax(most, sign * position(p, d));
        },
        Kokkos::Max<double>(largest[k]));
  }
  maxParts(state, largest, 2 * D);
  Geometry::Bounds<D> bounds;
  for (int d = 0; d < D; ++d)
  {
    bounds.upper[d] = largest[2 * d];
    bounds.lower[d] = -largest[2 * d + 1];
  }
  return bounds;
}

} // namespace

template <int D>
OtherMaterials<D>::OtherMaterials(const State<D>& state) : state_(state)
{
  const int count = static_cast<int>(state.materials.properties.size());
  for (int m = 0; m < count && count > 1; ++m)
    bounds_.push_back(boundsOf(state, m));
}

template <int D>
OtherMaterial OtherMaterials<D>::nearest(const CrackFront<D>& front, double radius) const
{
  OtherMaterial found;
  if (bounds_.empty())
    return found;
  const std::vector<Properties>& all = state_.materials.properties;
  const int own = materialAt(state_, front.position);
  for (int m = 0; m < static_cast<int>(all.size()); ++m)
  {
    if (haveSameStiffness(all[m], all[own]) || !areNear(boundsOf(front.points()), bounds_[m], radius))
      continue;
    const double distance = distanceTo(state_, front, m);
    if (distance < (found.material < 0 ? radius : found.distance))
      found = {m, distance};
  }
  return found;
}

template class OtherMaterials<2>;
template class OtherMaterials<3>;

} // namespace Rhegma::energy_release
