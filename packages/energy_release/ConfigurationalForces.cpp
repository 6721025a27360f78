#include "energy_release/ConfigurationalForces.hpp"

#include "energy_release/ParticleHeat.hpp"
#include "material/Materials.hpp"
#include "state/CellFrame.hpp"
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

MeanMotion meanMotion(const State<D>& state, const ParticlesOfGroup& own, const Region<D>& box,
                      const BlocksInReach<D>& blocks)
{
  const auto position = state.particles.real<D>(fields::position);
  const auto velocity = state.particles.real<D>(fields::velocity);
  const auto F = state.particles.real<gradientSize<D>>(fields::deformation);
  double sums[D * D + D + 1]; // of the gradient, of velocity, number
  blocks.sumOverParticles(
      "rhegma::meanMotionOfFront",
      KOKKOS_LAMBDA(const int p, double(&sum)[D * D + D + 1]) {
        if (!own.hold(p) || !box.holds({position(p, 0), position(p, 1), position(p, 2)}))
          return;
        for (int k = 0; k < D * D; ++k)
          sum[k] += F(p, k);
        for (int i = 0; i < D; ++i)
          sum[D * D + i] += velocity(p, i);
        sum[D * D + D] += 1.0;
      },
      sums);
  sumParts(state, sums, D * D + D + 1);
  const double count = sums[D * D + D];
  MeanMotion mean;
  if (count == 0.0)
    return mean;
  for (int i = 0; i < D; ++i)
  {
    mean.velocity[i] = sums[D * D + i] / count;
    for (int j = 0; j < D; ++j)
      mean.turn[i][j] = sums[D * i + j] / count;
  }
  nearestRotation(mean.turn);
  return mean;
}

/// Adds the configurational forces of a block of particles to the nodes.
template <class Connect>
struct ForceBlock
{
  static constexpr int width = 4;
  Connect connect;
  ParticlesOfGroup own;
  Region<D> box;
  MeanMotion mean;
  ConfigurationalForces force;
  View<double * [4 * D]> moments; ///< of accelerations (FrontRowTable)
  FrontRows<D> rows;              ///< of the nodes
  BorrowedView<double* [D]> position;
  BorrowedView<double*> mass, volume;
  BorrowedView<double * [gradientSize<D>]> deformation;
  BorrowedView<double * [symmetricSize<D>]> stress;
  BorrowedView<double**> history;
  BorrowedView<int*> material;
  View<Properties*> materials;
  ParticleHeat<D> heat;
  bool moving;
  CellFrame<D> frame;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int first = begin; first < end; first += lanes)
    {
      const int last = end - first < lanes ? end : first + lanes;
      int in = 0;
      for (int p = first; p < last; ++p)
        in += isIn(p) ? 1 : 0;
      if (in > 0)
        connect.forEachParticle(first, last,
                                [&](int p, const auto& stencil)
                                {
                                  if (isIn(p))
                                    add(p, stencil);
                                });
    }
  }

  KOKKOS_INLINE_FUNCTION bool isIn(int p) const
  {
    return own.hold(p) && box.holds({position(p, 0), position(p, 1), position(p, 2)});
  }

  /// The image in the cells of each axis of the tube, which turns with the body unless the cells are
  /// undeformed, and u,k relative to the turned tube. \param F of the particle
  KOKKOS_INLINE_FUNCTION void findImages(const double* F, double (&image)[D][D], double (&du)[D][D]) const
  {
    for (int i = 0; i < D; ++i)
      for (int k = 0; k < D; ++k)
      {
        const double unit = i == k ? 1.0 : 0.0;
        double now = 0.0;
        for (int j = 0; j < D && !frame.undeformed; ++j)
          now += F[D * i + j] * mean.turn[k][j];
        image[i][k] = frame.undeformed ? unit : now;
        du[i][k] = frame.undeformed ? F[D * i + k] - mean.turn[i][k] : now - unit;
      }
  }

  template <class Stencil>
  KOKKOS_INLINE_FUNCTION void add(int p, const Stencil& stencil) const
  {
    Vector<D> v{};
    double dv[D][D] = {};
    if (moving)
    {
      Pack<8> change[D];
      const Pack<8> motion =
          stencil.template valueAndGradient<FrontRows<D>::width>(rows.data + FrontRows<D>::motionAt, change);
      for (int i = 0; i < D; ++i)
      {
        v[i] = motion[i] - mean.velocity[i];
        for (int j = 0; j < D; ++j)
          dv[i][j] = change[j][i];
      }
    }
    const double* F = &deformation(p, 0);
    const double* tau = &stress(p, 0);
    double T[D * D];
    frame.stress(p, tau, T);
    const double density = mass(p) / volume(p);
    const double* variables = history.extent(1) > 0 ? &history(p, 0) : nullptr;
    const Properties& law = materials(material(p));
    const double energy = heat.energy(p, material(p), law, F, variables) + 0.5 * density * dot(v, v);
    double image[D][D], du[D][D];
    findImages(F, image, du);
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
          flux[k][j] += T[D * i + j] * du[i][k];
          dvk += dv[j][i] * image[i][k];
        }
        inertia[k] -= density * v[j] * dvk;
      }
      const Vector<D> along{image[0][k], image[1][k], image[2][k]};
      inertia[k] -= heat.energyAlong(p, material(p), law, F, tau, variables, along);
    }
    const double V = volume(p);
    Pack<4> along[D];
    for (int j = 0; j < D; ++j)
      along[j] = pack(V * flux[0][j], V * flux[1][j], V * flux[2][j], 0.0);
    stencil.template addFlux<width>(force.data(), along);
    stencil.template addValue<width>(force.data(), pack(V * inertia[0], V * inertia[1], V * inertia[2], 0.0));
    const double m = mass(p);
    for (int i = 0; i < D && moving; ++i)
      stencil.template addValue<4 * D>(moments.data() + 4 * i,
                                       pack(m * du[i][0], m * du[i][1], m * du[i][2], 0.0));
  }
};

} // namespace

ConfigurationalForces configurationalForces(const State<3>& state, const ParticlesOfGroup& own,
                                            const Region<3>& box, const NodalAcceleration<3>& acceleration,
                                            const FrontWork<3>& kept)
{
  const Region<3> nodes = nodesOf(state, box);
  ConfigurationalForces force = kept.rows.clearForces(state, nodes);
  kept.blocks.find(state, {box});
  const MeanMotion mean = meanMotion(state, own, box, kept.blocks);
  const bool moving = haveNodalValues(state);
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     ForceBlock<Connect> block{connect,
                                               own,
                                               box,
                                               mean,
                                               force,
                                               kept.rows.clearMoments(state, nodes, moving),
                                               kept.rows.fillMotion(state, nodes, moving, acceleration),
                                               state.particles.real<D>(fields::position),
                                               state.particles.scalar(fields::mass),
                                               state.particles.scalar(fields::volume),
                                               state.particles.real<gradientSize<D>>(fields::deformation),
                                               state.particles.real<symmetricSize<D>>(fields::stress),
                                               {},
                                               state.particles.integer(fields::material),
                                               state.materials.device,
                                               ParticleHeat<D>(state),
                                               moving,
                                               CellFrame<D>(state)};
                     if (state.particles.has(fields::history))
                       block.history = state.particles.table(fields::history);
                     kept.blocks.forEach("rhegma::configurationalForce", block);
                   });
  kept.rows.addWorkOfAcceleration(state, nodes);
  return force;
}

} // namespace Rhegma::energy_release
