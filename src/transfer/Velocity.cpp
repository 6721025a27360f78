#include "transfer/Velocity.hpp"

#include "transfer/ParticleViews.hpp"

namespace Rhegma
{

namespace
{

template <int D, class Connect, bool Gather, bool Project>
struct VelocityBlock
{
  static constexpr int width = D == 2 ? 2 : 4;
  Connect connect;
  View<double * [Nodes<D>::motionWidth]> motion;
  View<double * [Nodes<D>::projectionWidth]> projection;
  BorrowedView<double*> mass;
  BorrowedView<double* [D]> velocity;
  View<double*> taken; ///< kinetic energy that PIC takes from each particle [J]; empty without PIC
  double dt, pic;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    const double* const moving = motion.data();
    double* const projected = projection.data();
    connect.forEachParticle(begin, end,
                            [&](int p, const auto& stencil)
                            {
                              if constexpr (Gather)
                                change(p, stencil, moving);
                              if constexpr (Project)
                                stencil.template addValue<Nodes<D>::projectionWidth>(projected, momentum(p));
                            });
  }

  KOKKOS_FORCEINLINE_FUNCTION Pack<width> momentum(int p) const
  {
    const double m = mass(p);
    if constexpr (D == 2)
      return pack(m * velocity(p, 0), m * velocity(p, 1));
    else
      return pack(m * velocity(p, 0), m * velocity(p, 1), m * velocity(p, 2), 0.0);
  }

  template <class Stencil>
  KOKKOS_FORCEINLINE_FUNCTION void change(int p, const Stencil& stencil, const double* moving) const
  {
    constexpr int rowWidth = Nodes<D>::motionWidth;
    const Pack<width> acceleration =
        stencil.template value<rowWidth, width>(moving + Nodes<D>::accelerationAt);
    if (pic == 0.0)
      for (int d = 0; d < D; ++d)
        velocity(p, d) += dt * acceleration[d];
    else
    {
      const Pack<width> nodal = stencil.template value<rowWidth, width>(moving);
      double lost = 0.0;
      for (int d = 0; d < D; ++d)
      {
        const double flip = velocity(p, d) + dt * acceleration[d];
        const double mixed = (1.0 - pic) * flip + pic * nodal[d];
        velocity(p, d) = mixed;
        lost += (flip - mixed) * (flip + mixed);
      }
      taken(p) = 0.5 * mass(p) * lost;
    }
  }
};

double sumOf(const View<double*>& values)
{
  double all = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::sumFilteredEnergy", Kokkos::RangePolicy<ExecSpace>(0, static_cast<int>(values.extent(0))),
      KOKKOS_LAMBDA(const int p, double& sum) { sum += values(p); }, all);
  return all;
}

template <bool Gather, bool Project, int D, class Connect>
void velocityWith(State<D>& state, const Connect& connect, const char* label)
{
  const bool filters = Gather && state.method.picFraction > 0.0;
  const View<double*> taken("rhegma::filteredEnergy", filters ? state.particles.size() : 0);
  const VelocityBlock<D, Connect, Gather, Project> block{connect,
                                                         state.mesh.nodes.motion,
                                                         state.mesh.nodes.projection,
                                                         state.particles.scalar(fields::mass),
                                                         state.particles.template real<D>(fields::velocity),
                                                         taken,
                                                         state.clock.dt,
                                                         state.method.picFraction};
  forEachBlock(label, state.mesh.blocks, block);
  if (filters)
    state.energy.filtered += sumOf(taken);
}

} // namespace

template <int D>
void particleVelocity(State<D>& state, VelocityWhat what)
{
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     if (what == VelocityWhat::Gather)
                       velocityWith<true, false>(state, connect, "rhegma::gatherVelocity");
                     else if (what == VelocityWhat::Project)
                       velocityWith<false, true>(state, connect, "rhegma::projectVelocity");
                     else
                       velocityWith<true, true>(state, connect, "rhegma::gatherAndProjectVelocity");
                   });
}

template <int D>
void finishProjection(State<D>& state)
{
  const Nodes<D> nodes = state.mesh.nodes;
  Kokkos::parallel_for(
      "rhegma::finishProjection", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        const double mass = nodes.sums(n, Nodes<D>::massAt);
        const double inverse = mass > 0.0 ? 1.0 / mass : 0.0;
        for (int d = 0; d < D; ++d)
          nodes.projection(n, d) *= inverse;
      });
}

template void particleVelocity(State<2>&, VelocityWhat);
template void particleVelocity(State<3>&, VelocityWhat);
template void finishProjection(State<2>&);
template void finishProjection(State<3>&);

} // namespace Rhegma
