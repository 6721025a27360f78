#include "energy_release/ConfigurationalForces.hpp"

#include "energy_release/ParticleHeat.hpp"
#include "energy_release/ParticleMotion.hpp"
#include "material/Materials.hpp"
#include "state/NodalValues.hpp"
#include "state/Subdomain.hpp"
#include "transfer/ParticleViews.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::energy_release
{

namespace
{

constexpr int D = 3;

/// The mean motion of the tube.
struct MeanMotion
{
  double turn[D][D] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  Vector<D> velocity{{0.0, 0.0, 0.0}}; ///< [m/s]
};

/// The rotation of a polar decomposition: the mean of a matrix and its inverse transposed, over and over
/// (Higham, SIAM J. Sci. Stat. Comput. 7 (1986) 1160).
void nearestRotation(double (&a)[D][D])
{
  for (int turns = 0; turns < 30; ++turns)
  {
    double cofactor[D][D], change = 0.0;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
      {
        const int k = (i + 1) % D, l = (i + 2) % D, m = (j + 1) % D, n = (j + 2) % D;
        cofactor[i][j] = a[k][m] * a[l][n] - a[k][n] * a[l][m];
      }
    const double determinant = a[0][0] * cofactor[0][0] + a[0][1] * cofactor[0][1] + a[0][2] * cofactor[0][2];
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
      {
        const double next = 0.5 * (a[i][j] + cofactor[i][j] / determinant);
        change = std::max(change, std::fabs(next - a[i][j]));
        a[i][j] = next;
      }
    if (change < 1e-15)
      return;
  }
}

MeanMotion meanMotion(const State<D>& state, const Region<D>& box)
{
  const auto position = state.particles.real<D>(fields::position);
  const auto velocity = state.particles.real<D>(fields::velocity);
  const auto F = state.particles.real<gradientSize<D>>(fields::deformation);
  MeanMotion mean;
  for (int i = 0; i < D; ++i)
  {
    double sums[D + 2] = {}; // of a row of the gradient, of the velocity's component, number
    Kokkos::parallel_reduce(
        "rhegma::meanMotionOfFront", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
        KOKKOS_LAMBDA(const int p, double& x, double& y, double& z, double& v, double& number) {
          if (!box.holds({position(p, 0), position(p, 1), position(p, 2)}))
            return;
          x += F(p, D * i);
          y += F(p, D * i + 1);
          z += F(p, D * i + 2);
          v += velocity(p, i);
          number += 1.0;
        },
        sums[0], sums[1], sums[2], sums[3], sums[4]);
    sumParts(state, sums, D + 2);
    const double count = sums[D + 1];
    if (count == 0.0)
      return {};
    mean.velocity[i] = sums[D] / count;
    for (int j = 0; j < D; ++j)
      mean.turn[i][j] = sums[j] / count;
  }
  nearestRotation(mean.turn);
  return mean;
}

/// Adds the configurational forces of a block of particles to the nodes.
template <class Connect>
struct ForceBlock
{
  Connect connect;
  Region<D> box;
  MeanMotion mean;
  View<double* [D]> force;
  NodalVelocity<D> motion;
  NodalAcceleration<D> acceleration;
  BorrowedView<double* [D]> position;
  BorrowedView<double*> mass, volume;
  BorrowedView<double * [gradientSize<D>]> deformation;
  BorrowedView<double * [symmetricSize<D>]> stress;
  BorrowedView<double**> history;
  BorrowedView<int*> material;
  View<Properties*> materials;
  ParticleHeat<D> heat;
  bool moving;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
      if (box.holds({position(p, 0), position(p, 1), position(p, 2)}))
        add(p);
  }

  KOKKOS_INLINE_FUNCTION void add(int p) const
  {
    ParticleMotion<D> is;
    if (moving)
      is = particleMotion(connect, p, motion, acceleration, mean.velocity);
    const Vector<D>&v = is.v, &a = is.a;
    const auto& dv = is.dv;
    const double* F = &deformation(p, 0);
    const double* tau = &stress(p, 0);
    const double density = mass(p) / volume(p);
    const double* variables = history.extent(1) > 0 ? &history(p, 0) : nullptr;
    const Properties& law = materials(material(p));
    const double energy = heat.energy(p, material(p), law, F, variables) + 0.5 * density * dot(v, v);
    // The image of each axis of the turned tube, and u,k relative to it.
    double image[D][D], du[D][D];
    for (int i = 0; i < D; ++i)
      for (int k = 0; k < D; ++k)
      {
        image[i][k] = 0.0;
        for (int j = 0; j < D; ++j)
          image[i][k] += F[D * i + j] * mean.turn[k][j];
        du[i][k] = image[i][k] - (i == k ? 1.0 : 0.0);
      }
    double flux[D][D],
        inertia[D]; // of a shift along axis k: (k, slope's axis), and what goes with the weight itself
    for (int k = 0; k < D; ++k)
    {
      inertia[k] = 0.0;
      for (int j = 0; j < D; ++j)
      {
        flux[k][j] = -energy * image[j][k];
        double dvk = 0.0; // of velocity's component j along the image of the axis
        for (int i = 0; i < D; ++i)
        {
          flux[k][j] += tau[symmetricIndex<D>(i, j)] * du[i][k];
          dvk += dv[j][i] * image[i][k];
        }
        inertia[k] += density * (a[j] * du[j][k] - v[j] * dvk);
      }
      const Vector<D> along{image[0][k], image[1][k], image[2][k]};
      inertia[k] -= heat.energyAlong(p, material(p), law, F, tau, variables, along);
    }
    const double V = volume(p);
    connect.visit(p,
                  [&](int node, double fraction, const double* slope)
                  {
                    for (int k = 0; k < D; ++k)
                      force(node, k) += V * (flux[k][0] * slope[0] + flux[k][1] * slope[1] +
                                             flux[k][2] * slope[2] + inertia[k] * fraction);
                  });
  }
};

} // namespace

View<double* [3]> configurationalForces(const State<3>& state, const Region<3>& box,
                                        const NodalAcceleration<3>& acceleration)
{
  View<double* [D]> force("rhegma::configurationalForce", state.mesh.nodes.sums.extent(0));
  const MeanMotion mean = meanMotion(state, box);
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     ForceBlock<Connect> block{connect,
                                               box,
                                               mean,
                                               force,
                                               NodalVelocity<D>(state),
                                               acceleration,
                                               state.particles.real<D>(fields::position),
                                               state.particles.scalar(fields::mass),
                                               state.particles.scalar(fields::volume),
                                               state.particles.real<gradientSize<D>>(fields::deformation),
                                               state.particles.real<symmetricSize<D>>(fields::stress),
                                               {},
                                               state.particles.integer(fields::material),
                                               state.materials.device,
                                               ParticleHeat<D>(state),
                                               haveNodalValues(state)};
                     if (state.particles.has(fields::history))
                       block.history = state.particles.table(fields::history);
                     forEachBlock("rhegma::configurationalForce", state.mesh.blocks, block);
                   });
  return force;
}

} // namespace Rhegma::energy_release
