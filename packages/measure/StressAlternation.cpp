#include "measure/StressAlternation.hpp"

#include "state/Subdomain.hpp"
#include "transfer/ParticleViews.hpp"

#include <cmath>

namespace Rhegma::measure
{

namespace
{

/// Sums around a node: of weights w; w r and w r r, r the distance from the node; w s and w s r of each
/// component s of stress. From `fit` on the last two hold the values and slopes of the linear functions.
template <int D>
struct Moments
{
  static constexpr int components = symmetricSize<D>;
  static constexpr int weightAt = 0, distanceAt = 1, squareAt = 1 + D, stressAt = 1 + D + D * D,
                       slopeAt = stressAt + components, width = slopeAt + D * components;
  View<double* [width]> of;
};

/// What all passes over the particles of a body read.
template <int D, class Connect>
struct Patches
{
  Connect connect;
  Moments<D> moments;
  Nodes<D> nodes;
  NodePositions<D> positions;
  BorrowedView<double* [D]> position;
  BorrowedView<double * [symmetricSize<D>]> stress;
  BorrowedView<double*> volume;
  BorrowedView<int*> body;
  int which;

  KOKKOS_INLINE_FUNCTION Vector<D> fromNode(int node, int p) const
  {
    Vector<D> r = positions(latticeNode(nodes, node));
    for (int d = 0; d < D; ++d)
      r[d] = position(p, d) - r[d];
    return r;
  }

  KOKKOS_INLINE_FUNCTION void add(int p) const
  {
    using M = Moments<D>;
    if (body(p) != which)
      return;
    connect.visit(p,
                  [&](int node, double weight, const double*)
                  {
                    const double w = weight * volume(p);
                    const Vector<D> r = fromNode(node, p);
                    double* const to = &moments.of(node, 0);
                    Kokkos::atomic_add(to + M::weightAt, w);
                    for (int d = 0; d < D; ++d)
                    {
                      Kokkos::atomic_add(to + M::distanceAt + d, w * r[d]);
                      for (int e = 0; e < D; ++e)
                        Kokkos::atomic_add(to + M::squareAt + D * d + e, w * r[d] * r[e]);
                    }
                    for (int k = 0; k < M::components; ++k)
                    {
                      Kokkos::atomic_add(to + M::stressAt + k, w * stress(p, k));
                      for (int d = 0; d < D; ++d)
                        Kokkos::atomic_add(to + M::slopeAt + D * k + d, w * stress(p, k) * r[d]);
                    }
                  });
  }

  /// Square of the deviation of a particle [Pa2].
  KOKKOS_INLINE_FUNCTION double deviation(int p) const
  {
    using M = Moments<D>;
    double rest[M::components];
    for (int k = 0; k < M::components; ++k)
      rest[k] = stress(p, k);
    connect.visit(p,
                  [&](int node, double weight, const double*)
                  {
                    const Vector<D> r = fromNode(node, p);
                    const double* const at = &moments.of(node, 0);
                    for (int k = 0; k < M::components; ++k)
                    {
                      double fitted = at[M::stressAt + k];
                      for (int d = 0; d < D; ++d)
                        fitted += at[M::slopeAt + D * k + d] * r[d];
                      rest[k] -= weight * fitted;
                    }
                  });
    return squareOf(rest);
  }

  /// Square of the Frobenius norm: shear counts twice.
  KOKKOS_INLINE_FUNCTION static double squareOf(const double* s)
  {
    double sum = 0.0;
    for (int k = 0; k < symmetricSize<D>; ++k)
      sum += s[k] * s[k];
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < i; ++j)
        sum += s[symmetricIndex<D>(i, j)] * s[symmetricIndex<D>(i, j)];
    return sum;
  }
};

/// Turns the sums of a node into linear functions. Directions in which the particles have no extent get no
/// slope. \param spacing of the cells [m] \return square of the mean stress [Pa2]
template <int D>
KOKKOS_INLINE_FUNCTION double fit(double* sums, double spacing)
{
  using M = Moments<D>;
  constexpr double noExtent = 1e-9;
  const double weight = sums[M::weightAt];
  double mean[D], A[D][D], square[M::components];
  for (int d = 0; d < D; ++d)
    mean[d] = sums[M::distanceAt + d] / weight;
  for (int d = 0; d < D; ++d)
    for (int e = 0; e < D; ++e)
      A[d][e] = sums[M::squareAt + D * d + e] / weight - mean[d] * mean[e];
  const double least = noExtent * spacing * spacing;
  // A = L L^T; a pivot without extent gives its axis no slope.
  double L[D][D] = {};
  for (int i = 0; i < D; ++i)
    for (int j = 0; j <= i; ++j)
    {
      double sum = A[i][j];
      for (int k = 0; k < j; ++k)
        sum -= L[i][k] * L[j][k];
      if (i == j)
        L[i][i] = sum > least ? std::sqrt(sum) : 0.0;
      else
        L[i][j] = L[j][j] > 0.0 ? sum / L[j][j] : 0.0;
    }
  for (int k = 0; k < M::components; ++k)
  {
    double b[D];
    const double value = sums[M::stressAt + k] / weight;
    for (int d = 0; d < D; ++d)
    {
      b[d] = sums[M::slopeAt + D * k + d] / weight - value * mean[d];
      for (int e = 0; e < d; ++e)
        b[d] -= L[d][e] * b[e];
      b[d] = L[d][d] > 0.0 ? b[d] / L[d][d] : 0.0;
    }
    for (int d = D - 1; d >= 0; --d)
    {
      for (int e = d + 1; e < D; ++e)
        b[d] -= L[e][d] * b[e];
      b[d] = L[d][d] > 0.0 ? b[d] / L[d][d] : 0.0;
    }
    square[k] = value;
    double atNode = value;
    for (int d = 0; d < D; ++d)
    {
      atNode -= b[d] * mean[d];
      sums[M::slopeAt + D * k + d] = b[d];
    }
    sums[M::stressAt + k] = atNode;
  }
  return Patches<D, int>::squareOf(square);
}

/// Fits the functions of all nodes. \return the largest square of a mean stress of this rank [Pa2]
template <int D>
double fitAll(const State<D>& state, const Moments<D>& moments)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const View<double * [Moments<D>::width]> of = moments.of;
  const double spacing = state.mesh.smallestSpacing();
  double largest = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::measure::fitStress", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i, double& most) {
        const int n = activeNode(nodes, i);
        if (of(n, Moments<D>::weightAt) > 0.0)
        {
          const double square = fit<D>(&of(n, 0), spacing);
          most = square > most ? square : most;
        }
      },
      Kokkos::Max<double>(largest));
  return largest;
}

template <int D, class Connect>
StressAlternation alternationWith(const State<D>& state, int which, const Connect& connect)
{
  const FieldTable& table = state.particles;
  const Moments<D> moments{
      View<double * [Moments<D>::width]>("rhegma::measure::moments", state.mesh.nodes.sums.extent(0))};
  const Patches<D, Connect> patches{connect,
                                    moments,
                                    state.mesh.nodes,
                                    nodePositions(state),
                                    table.real<D>(fields::position),
                                    table.real<symmetricSize<D>>(fields::stress),
                                    table.scalar(fields::volume),
                                    table.integer(fields::body),
                                    which};
  const Kokkos::RangePolicy<ExecSpace> all(0, state.particles.size());
  Kokkos::parallel_for(
      "rhegma::measure::momentsOfStress", all, KOKKOS_LAMBDA(const int p) { patches.add(p); });
  sumOverRanks(state, moments.of.data(), Moments<D>::width, 0, Moments<D>::width);
  const double largest = fitAll(state, moments);
  double sums[2] = {};
  Kokkos::parallel_reduce(
      "rhegma::measure::stressAlternation", all,
      KOKKOS_LAMBDA(const int p, double& square, double& volume) {
        if (patches.body(p) != which)
          return;
        square += patches.volume(p) * patches.deviation(p);
        volume += patches.volume(p);
      },
      sums[0], sums[1]);
  sumParts(state, sums, 2);
  StressAlternation result;
  result.deviation = sums[1] > 0.0 ? std::sqrt(sums[0] / sums[1]) : 0.0;
  result.largest = std::sqrt(state.ranks.max(largest));
  return result;
}

} // namespace

template <int D>
StressAlternation stressAlternation(const State<D>& state, int body)
{
  StressAlternation result;
  withConnectivity(state, [&](const auto& connect) { result = alternationWith(state, body, connect); });
  return result;
}

template StressAlternation stressAlternation(const State<2>&, int);
template StressAlternation stressAlternation(const State<3>&, int);

} // namespace Rhegma::measure
