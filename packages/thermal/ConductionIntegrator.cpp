#include "thermal/ConductionIntegrator.hpp"

#include "archive/Archive.hpp"
#include "state/Subdomain.hpp"
#include "thermal/Insulators.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::thermal
{

namespace
{

/// Flow of the particles by a change of the nodes' temperature.
template <int D, class Connect>
struct ChangedFluxBlock
{
  Connect connect;
  View<double*[2]> change, flow;
  ParticleFlux<D> conducts;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    const double* const rows = change.data();
    double* const to = flow.data();
    connect.forEachParticle(begin, end,
                            [&](int p, const auto& stencil)
                            {
                              Pack<2> slope[D], b[D];
                              stencil.template valueAndGradient<2>(rows, slope);
                              double g[D], q[D];
                              for (int d = 0; d < D; ++d)
                                g[d] = slope[d][0];
                              conducts.flux(p, g, q);
                              for (int d = 0; d < D; ++d)
                                b[d] = pack(q[d], 0.0);
                              stencil.template addFlux<2>(to, b);
                            });
  }
};

/// Adds the gradient of a change to the particles' temperature gradient, which is then that of the step's
/// end: steps are long enough for it to matter.
template <int D, class Connect>
struct GradientBlock
{
  Connect connect;
  View<double* [2]> change;
  BorrowedView<double* [D]> gradient;
  HeatNodes<D> nodes;
  ParticleFlux<D> conducts;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    const double* const rows = change.data();
    connect.forEachParticle(begin, end,
                            [&](int p, const auto& stencil)
                            {
                              if (isLeftOut(connect, nodes, conducts, p))
                                return;
                              Pack<2> slope[D];
                              stencil.template valueAndGradient<2>(rows, slope);
                              for (int d = 0; d < D; ++d)
                                gradient(p, d) += slope[d][0];
                            });
  }
};

/// Adds the diagonal of K.
template <int D, class Connect>
struct DiagonalBlock
{
  Connect connect;
  View<double*> diagonal;
  ParticleFlux<D> conducts;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
      connect.visit(p,
                    [&](int node, double, const double* slope)
                    {
                      double g[D], q[D], sum = 0.0;
                      for (int d = 0; d < D; ++d)
                        g[d] = slope[d];
                      conducts.flux(p, g, q);
                      for (int d = 0; d < D; ++d)
                        sum -= g[d] * q[d];
                      diagonal(node) += sum;
                    });
  }
};

} // namespace

template <int D>
int ConductionIntegrator<D>::stages(double dt, double explicitLimit)
{
  // s^2 + s - 2 = 4 dt / limit; odd numbers of stages damp what is shortest (section 3 of the paper).
  const double ratio = 4.0 * dt / explicitLimit * (1.0 - 1e-12);
  const int least = static_cast<int>(std::ceil(0.5 * (std::sqrt(9.0 + 4.0 * ratio) - 1.0)));
  return std::max(3, least + 1 - least % 2);
}

template <int D>
void ConductionIntegrator<D>::serialize(Archive& archive)
{
  archive("passes", products);
  archive("capacity", capacity_);
}

template <int D>
void ConductionIntegrator<D>::reserveRows(const State<D>& state)
{
  const std::size_t rows = state.mesh.nodes.sums.extent(0);
  if (change_.extent(0) >= rows)
    return;
  change_ = View<double* [2]>("rhegma::thermal::change", rows);
  flow_ = View<double* [2]>("rhegma::thermal::flow", rows);
  diagonal_ = View<double*>("rhegma::thermal::diagonal", rows);
  stage_ = View<double* [4]>("rhegma::thermal::stages", method == Method::SuperTimeStepping ? rows : 0);
  const std::size_t second = rows - state.mesh.nodes.numLattice;
  pairs_ = View<double* [pairWidth]>("rhegma::thermal::pairs", isImplicit(method) ? second : 0);
  unknown_ = View<char*>("rhegma::thermal::unknown", isImplicit(method) ? rows : 0);
}

/// flow = -K change. \return the power [W] that surfaces take in by it
template <int D>
double ConductionIntegrator<D>::findFlow(const State<D>& state, const HeatBoundaries<D>& boundaries)
{
  ++products;
  const Nodes<D> nodes = state.mesh.nodes;
  const View<double* [2]> flow = flow_;
  Kokkos::parallel_for(
      "rhegma::thermal::clearFlow", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) { flow(activeNode(nodes, i), 0) = 0.0; });
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     const ChangedFluxBlock<D, Connect> block{connect, change_, flow_, particleFlux(state)};
                     forEachBlock("rhegma::thermal::changeOfFlux", state.mesh.blocks, block);
                   });
  const double power = boundaries.addResponse(change_, flow_);
  sumOverRanks(state, flow_.data(), 2, 0, 1);
  return power;
}

template <int D>
void ConductionIntegrator<D>::addGradient(const State<D>& state, const HeatNodes<D>& nodes)
{
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     const GradientBlock<D, Connect> block{
                         connect, change_, state.particles.template real<D>(fields::temperatureGradient),
                         nodes, particleFlux(state)};
                     forEachBlock("rhegma::thermal::changeOfGradient", state.mesh.blocks, block);
                   });
}

template <int D>
void ConductionIntegrator<D>::findDiagonal(const State<D>& state, const HeatBoundaries<D>& boundaries)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const View<double*> diagonal = diagonal_;
  Kokkos::parallel_for(
      "rhegma::thermal::clearDiagonal", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) { diagonal(activeNode(nodes, i)) = 0.0; });
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     const DiagonalBlock<D, Connect> block{connect, diagonal_, particleFlux(state)};
                     forEachBlock("rhegma::thermal::diagonal", state.mesh.blocks, block);
                   });
  boundaries.addDiagonal(diagonal_);
  sumOverRanks(state, diagonal_.data(), 1, 0, 1);
}

template <int D>
double ConductionIntegrator<D>::findRate(State<D>& state, const HeatNodes<D>& nodes,
                                         const HeatBoundaries<D>& boundaries, const CrackConduction<D>& faces,
                                         double dt, double explicitLimit)
{
  reserveRows(state);
  findDiagonal(state, boundaries);
  return isImplicit(method) ? implicitStep(state, nodes, boundaries, faces, dt)
                            : superTimeStep(state, nodes, boundaries, dt, explicitLimit);
}

template <int D>
double ConductionIntegrator<D>::takeSteadyChange(const State<D>& state, const HeatNodes<D>& heat) const
{
  const Nodes<D> nodes = state.mesh.nodes;
  const View<double* [2]> change = change_;
  double taken = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::thermal::steadyChange", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i, double& sum) {
        const int n = activeNode(nodes, i);
        if (heat.held(n) == 0)
          heat.value(n, 1) = change(n, 0);
        if (isOwnedByThisRank(nodes, n))
          sum += heat.sums(n, HeatNodes<D>::capacityAt) * heat.value(n, 1);
      },
      taken);
  return taken;
}

template <int D>
double ConductionIntegrator<D>::superTimeStep(State<D>& state, const HeatNodes<D>& heat,
                                              const HeatBoundaries<D>& boundaries, double dt,
                                              double explicitLimit)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const View<double* [4]> stage = stage_;
  const View<double*[2]> change = change_, flow = flow_;
  const View<double*> diagonal = diagonal_;
  Kokkos::parallel_for(
      "rhegma::thermal::beginStages", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        for (int k = 0; k < 3; ++k)
          stage(n, k) = 0.0;
        stage(n, 3) = heat.rate(n, 0);
        change(n, 0) = flow(n, 0) = 0.0;
      });
  const int s = stages(dt, explicitLimit);
  const double w = 4.0 / (double(s) * s + s - 2.0);
  const auto b = [](int j) { return j < 3 ? 1.0 / 3.0 : (j * (j + 1.0) - 2.0) / (2.0 * j * (j + 1.0)); };
  double power = 0.0;                    // of surfaces relative to that at the beginning
  double here = 0.0, before = 0.0;       // heat by it at the last two stages
  int now = 0, last = 1, lastButOne = 2; // columns
  for (int j = 1; j <= s; ++j)
  {
    if (j > 1)
      power = findFlow(state, boundaries);
    const double mu = j == 1 ? 0.0 : (2.0 * j - 1.0) / j * b(j) / b(j - 1);
    const double nu = j == 1 ? 0.0 : -(j - 1.0) / j * b(j) / b(j - 2);
    const double step = j == 1 ? b(1) * w : mu * w;
    const double first = j == 1 ? 0.0 : -(1.0 - b(j - 1)) * step;
    const int to = now, one = last, two = lastButOne;
    Kokkos::parallel_for(
        "rhegma::thermal::stage", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
        KOKKOS_LAMBDA(const int i) {
          const int n = activeNode(nodes, i);
          const double Q = stage(n, 3);
          const double in =
              mu * stage(n, one) + nu * stage(n, two) + dt * (step * (Q + flow(n, 0)) + first * Q);
          stage(n, to) = in;
          const double capacity = heat.sums(n, HeatNodes<D>::capacityAt);
          // Without conduction there is no limit.
          const double least = diagonal(n) > 0.0 ? explicitLimit * diagonal(n) : 0.0;
          change(n, 0) =
              heat.held(n) != 0 || !(capacity > 0.0) ? 0.0 : in / (capacity > least ? capacity : least);
        });
    const double next = mu * here + nu * before + dt * step * power;
    before = here;
    here = next;
    lastButOne = last;
    last = now;
    now = 3 - last - lastButOne;
  }
  const int end = last;
  Kokkos::parallel_for(
      "rhegma::thermal::endStages", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        heat.rate(n, 0) = stage(n, end) / dt;
      });
  addGradient(state, heat);
  return here;
}

template class ConductionIntegrator<2>;
template class ConductionIntegrator<3>;

} // namespace Rhegma::thermal
