#pragma once
/// The motion that nodes give a particle in the integrals round a front.

#include "state/Types.hpp"

namespace Rhegma::energy_release
{

/// Velocity [m/s] beside that of the disk, acceleration [m/s2] and slopes of the velocity [1/s], dv[i][j] =
/// v_i,j.
template <int D>
struct ParticleMotion
{
  Vector<D> v{}, a{};
  double dv[D][D] = {};
};

/// A node that a particle's box reaches by its last digit has a mass of the square of that length and a force
/// of its first power: its velocity is any number, and what its slope makes of it hangs on round-off. Such
/// nodes are left out; what that changes of a slope is below 1e-10 of the neighbours' share.
constexpr double leastShare = 1e-20;

/// \param mean velocity of the disk, taken off
template <int D, class Connect, class Motion, class Acceleration>
KOKKOS_INLINE_FUNCTION ParticleMotion<D> particleMotion(const Connect& connect, int p, const Motion& motion,
                                                        const Acceleration& acceleration,
                                                        const Vector<D>& mean)
{
  ParticleMotion<D> is;
  connect.visit(p,
                [&](int node, double share, const double* slope)
                {
                  if (share < leastShare)
                    return;
                  for (int i = 0; i < D; ++i)
                  {
                    is.v[i] += share * (motion(node, i) - mean[i]);
                    is.a[i] += share * acceleration(node, i);
                    for (int j = 0; j < D; ++j)
                      is.dv[i][j] += slope[j] * motion(node, i);
                  }
                });
  return is;
}

} // namespace Rhegma::energy_release
