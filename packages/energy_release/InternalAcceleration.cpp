#include "energy_release/InternalAcceleration.hpp"

#include "parallel/Subdomain.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma::energy_release
{

namespace
{

constexpr int D = 2;

/// Adds the forces of a block of particles to the nodes.
template <class Connect>
struct ForceBlock
{
  Connect connect;
  View<double* [D]> force;
  BorrowedView<double* [D]> position;
  BorrowedView<double*> volume;
  BorrowedView<double * [symmetricSize<D>]> stress;
  Vector<D> centre;
  double radius;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
    {
      const double x = position(p, 0) - centre[0], y = position(p, 1) - centre[1];
      if (x * x + y * y > radius * radius)
        continue;
      connect.visit(p,
                    [&](int node, double, const double* slope)
                    {
                      for (int i = 0; i < D; ++i)
                        for (int j = 0; j < D; ++j)
                          force(node, i) -= volume(p) * stress(p, symmetricIndex<D>(i, j)) * slope[j];
                    });
    }
  }
};

/// Ties hold the front together, as the material does.
void addTies(const State<D>& state, const View<double* [D]>& force)
{
  const View<double * [D + 1]> tie = state.cracks.tie;
  if (tie.extent(0) == 0)
    return;
  const Nodes<D> nodes = state.nodes;
  Kokkos::parallel_for(
      "rhegma::internalTies", Kokkos::RangePolicy<ExecSpace>(0, nodes.numSecond), KOKKOS_LAMBDA(const int i) {
        const int n = nodes.parent(i), m = nodes.numLattice + i;
        for (int d = 0; d < D; ++d)
        {
          force(n, d) += tie(n, d);
          force(m, d) -= tie(n, d);
        }
      });
}

void divideByMass(const Nodes<D>& nodes, const View<double* [D]>& force)
{
  Kokkos::parallel_for(
      "rhegma::internalAcceleration", Kokkos::RangePolicy<ExecSpace>(0, force.extent(0)),
      KOKKOS_LAMBDA(const int n) {
        const double mass = nodes.sums(n, Nodes<D>::massAt);
        for (int i = 0; i < D; ++i)
          force(n, i) = mass > 0.0 ? force(n, i) / mass : 0.0;
      });
}

} // namespace

View<double* [D]> internalAcceleration(const State<D>& state, const Vector<D>& centre, double radius)
{
  View<double* [D]> acceleration;
  internalAcceleration(state, centre, radius, acceleration);
  return acceleration;
}

void internalAcceleration(const State<D>& state, const Vector<D>& centre, double radius,
                          View<double* [D]>& force)
{
  if (force.extent(0) != state.nodes.sums.extent(0))
    force = View<double* [D]>("rhegma::internalForce", state.nodes.sums.extent(0));
  else
    Kokkos::deep_copy(force, 0.0);
  if (state.step == 0 || force.extent(0) == 0) // nodes have no mass before the first step
    return;
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     const ForceBlock<Connect> block{connect,
                                                     force,
                                                     state.particles.real<D>(fields::position),
                                                     state.particles.scalar(fields::volume),
                                                     state.particles.real<symmetricSize<D>>(fields::stress),
                                                     centre,
                                                     radius};
                     forEachBlock("rhegma::internalForce", state.blocks, block);
                   });
  sumOverRanks(state, force.data(), D, 0, D);
  addTies(state, force);
  divideByMass(state.nodes, force);
}

} // namespace Rhegma::energy_release
