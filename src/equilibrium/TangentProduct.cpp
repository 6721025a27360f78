#include "equilibrium/TangentProduct.hpp"

#include "equilibrium/ParticleRows.hpp"
#include "transfer/ParticleViews.hpp"

#include <algorithm>

namespace Rhegma::equilibrium
{

namespace
{

template <int D>
constexpr int tangentSize = D* D*(D* D + 1) / 2;

/// Finds the tangent of each particle.
template <int D, class Connect>
struct FindTangents
{
  Connect connect;
  ParticleData<D> data;
  View<double**> tangent;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
    {
      RowsOfParticle<D, typename Connect::Slopes> rows;
      double G[D * D], A[D * D][D * D];
      data.see(connect, p, rows, G);
      if (!trialTangent<D>(data.before(p), G, A))
        Kokkos::atomic_exchange(&data.bad(), 1);
      data.pullBackBoth(p, A);
      for (int r = 0, at = 0; r < D * D; ++r)
        for (int c = r; c < D * D; ++c, ++at)
          tangent(p, at) = A[r][c];
    }
  }
};

/// Numbers of a node in a product.
template <int D>
constexpr int width = D == 2 ? 2 : 4;

/// The force of each particle on its nodes.
template <int D, class Connect>
struct ProductBlock
{
  Connect connect;
  BorrowedView<double*> volume;
  View<double**> tangent;
  View<double*> u, force; ///< of nodes

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    connect.forEachParticle(begin, end,
                            [&](int p, const auto& stencil)
                            {
                              Pack<width<D>> along[D];
                              stencil.template valueAndGradient<width<D>>(u.data(), along);
                              double H[D * D], P[D * D];
                              for (int i = 0; i < D; ++i)
                                for (int j = 0; j < D; ++j)
                                  H[i * D + j] = along[j][i];
                              multiply(p, H, P);
                              for (int j = 0; j < D; ++j)
                                if constexpr (D == 2)
                                  along[j] = pack(P[j], P[D + j]);
                                else
                                  along[j] = pack(P[j], P[D + j], P[2 * D + j], 0.0);
                              stencil.template addFlux<width<D>>(force.data(), along);
                            });
  }

  /// P = volume times tangent times H.
  KOKKOS_FORCEINLINE_FUNCTION void multiply(int p, const double (&H)[D * D], double (&P)[D * D]) const
  {
    for (double& stress : P)
      stress = 0.0;
    for (int r = 0, at = 0; r < D * D; ++r, ++at)
    {
      P[r] += tangent(p, at) * H[r];
      for (int c = r + 1; c < D * D; ++c)
      {
        const double A = tangent(p, ++at);
        P[r] += A * H[c];
        P[c] += A * H[r];
      }
    }
    for (double& stress : P)
      stress *= volume(p);
  }
};

template <int D, class Connect>
struct DiagonalBlock
{
  Connect connect;
  ParticleData<D> data;
  View<double**> tangent;
  Values diagonal;

  /// Entry of a symmetric tangent.
  KOKKOS_INLINE_FUNCTION double entry(int p, int r, int c) const
  {
    const int low = r < c ? r : c, high = r < c ? c : r;
    return tangent(p, low * D * D - low * (low - 1) / 2 + high - low);
  }

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
    {
      RowsOfParticle<D, typename Connect::Slopes> rows;
      double H[D * D];
      data.see(connect, p, rows, H);
      for (int a = 0; a < rows.count; ++a)
        for (int i = 0; i < D; ++i)
        {
          double sum = 0.0;
          for (int j = 0; j < D; ++j)
            for (int l = 0; l < D; ++l)
              sum += rows.slopes(a)(i, j) * entry(p, i * D + j, i * D + l) * rows.slopes(a)(i, l);
          diagonal(D * rows.row[a] + i) += data.volume(p) * sum;
        }
    }
  }
};

} // namespace

template <int D>
TangentProduct<D>::TangentProduct(const State<D>& state, const RowOwners& owners, const RowGraph& graph,
                                  const Resistances<D>& resistances, const Values& displacement)
    : state_(state),
      owners_(owners),
      graph_(graph),
      jumps_(resistances.jumps),
      tangent_(Kokkos::view_alloc(Kokkos::WithoutInitializing, "rhegma::equilibrium::tangents"),
               state.particles.size(), tangentSize<D>),
      ofNodes_("rhegma::equilibrium::ofNodes", width<D> * state.mesh.nodes.sums.extent(0)),
      forceOfNodes_("rhegma::equilibrium::forceOfNodes", width<D> * state.mesh.nodes.sums.extent(0))
{
  for (const auto& force : resistances.forces)
    symmetric_ = force->addStiffness(false,
                                     [&](int row, int other, const double(&value)[D * D])
                                     {
                                       blocks_.push_back({row, other, {}});
                                       std::copy(value, value + D * D, blocks_.back().value);
                                     }) &&
                 symmetric_;
  const ParticleData<D> data(state, graph, displacement);
  withStraining(state,
                [&](const auto& connect)
                {
                  using Connect = std::decay_t<decltype(connect)>;
                  forEachBlock("rhegma::equilibrium::tangents", state.mesh.blocks,
                               FindTangents<D, Connect>{connect, data, tangent_});
                });
  exists_ = owners.ranks().max(onHost(data.bad)() == 0 ? 0.0 : 1.0) == 0.0;
}

template <int D>
void TangentProduct<D>::apply(const Values& u, const Values& force) const
{
  copyFromOwners(state_, graph_, owners_, u);
  Kokkos::deep_copy(force, 0.0);
  for (const SlopeJump& jump : jumps_)
    for (int d = 0; d < D; ++d)
    {
      const double size = jump.weight * jumpOf<D>(jump, u, d);
      for (std::size_t a = 0; a < jump.row.size(); ++a)
        force(D * jump.row[a] + d) += size * jump.coefficient[a];
    }
  for (const Block& block : blocks_)
    for (int i = 0; i < D; ++i)
      for (int k = 0; k < D; ++k)
        force(D * block.row + i) += block.value[D * i + k] * u(D * block.other + k);
  Kokkos::deep_copy(ofNodes_, 0.0);
  Kokkos::deep_copy(forceOfNodes_, 0.0);
  for (int k = 0; k < D * graph_.rows; ++k)
    ofNodes_(width<D> * graph_.nodeOf(k / D) + k % D) = u(k);
  const auto volume = state_.particles.scalar(fields::volume);
  withStraining(state_,
                [&](const auto& connect)
                {
                  using Connect = std::decay_t<decltype(connect)>;
                  forEachBlock("rhegma::equilibrium::product", state_.mesh.blocks,
                               ProductBlock<D, Connect>{connect, volume, tangent_, ofNodes_, forceOfNodes_});
                });
  for (int k = 0; k < D * graph_.rows; ++k)
    force(k) += forceOfNodes_(width<D> * graph_.nodeOf(k / D) + k % D);
  addOverRanks(state_, graph_, force);
}

template <int D>
Values TangentProduct<D>::diagonal() const
{
  const Values diagonal("rhegma::equilibrium::diagonal", D * graph_.rows);
  for (const SlopeJump& jump : jumps_)
    for (std::size_t a = 0; a < jump.row.size(); ++a)
      for (int d = 0; d < D; ++d)
        diagonal(D * jump.row[a] + d) += jump.weight * jump.coefficient[a] * jump.coefficient[a];
  for (const Block& block : blocks_)
    for (int d = 0; d < D && block.row == block.other; ++d)
      diagonal(D * block.row + d) += block.value[(D + 1) * d];
  const ParticleData<D> data(state_, graph_, Values("rhegma::equilibrium::none", D * graph_.rows));
  withStraining(state_,
                [&](const auto& connect)
                {
                  using Connect = std::decay_t<decltype(connect)>;
                  forEachBlock("rhegma::equilibrium::diagonal", state_.mesh.blocks,
                               DiagonalBlock<D, Connect>{connect, data, tangent_, diagonal});
                });
  addOverRanks(state_, graph_, diagonal);
  return diagonal;
}

template class TangentProduct<2>;
template class TangentProduct<3>;

} // namespace Rhegma::equilibrium
