#include "transfer/Scatter.hpp"

#include "transfer/ParticleViews.hpp"

namespace Rhegma
{

namespace
{

/// Adds a block of particles. A node's row changes by N a + sum_j dN/dx_j b_j: a holds mass and momentum, b_j
/// column j of -V0 tau, each laid out like the row, so that the compiler makes it a few vector operations a
/// node.
template <int D, class Connect, bool Momentum, bool Force>
struct ScatterBlock
{
  static constexpr int width = D == 2 ? 6 : 8;
  Connect connect;
  View<double * [Nodes<D>::sumWidth]> sums;
  BorrowedView<double*> mass, volume;
  BorrowedView<double* [D]> velocity;
  BorrowedView<double * [symmetricSize<D>]> stress;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
    {
      double value[width] = {};
      double flux[D][width] = {};
      if constexpr (Momentum)
      {
        value[Nodes<D>::massAt] = mass(p);
        for (int d = 0; d < D; ++d)
          value[Nodes<D>::momentumAt + d] = mass(p) * velocity(p, d);
      }
      if constexpr (Force)
        for (int j = 0; j < D; ++j)
          for (int i = 0; i < D; ++i)
            flux[j][Nodes<D>::forceAt + i] = -volume(p) * stress(p, symmetricIndex<D>(i, j));
      connect.visit(p,
                    [&](int node, double weight, const double* slope)
                    {
                      double* row = &sums(node, 0);
                      for (int k = 0; k < width; ++k)
                      {
                        double add = weight * value[k];
                        if constexpr (Force)
                          for (int j = 0; j < D; ++j)
                            add += slope[j] * flux[j][k];
                        row[k] += add;
                      }
                    });
    }
  }
};

template <int D, class Connect>
struct ScatterProjectionBlock
{
  Connect connect;
  View<double * [Nodes<D>::projectionWidth]> projection;
  BorrowedView<double*> mass;
  BorrowedView<double* [D]> velocity;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
    {
      double momentum[D];
      for (int d = 0; d < D; ++d)
        momentum[d] = mass(p) * velocity(p, d);
      connect.visit(p,
                    [&](int node, double weight, const double*)
                    {
                      for (int d = 0; d < D; ++d)
                        projection(node, d) += weight * momentum[d];
                    });
    }
  }
};

template <bool Momentum, bool Force, int D, class Connect>
void scatterWith(State<D>& state, const Connect& connect, const char* label)
{
  ScatterBlock<D, Connect, Momentum, Force> block;
  block.connect = connect;
  block.sums = state.nodes.sums;
  block.mass = state.particles.scalar(fields::mass);
  block.volume = state.particles.scalar(fields::volume);
  block.velocity = state.particles.template real<D>(fields::velocity);
  block.stress = state.particles.template real<symmetricSize<D>>(fields::stress);
  forEachBlock(label, state.blocks, block);
}

} // namespace

template <int D>
void clearNodes(State<D>& state)
{
  const Nodes<D> nodes = state.nodes;
  Kokkos::parallel_for(
      "rhegma::clearNodes", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()), KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        for (int k = 0; k < Nodes<D>::sumWidth; ++k)
          nodes.sums(n, k) = 0.0;
      });
}

template <int D>
void scatter(State<D>& state, ScatterWhat what)
{
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     if (what == ScatterWhat::All)
                       scatterWith<true, true>(state, connect, "rhegma::scatterMassMomentumForce");
                     else if (what == ScatterWhat::MassAndMomentum)
                       scatterWith<true, false>(state, connect, "rhegma::scatterMassMomentum");
                     else
                       scatterWith<false, true>(state, connect, "rhegma::scatterForce");
                   });
}

template <int D>
void scatterProjection(State<D>& state)
{
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     const ScatterProjectionBlock<D, Connect> block{
                         connect, state.nodes.projection, state.particles.scalar(fields::mass),
                         state.particles.template real<D>(fields::velocity)};
                     forEachBlock("rhegma::scatterProjection", state.blocks, block);
                   });
}

template void clearNodes(State<2>&);
template void clearNodes(State<3>&);
template void scatter(State<2>&, ScatterWhat);
template void scatter(State<3>&, ScatterWhat);
template void scatterProjection(State<2>&);
template void scatterProjection(State<3>&);

} // namespace Rhegma
