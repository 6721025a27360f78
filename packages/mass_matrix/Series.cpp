#include "mass_matrix/Series.hpp"

#include "state/Subdomain.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma::mass_matrix
{

namespace
{

/// image += sum of m N (N . rows) over the particles of a block.
template <int D, int Width, class Connect>
struct MassTimesBlock
{
  Connect connect;
  View<double*[Width]> rows, image;
  BorrowedView<double*> mass;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    const double* const from = rows.data();
    double* const to = image.data();
    connect.forEachParticle(begin, end,
                            [&](int p, const auto& stencil)
                            {
                              const Pack<Width> seen = stencil.template value<Width, Width>(from);
                              stencil.template addValue<Width>(to, mass(p) * seen);
                            });
  }
};

template <int D, int Width>
void addMassTimes(const State<D>& state, const View<double* [Width]>& rows,
                  const View<double* [Width]>& image)
{
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     const MassTimesBlock<D, Width, Connect> block{connect, rows, image,
                                                                   state.particles.scalar(fields::mass)};
                     forEachBlock("rhegma::mass::seriesProduct", state.mesh.blocks, block);
                   });
}

/// Adds the terms 1 .. order - 1 to rows that hold term 0. \param image zero, and left so
template <int D, int Width>
void addTerms(const State<D>& state, int order, const View<double* [Width]>& sum, View<double* [Width]>& term,
              View<double* [Width]>& image)
{
  if (image.extent(0) < state.mesh.nodes.sums.extent(0))
  {
    image = View<double* [Width]>("rhegma::seriesImage", state.mesh.nodes.sums.extent(0));
    if (order > 2)
      term = View<double* [Width]>("rhegma::seriesTerm", state.mesh.nodes.sums.extent(0));
  }
  const Nodes<D> nodes = state.mesh.nodes;
  const View<double*[Width]> next = term, product = image;
  for (int k = 1; k < order; ++k)
  {
    const View<double* [Width]> now = k == 1 ? sum : term;
    const bool more = k + 1 < order;
    addMassTimes<D, Width>(state, now, image);
    sumOverRanks(state, image.data(), Width, 0, Width);
    Kokkos::parallel_for(
        "rhegma::mass::nextTerm", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
        KOKKOS_LAMBDA(const int i) {
          const int n = activeNode(nodes, i);
          const double mass = nodes.sums(n, Nodes<D>::massAt), inverse = mass > 0.0 ? 1.0 / mass : 0.0;
          for (int c = 0; c < Width; ++c)
          {
            const double t = now(n, c) - inverse * product(n, c);
            product(n, c) = 0.0;
            if (more)
              next(n, c) = t;
            sum(n, c) += t;
          }
        });
  }
}

} // namespace

template <int D>
void Series<D>::motion(State<D>& state)
{
  addTerms<D, Nodes<D>::motionWidth>(state, order_, state.mesh.nodes.motion, motionTerm_, motionImage_);
}

template <int D>
void Series<D>::updateVelocity(State<D>& state, bool withImpulse)
{
  const Nodes<D> nodes = state.mesh.nodes;
  if (filtered_.extent(0) < nodes.sums.extent(0))
    filtered_ = VelocityRows("rhegma::filteredVelocity", nodes.sums.extent(0));
  const VelocityRows filtered = filtered_;
  const double dt = state.clock.dt, impulse = withImpulse ? dt : 0.0, rest = withImpulse ? 0.0 : dt;
  Kokkos::parallel_for(
      "rhegma::mass::firstTerm", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        const double mass = nodes.sums(n, Nodes<D>::massAt), inverse = mass > 0.0 ? 1.0 / mass : 0.0;
        for (int d = 0; d < D; ++d)
          filtered(n, d) = inverse * (nodes.sums(n, Nodes<D>::momentumAt + d) +
                                      impulse * nodes.sums(n, Nodes<D>::forceAt + d));
      });
  addTerms<D, Nodes<D>::projectionWidth>(state, order_, filtered_, term_, image_);
  Kokkos::parallel_for(
      "rhegma::mass::filteredVelocity", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        for (int d = 0; d < D; ++d)
          nodes.motion(n, d) = filtered(n, d) + rest * nodes.motion(n, Nodes<D>::accelerationAt + d);
      });
}

template <int D>
void Series<D>::projection(State<D>& state)
{
  addTerms<D, Nodes<D>::projectionWidth>(state, order_, state.mesh.nodes.projection, term_, image_);
}

template class Series<2>;
template class Series<3>;

} // namespace Rhegma::mass_matrix
