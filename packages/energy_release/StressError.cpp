#include "energy_release/StressError.hpp"

#include "state/Subdomain.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma::energy_release
{

namespace
{

/// Components of the stress that make the energy: in plane strain the one across the plane follows.
template <int D>
constexpr int components = D*(D + 1) / 2;

/// Sums of a node: the weight; its moments about the node, of order one and two; the stress times the weight
/// and times the moments of order one.
template <int D>
struct Sums
{
  static constexpr int first = 1, second = 1 + D, stress = second + components<D>;
  static constexpr int width = stress + (D + 1) * components<D>;
  using Rows = View<double* [width]>;
};

/// Index of a component among `components` from 0 on, and its two axes.
template <int D>
KOKKOS_INLINE_FUNCTION int pairIndex(int i, int j)
{
  return i <= j ? i * D - i * (i - 1) / 2 + j - i : pairIndex<D>(j, i);
}

/// Adds the moments of a block of particles to the nodes.
template <int D, class Connect>
struct MomentBlock
{
  Connect connect;
  Nodes<D> nodes;
  NodePositions<D> positions;
  double perCell;
  typename Sums<D>::Rows rows;
  BorrowedView<double* [D]> position;
  BorrowedView<double*> volume;
  BorrowedView<double * [symmetricSize<D>]> stress;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
      connect.visit(p, [&](int node, double fraction, const double*) { add(p, node, fraction * volume(p)); });
  }

  KOKKOS_INLINE_FUNCTION void add(int p, int node, double weight) const
  {
    using S = Sums<D>;
    const Vector<D> at = positions(latticeNode(nodes, node));
    double x[D];
    for (int d = 0; d < D; ++d)
      x[d] = perCell * (position(p, d) - at[d]);
    rows(node, 0) += weight;
    for (int i = 0; i < D; ++i)
    {
      rows(node, S::first + i) += weight * x[i];
      for (int j = i; j < D; ++j)
      {
        const int k = pairIndex<D>(i, j), to = S::stress + (D + 1) * k;
        const double weighted = weight * stress(p, symmetricIndex<D>(i, j));
        rows(node, S::second + k) += weight * x[i] * x[j];
        rows(node, to) += weighted;
        for (int d = 0; d < D; ++d)
          rows(node, to + 1 + d) += weighted * x[d];
      }
    }
  }
};

/// Solves A s = b by elimination; A is positive definite.
template <int D>
KOKKOS_INLINE_FUNCTION void eliminate(double (&A)[D][D], double (&b)[D])
{
  for (int k = 0; k < D; ++k)
    for (int i = k + 1; i < D; ++i)
    {
      const double factor = A[i][k] / A[k][k];
      for (int j = k; j < D; ++j)
        A[i][j] -= factor * A[k][j];
      b[i] -= factor * b[k];
    }
  for (int k = D - 1; k >= 0; --k)
  {
    for (int j = k + 1; j < D; ++j)
      b[k] -= A[k][j] * b[j];
    b[k] /= A[k][k];
  }
}

/// Value at the node of the linear fit of a component. Where the particles lie in a line or a point, the fit
/// has no slope across it: a thousandth of a squared cell in the variances changes it by less than a
/// hundredth elsewhere.
template <int D>
KOKKOS_INLINE_FUNCTION double valueAtNode(const typename Sums<D>::Rows& rows, int n, int component)
{
  using S = Sums<D>;
  constexpr double least = 1e-3;
  const double weight = rows(n, 0);
  const int from = S::stress + (D + 1) * component;
  const double mean = rows(n, from) / weight;
  double A[D][D], b[D], middle[D];
  for (int i = 0; i < D; ++i)
    middle[i] = rows(n, S::first + i) / weight;
  for (int i = 0; i < D; ++i)
  {
    for (int j = 0; j < D; ++j)
      A[i][j] = rows(n, S::second + pairIndex<D>(i, j)) / weight - middle[i] * middle[j];
    A[i][i] += least;
    b[i] = rows(n, from + 1 + i) / weight - mean * middle[i];
  }
  eliminate<D>(A, b);
  double value = mean;
  for (int i = 0; i < D; ++i)
    value -= b[i] * middle[i];
  return value;
}

/// Puts the recovered stresses into the first numbers of the rows.
template <int D>
void fitNodes(const State<D>& state, const typename Sums<D>::Rows& rows)
{
  const Nodes<D> nodes = state.mesh.nodes;
  Kokkos::parallel_for(
      "rhegma::fitStress", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()), KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        if (!(rows(n, 0) > 0.0))
          return;
        double value[components<D>];
        for (int k = 0; k < components<D>; ++k)
          value[k] = valueAtNode<D>(rows, n, k);
        for (int k = 0; k < components<D>; ++k)
          rows(n, k) = value[k];
      });
}

/// Sums the weighted energies of particles.
template <int D, class Connect>
struct ErrorOfParticle
{
  Connect connect;
  typename Sums<D>::Rows rows;
  BorrowedView<double* [D]> position;
  BorrowedView<double*> volume;
  BorrowedView<double * [symmetricSize<D>]> stress;
  BorrowedView<int*> material;
  View<Properties*> materials;
  View<double * [D + 2]> sights; ///< position, leftOut, reach

  KOKKOS_INLINE_FUNCTION double weight(int p) const
  {
    double largest = 0.0;
    for (int k = 0; k < static_cast<int>(sights.extent(0)); ++k)
    {
      double square = 0.0;
      for (int d = 0; d < D; ++d)
        square += (position(p, d) - sights(k, d)) * (position(p, d) - sights(k, d));
      const double r = std::sqrt(square), reach = sights(k, D + 1);
      if (r < sights(k, D))
        return 0.0;
      double fraction = 1.0;
      for (int d = 0; d < D && r > reach; ++d)
        fraction *= reach / r;
      largest = fraction > largest ? fraction : largest;
    }
    return largest;
  }

  KOKKOS_INLINE_FUNCTION void operator()(int p, double& sum) const
  {
    const double counted = weight(p);
    if (counted == 0.0)
      return;
    double error[components<D>] = {};
    connect.visit(p,
                  [&](int node, double fraction, const double*)
                  {
                    for (int k = 0; k < components<D>; ++k)
                      error[k] += fraction * rows(node, k);
                  });
    double trace = 0.0, square = 0.0;
    for (int i = 0; i < D; ++i)
      for (int j = i; j < D; ++j)
      {
        const double e = error[pairIndex<D>(i, j)] - stress(p, symmetricIndex<D>(i, j));
        square += (i == j ? 1.0 : 2.0) * e * e;
        trace += i == j ? e : 0.0;
      }
    const Properties& law = materials(material(p));
    const double coupled = law.planeLambda / (D * law.planeLambda + 2.0 * law.mu);
    sum += counted * volume(p) * (square - coupled * trace * trace) / (4.0 * law.mu);
  }
};

template <int D>
View<double* [D + 2]> onDevice(const std::vector<ErrorSight<D>>& sights)
{
  View<double * [D + 2]> rows("rhegma::errorSights", sights.size());
  const auto host = Kokkos::create_mirror_view(rows);
  for (std::size_t k = 0; k < sights.size(); ++k)
  {
    for (int d = 0; d < D; ++d)
      host(k, d) = sights[k].position[d];
    host(k, D) = sights[k].leftOut;
    host(k, D + 1) = sights[k].reach;
  }
  Kokkos::deep_copy(rows, host);
  return rows;
}

} // namespace

template <int D>
double energyOfStressError(const State<D>& state, const std::vector<ErrorSight<D>>& sights)
{
  const typename Sums<D>::Rows rows("rhegma::stressMoments", state.mesh.nodes.sums.extent(0));
  const auto position = state.particles.template real<D>(fields::position);
  const auto volume = state.particles.scalar(fields::volume);
  const auto stress = state.particles.template real<symmetricSize<D>>(fields::stress);
  double sum = 0.0;
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     const MomentBlock<D, Connect> moments{connect,
                                                           state.mesh.nodes,
                                                           nodePositions(state),
                                                           1.0 / state.mesh.smallestSpacing(),
                                                           rows,
                                                           position,
                                                           volume,
                                                           stress};
                     forEachBlock("rhegma::stressMoments", state.mesh.blocks, moments);
                     sumOverRanks(state, rows.data(), Sums<D>::width, 0, Sums<D>::width);
                     fitNodes<D>(state, rows);
                     const ErrorOfParticle<D, Connect> error{connect,
                                                             rows,
                                                             position,
                                                             volume,
                                                             stress,
                                                             state.particles.integer(fields::material),
                                                             state.materials.device,
                                                             onDevice(sights)};
                     Kokkos::parallel_reduce("rhegma::stressError",
                                             Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()), error,
                                             sum);
                   });
  sumParts(state, &sum, 1);
  return sum;
}

template double energyOfStressError(const State<2>&, const std::vector<ErrorSight<2>>&);
template double energyOfStressError(const State<3>&, const std::vector<ErrorSight<3>>&);

} // namespace Rhegma::energy_release
