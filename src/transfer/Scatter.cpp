#include "transfer/Scatter.hpp"

#include "state/CellFrame.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma
{

namespace
{

/// Adds a block of particles: N (m, m v) to mass and momentum, -V0 tau grad N to force; see CellFrame.
template <int D, class Connect, bool Momentum, bool Force>
struct ScatterBlock
{
  static constexpr int forceWidth = D == 2 ? 2 : 4;
  Connect connect;
  View<double * [Nodes<D>::sumWidth]> sums;
  BorrowedView<double*> mass, volume;
  BorrowedView<double* [D]> velocity;
  BorrowedView<double * [symmetricSize<D>]> stress;
  CellFrame<D> frame;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    double* const rows = sums.data();
    connect.forEachParticle(begin, end,
                            [&](int p, const auto& stencil)
                            {
                              if constexpr (Momentum)
                                stencil.template addValue<Nodes<D>::sumWidth>(rows, massAndMomentum(p));
                              if constexpr (Force)
                              {
                                Pack<forceWidth> flux[D];
                                fluxOf(p, flux);
                                stencil.template addFlux<Nodes<D>::sumWidth>(rows + Nodes<D>::forceAt, flux);
                                if constexpr (std::decay_t<decltype(stencil)>::mayHaveHoop)
                                  if (stencil.hasHoop())
                                    stencil.template addHoop<Nodes<D>::sumWidth>(rows + Nodes<D>::forceAt,
                                                                                 hoopForce(p));
                              }
                            });
  }

  KOKKOS_FORCEINLINE_FUNCTION Pack<4> massAndMomentum(int p) const
  {
    static_assert(Nodes<D>::massAt == 0 && Nodes<D>::momentumAt == 1, "the layout of a row");
    const double m = mass(p);
    return pack(m, m * velocity(p, 0), m * velocity(p, 1), D == 2 ? 0.0 : m * velocity(p, D - 1));
  }

  /// -V0 times the hoop stress in the cells, of axisymmetric scenes.
  KOKKOS_FORCEINLINE_FUNCTION double hoopForce(int p) const
  {
    return -volume(p) * stress(p, normalIndex<D>(2)) * frame.hoopFactor(p);
  }

  /// Columns of -V0 times the stress in the cells.
  KOKKOS_FORCEINLINE_FUNCTION void fluxOf(int p, Pack<forceWidth> (&flux)[D]) const
  {
    const double v = -volume(p);
    double T[D * D];
    frame.stress(p, &stress(p, 0), T);
    for (int j = 0; j < D; ++j)
    {
      if constexpr (D == 2)
        flux[j] = pack(v * T[j], v * T[D + j]);
      else
        flux[j] = pack(v * T[j], v * T[D + j], v * T[2 * D + j], 0.0);
    }
  }
};

template <bool Momentum, bool Force, int D, class Connect>
void scatterWith(State<D>& state, const Connect& connect, const char* label)
{
  ScatterBlock<D, Connect, Momentum, Force> block;
  block.connect = connect;
  block.sums = state.mesh.nodes.sums;
  block.mass = state.particles.scalar(fields::mass);
  block.volume = state.particles.scalar(fields::volume);
  block.velocity = state.particles.template real<D>(fields::velocity);
  block.stress = state.particles.template real<symmetricSize<D>>(fields::stress);
  block.frame = CellFrame<D>(state);
  forEachBlock(label, state.mesh.blocks, block);
}

template <int D>
KOKKOS_INLINE_FUNCTION void clearProjectionOf(const Nodes<D>& nodes, int node)
{
  for (int k = 0; k < Nodes<D>::projectionWidth; ++k)
    nodes.projection(node, k) = 0.0;
}

} // namespace

template <int D>
void clearNodes(State<D>& state)
{
  const Nodes<D> nodes = state.mesh.nodes;
  Kokkos::parallel_for(
      "rhegma::clearNodes", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()), KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        for (int k = 0; k < Nodes<D>::sumWidth; ++k)
          nodes.sums(n, k) = 0.0;
        clearProjectionOf(nodes, n);
      });
}

template <int D>
void clearProjection(State<D>& state)
{
  const Nodes<D> nodes = state.mesh.nodes;
  Kokkos::parallel_for(
      "rhegma::clearProjection", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) { clearProjectionOf(nodes, activeNode(nodes, i)); });
}

template <int D>
void scatter(State<D>& state, ScatterWhat what)
{
  if (what == ScatterWhat::MassAndMomentum)
    withConnectivity(state, [&](const auto& connect)
                     { scatterWith<true, false>(state, connect, "rhegma::scatterMassMomentum"); });
  else
    withStraining(state,
                  [&](const auto& connect)
                  {
                    if (what == ScatterWhat::All)
                      scatterWith<true, true>(state, connect, "rhegma::scatterMassMomentumForce");
                    else
                      scatterWith<false, true>(state, connect, "rhegma::scatterForce");
                  });
}

template void clearNodes(State<2>&);
template void clearNodes(State<3>&);
template void clearProjection(State<2>&);
template void clearProjection(State<3>&);
template void scatter(State<2>&, ScatterWhat);
template void scatter(State<3>&, ScatterWhat);

} // namespace Rhegma
