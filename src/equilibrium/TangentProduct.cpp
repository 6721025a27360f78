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

/// Finds the tangent of each particle. Hoop strains are left out: boxes of axisymmetric scenes are never
/// clipped, so that their systems are assembled (NewtonStep).
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
      double G[gradientSize<D>], A[gradientSize<D>][gradientSize<D>];
      data.see(connect, p, rows, G);
      if (!trialTangent<D>(data.before(p), G, A, D * D))
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
      double H[gradientSize<D>];
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

template <class T>
View<T*> deviceCopy(const char* label, const std::vector<T>& list)
{
  const View<T*> copy(Kokkos::view_alloc(Kokkos::WithoutInitializing, std::string(label)), list.size());
  Kokkos::deep_copy(copy, Kokkos::View<const T*, Kokkos::HostSpace>(list.data(), list.size()));
  return copy;
}

/// Places of entries that are sorted by their rows, those of one row in their order.
struct ByRow
{
  std::vector<int> first; ///< of each row; one more at the end
  std::vector<int> next;  ///< where the next entry of each row belongs

  /// \param forEach calls its argument with the row of each entry
  template <class ForEach>
  ByRow(int rows, const ForEach& forEach) : first(rows + 1, 0)
  {
    forEach([&](int row) { ++first[row + 1]; });
    for (int r = 0; r < rows; ++r)
      first[r + 1] += first[r];
    next.assign(first.begin(), first.end() - 1);
  }
};

using Rows = Kokkos::RangePolicy<ExecSpace>;

} // namespace

template <int D>
CoupledRows<D>::CoupledRows(const std::vector<SlopeJump>& jumps, const std::vector<Block>& blocks, int rows)
    : force("rhegma::equilibrium::forceOfJumps", D * jumps.size())
{
  std::vector<int> ofNodes, start(1, 0);
  std::vector<double> coefficients, weights;
  for (const SlopeJump& jump : jumps)
  {
    ofNodes.insert(ofNodes.end(), jump.row.begin(), jump.row.end());
    coefficients.insert(coefficients.end(), jump.coefficient.begin(), jump.coefficient.end());
    weights.push_back(jump.weight);
    start.push_back(static_cast<int>(ofNodes.size()));
  }
  ByRow byRow(rows, [&](const auto& count) { std::for_each(ofNodes.begin(), ofNodes.end(), count); });
  std::vector<int> jumpsOfRows(ofNodes.size());
  std::vector<double> theirs(ofNodes.size());
  for (std::size_t j = 0; j < jumps.size(); ++j)
    for (int k = start[j]; k < start[j + 1]; ++k)
    {
      const int at = byRow.next[ofNodes[k]]++;
      jumpsOfRows[at] = static_cast<int>(j);
      theirs[at] = coefficients[k];
    }
  ByRow blocksByRow(rows,
                    [&](const auto& count)
                    {
                      for (const Block& block : blocks)
                        count(block.row);
                    });
  std::vector<int> others(blocks.size());
  std::vector<double> values(D * D * blocks.size());
  for (const Block& block : blocks)
  {
    const int at = blocksByRow.next[block.row]++;
    others[at] = block.other;
    std::copy(block.value, block.value + D * D, &values[static_cast<std::size_t>(D * D) * at]);
  }
  firstOfJump = deviceCopy("rhegma::equilibrium::firstOfJump", start);
  rowOfJump = deviceCopy("rhegma::equilibrium::rowOfJump", ofNodes);
  coefficient = deviceCopy("rhegma::equilibrium::coefficient", coefficients);
  weight = deviceCopy("rhegma::equilibrium::weight", weights);
  firstOfRow = deviceCopy("rhegma::equilibrium::firstOfRow", byRow.first);
  jumpOfRow = deviceCopy("rhegma::equilibrium::jumpOfRow", jumpsOfRows);
  ofJump = deviceCopy("rhegma::equilibrium::ofJump", theirs);
  firstBlockOfRow = deviceCopy("rhegma::equilibrium::firstBlockOfRow", blocksByRow.first);
  other = deviceCopy("rhegma::equilibrium::otherRow", others);
  value = deviceCopy("rhegma::equilibrium::blocks", values);
}

template <int D>
void CoupledRows<D>::multiply(const Values& u, const Values& result) const
{
  const CoupledRows<D> all = *this;
  Kokkos::parallel_for(
      "rhegma::equilibrium::forceOfJumps", Rows(0, all.weight.extent(0)), KOKKOS_LAMBDA(const int j) {
        for (int d = 0; d < D; ++d)
        {
          double sum = 0.0;
          for (int k = all.firstOfJump(j); k < all.firstOfJump(j + 1); ++k)
            sum += all.coefficient(k) * u(D * all.rowOfJump(k) + d);
          all.force(D * j + d) = all.weight(j) * sum;
        }
      });
  Kokkos::parallel_for(
      "rhegma::equilibrium::forceOfRows", Rows(0, all.firstOfRow.extent(0) - 1), KOKKOS_LAMBDA(const int r) {
        double sum[D] = {};
        for (int k = all.firstOfRow(r); k < all.firstOfRow(r + 1); ++k)
          for (int d = 0; d < D; ++d)
            sum[d] += all.force(D * all.jumpOfRow(k) + d) * all.ofJump(k);
        for (int b = all.firstBlockOfRow(r); b < all.firstBlockOfRow(r + 1); ++b)
          for (int i = 0; i < D; ++i)
            for (int k = 0; k < D; ++k)
              sum[i] += all.value(D * D * b + D * i + k) * u(D * all.other(b) + k);
        for (int d = 0; d < D; ++d)
          result(D * r + d) = sum[d];
      });
}

template <int D>
void CoupledRows<D>::addDiagonal(const Values& diagonal) const
{
  const CoupledRows<D> all = *this;
  Kokkos::parallel_for(
      "rhegma::equilibrium::diagonalOfRows", Rows(0, all.firstOfRow.extent(0) - 1),
      KOKKOS_LAMBDA(const int r) {
        for (int d = 0; d < D; ++d)
        {
          double sum = diagonal(D * r + d);
          for (int k = all.firstOfRow(r); k < all.firstOfRow(r + 1); ++k)
            sum += all.weight(all.jumpOfRow(k)) * all.ofJump(k) * all.ofJump(k);
          for (int b = all.firstBlockOfRow(r); b < all.firstBlockOfRow(r + 1); ++b)
            if (all.other(b) == r)
              sum += all.value(D * D * b + (D + 1) * d);
          diagonal(D * r + d) = sum;
        }
      });
}

template <int D>
TangentProduct<D>::TangentProduct(const State<D>& state, const RowOwners& owners, const RowGraph& graph,
                                  const Resistances<D>& resistances, const Values& displacement)
    : state_(state),
      owners_(owners),
      graph_(graph),
      tangent_(Kokkos::view_alloc(Kokkos::WithoutInitializing, "rhegma::equilibrium::tangents"),
               state.particles.size(), tangentSize<D>),
      ofNodes_("rhegma::equilibrium::ofNodes", width<D> * state.mesh.nodes.sums.extent(0)),
      forceOfNodes_("rhegma::equilibrium::forceOfNodes", width<D> * state.mesh.nodes.sums.extent(0))
{
  std::vector<typename CoupledRows<D>::Block> blocks;
  for (const auto& force : resistances.forces)
    symmetric_ = force->addStiffness(false,
                                     [&](int row, int other, const double(&value)[D * D])
                                     {
                                       blocks.push_back({row, other, {}});
                                       std::copy(value, value + D * D, blocks.back().value);
                                     }) &&
                 symmetric_;
  coupled_ = CoupledRows<D>(resistances.jumps, blocks, graph.rows);
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
  coupled_.multiply(u, force);
  Kokkos::deep_copy(ofNodes_, 0.0);
  Kokkos::deep_copy(forceOfNodes_, 0.0);
  const View<double*> ofNodes = ofNodes_, forceOfNodes = forceOfNodes_;
  const View<int*> nodeOf = graph_.nodeOf;
  Kokkos::parallel_for(
      "rhegma::equilibrium::toNodes", Rows(0, D * graph_.rows),
      KOKKOS_LAMBDA(const int k) { ofNodes(width<D> * nodeOf(k / D) + k % D) = u(k); });
  const auto volume = state_.particles.scalar(fields::volume);
  withStraining(state_,
                [&](const auto& connect)
                {
                  using Connect = std::decay_t<decltype(connect)>;
                  forEachBlock("rhegma::equilibrium::product", state_.mesh.blocks,
                               ProductBlock<D, Connect>{connect, volume, tangent_, ofNodes_, forceOfNodes_});
                });
  Kokkos::parallel_for(
      "rhegma::equilibrium::fromNodes", Rows(0, D * graph_.rows),
      KOKKOS_LAMBDA(const int k) { force(k) += forceOfNodes(width<D> * nodeOf(k / D) + k % D); });
  addOverRanks(state_, graph_, force);
}

template <int D>
Values TangentProduct<D>::diagonal() const
{
  const Values diagonal("rhegma::equilibrium::diagonal", D * graph_.rows);
  coupled_.addDiagonal(diagonal);
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

template struct CoupledRows<2>;
template struct CoupledRows<3>;
template class TangentProduct<2>;
template class TangentProduct<3>;

} // namespace Rhegma::equilibrium
