#pragma once
/// The motion of a particle, interpolated from nodes, in the integrals around a front.

#include "state/State.hpp"

namespace Rhegma::energy_release
{

/// The velocity of nodes that strains the particles [m/s]. With MUSL and USF that is a mean of the particles'
/// own. The velocity that the solve gives a node that a box just reaches, with a mass proportional to the
/// square of the overlap and a force proportional to the overlap, is arbitrary, and so is its slope in a box
/// that has moved since. Zero in equilibrium, where nodes have the displacement of a step as a velocity until
/// particles have it.
template <int D>
struct NodalVelocity
{
  View<double * [Nodes<D>::motionWidth]> motion;
  View<double * [Nodes<D>::projectionWidth]> projection;
  bool byMotion = true, atRest = false;

  NodalVelocity() = default;
  explicit NodalVelocity(const State<D>& state)
      : motion(state.mesh.nodes.motion),
        projection(state.mesh.nodes.projection),
        byMotion(state.method.scheme == UpdateScheme::Usl),
        atRest(state.method.equilibrium())
  {
  }

  KOKKOS_INLINE_FUNCTION double operator()(int node, int axis) const
  {
    return atRest ? 0.0 : byMotion ? motion(node, axis) : projection(node, axis);
  }
};

/// Velocity [m/s] relative to that of the disk, acceleration [m/s2] and slopes of the velocity [1/s],
/// dv[i][j] = v_i,j.
template <int D>
struct ParticleMotion
{
  Vector<D> v{}, a{};
  double dv[D][D] = {};
};

/// With USL, the contribution of a node that a box reaches by round-off only would be arbitrary. Such nodes
/// are left out, which changes a slope by less than 1e-10 of the contribution of neighbours.
constexpr double leastFraction = 1e-20;

/// \param mean velocity of the disk, subtracted
template <int D, class Connect, class Acceleration>
KOKKOS_INLINE_FUNCTION ParticleMotion<D>
particleMotion(const Connect& connect, int p, const NodalVelocity<D>& velocity,
               const Acceleration& acceleration, const Vector<D>& mean)
{
  ParticleMotion<D> is;
  connect.visit(p,
                [&](int node, double weight, const double* slope)
                {
                  if (weight < leastFraction)
                    return;
                  for (int i = 0; i < D; ++i)
                  {
                    is.v[i] += weight * (velocity(node, i) - mean[i]);
                    is.a[i] += weight * acceleration(node, i);
                    for (int j = 0; j < D; ++j)
                      is.dv[i][j] += slope[j] * velocity(node, i);
                  }
                });
  return is;
}

} // namespace Rhegma::energy_release
