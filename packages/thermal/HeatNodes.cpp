#include "thermal/HeatNodes.hpp"

#include "material/Tensors.hpp"
#include "parallel/Subdomain.hpp"
#include "thermal/ParticleFlux.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma::thermal
{

namespace
{

/// Where places are counted from, the same on all ranks.
template <int D>
Vector<D> commonOrigin(const State<D>& state)
{
  return state.subdomain ? state.subdomain->division.lattice.origin : state.grid.origin;
}

template <int D, class Connect>
struct CapacityBlock
{
  static constexpr int width = HeatNodes<D>::sumWidth;
  Connect connect;
  View<double* [width]> sums;
  ThermoTables tables;
  Vector<D> origin;
  BorrowedView<double*[D]> position, gradient;
  BorrowedView<double*> volume, temperature;
  BorrowedView<int*> material;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    double* const rows = sums.data();
    connect.forEachParticle(
        begin, end, [&](int p, const auto& stencil) { stencil.template addValue<width>(rows, shares(p)); });
  }

  KOKKOS_FORCEINLINE_FUNCTION Pack<width> shares(int p) const
  {
    const double c = volume(p) * ThermoPoint(tables, material(p), temperature(p)).capacity();
    double T = temperature(p), row[width] = {};
    for (int d = 0; d < D; ++d)
    {
      T -= gradient(p, d) * (position(p, d) - origin[d]);
      row[HeatNodes<D>::momentAt + d] = c * gradient(p, d);
    }
    row[HeatNodes<D>::capacityAt] = c;
    row[HeatNodes<D>::heatAt] = c * T;
    return Pack<width>::load(row);
  }
};

template <int D, class Connect>
struct FluxBlock
{
  Connect connect;
  View<double* [4]> value;
  View<double* [2]> rate;
  ParticleFlux<D> conducts;
  BorrowedView<double* [D]> gradient;
  View<double*> supply;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    const double* const rows = value.data();
    double* const to = rate.data();
    connect.forEachParticle(begin, end,
                            [&](int p, const auto& stencil)
                            {
                              Pack<2> slope[D];
                              stencil.template valueAndGradient<4>(rows, slope);
                              double g[D], flow[D];
                              for (int d = 0; d < D; ++d)
                                gradient(p, d) = g[d] = slope[d][0];
                              conducts.flux(p, g, flow);
                              Pack<2> b[D];
                              for (int d = 0; d < D; ++d)
                                b[d] = pack(flow[d], 0.0);
                              stencil.template addFlux<2>(to, b);
                              if (supply.extent(0) > 0 && supply(p) != 0.0)
                                stencil.template addValue<2>(to, pack(supply(p), 0.0));
                            });
  }
};

template <int D, class Connect>
struct ChangeBlock
{
  Connect connect;
  View<double* [4]> value;
  ThermoTables tables;
  BorrowedView<double*> temperature, internal;
  BorrowedView<int*> material;
  double share;
  bool mechanics;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    const double* const rows = value.data();
    connect.forEachParticle(begin, end,
                            [&](int p, const auto& stencil)
                            {
                              const Pack<4> seen = stencil.template value<4, 4>(rows);
                              const double change = seen[1] + share * (seen[2] - temperature(p));
                              const ThermoPoint at(tables, material(p), temperature(p));
                              internal(p) += at.capacity() * change;
                              // What moves finds its temperature with its stress, from what it holds.
                              temperature(p) = mechanics
                                                   ? temperature(p) + change
                                                   : temperatureOfHeat(tables, material(p), internal(p));
                            });
  }
};

} // namespace

template <int D>
void HeatNodes<D>::clear(const State<D>& state)
{
  const std::size_t rows = state.nodes.sums.extent(0);
  if (sums.extent(0) < rows)
  {
    sums = View<double* [sumWidth]>("rhegma::thermal::sums", rows);
    rate = View<double* [2]>("rhegma::thermal::rate", rows);
    value = View<double* [4]>("rhegma::thermal::value", rows);
    held = View<char*>("rhegma::thermal::held", rows);
  }
  const Nodes<D> nodes = state.nodes;
  const HeatNodes<D> heat = *this;
  Kokkos::parallel_for(
      "rhegma::thermal::clear", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        for (int k = 0; k < sumWidth; ++k)
          heat.sums(n, k) = 0.0;
        heat.rate(n, 0) = 0.0;
        heat.held(n) = 0;
      });
}

template <int D>
void heatToNodes(const State<D>& state, const HeatNodes<D>& nodes)
{
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     const FieldTable& table = state.particles;
                     const CapacityBlock<D, Connect> block{connect,
                                                           nodes.sums,
                                                           state.thermo,
                                                           commonOrigin(state),
                                                           table.real<D>(fields::position),
                                                           table.real<D>(fields::temperatureGradient),
                                                           table.scalar(fields::volume),
                                                           table.scalar(fields::temperature),
                                                           table.integer(fields::material)};
                     forEachBlock("rhegma::thermal::heatToNodes", state.blocks, block);
                   });
}

template <int D>
void findTemperature(State<D>& state, const HeatNodes<D>& heat)
{
  const Nodes<D> nodes = state.nodes;
  const NodePlaces<D> places = nodePlaces(state);
  const Vector<D> origin = commonOrigin(state);
  const bool mechanics = state.mechanics;
  Kokkos::parallel_for(
      "rhegma::thermal::findTemperature", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        const Vector<D> x = places(latticeNode(nodes, n)) - origin;
        const double capacity = heat.sums(n, HeatNodes<D>::capacityAt);
        double sum = heat.sums(n, HeatNodes<D>::heatAt);
        for (int d = 0; d < D; ++d)
          sum += x[d] * heat.sums(n, HeatNodes<D>::momentAt + d);
        heat.value(n, 0) = capacity > 0.0 ? sum / capacity : 0.0;
        heat.value(n, 1) = 0.0;
        heat.value(n, 2) = heat.value(n, 0);
        // Points on surfaces look for nodes with mass, by ratios alone.
        if (!mechanics)
          nodes.sums(n, Nodes<D>::massAt) = capacity;
      });
}

template <int D>
void fluxToNodes(const State<D>& state, const HeatNodes<D>& nodes, const View<double*>& supply)
{
  withConnectivity(
      state,
      [&](const auto& connect)
      {
        using Connect = std::decay_t<decltype(connect)>;
        const FieldTable& table = state.particles;
        const FluxBlock<D, Connect> block{
            connect, nodes.value, nodes.rate, particleFlux(state), table.real<D>(fields::temperatureGradient),
            supply};
        forEachBlock("rhegma::thermal::fluxToNodes", state.blocks, block);
      });
}

template <int D>
double changeTemperature(const State<D>& state, const HeatNodes<D>& heat, double dt)
{
  const Nodes<D> nodes = state.nodes;
  double taken = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::thermal::changeTemperature", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i, double& sum) {
        const int n = activeNode(nodes, i);
        const double capacity = heat.sums(n, HeatNodes<D>::capacityAt), flow = dt * heat.rate(n, 0);
        if (heat.held(n) == 0)
          heat.value(n, 1) = capacity > 0.0 ? flow / capacity : 0.0;
        else if (countsHere(nodes, n))
          sum += capacity * heat.value(n, 1) - flow;
      },
      taken);
  return taken;
}

template <int D>
void changeToParticles(State<D>& state, const HeatNodes<D>& nodes, double share)
{
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     const FieldTable& table = state.particles;
                     const ChangeBlock<D, Connect> block{connect,
                                                         nodes.value,
                                                         state.thermo,
                                                         table.scalar(fields::temperature),
                                                         table.scalar(fields::internalEnergy),
                                                         table.integer(fields::material),
                                                         share,
                                                         state.mechanics};
                     forEachBlock("rhegma::thermal::changeToParticles", state.blocks, block);
                   });
}

template struct HeatNodes<2>;
template struct HeatNodes<3>;
template void heatToNodes(const State<2>&, const HeatNodes<2>&);
template void heatToNodes(const State<3>&, const HeatNodes<3>&);
template void findTemperature(State<2>&, const HeatNodes<2>&);
template void findTemperature(State<3>&, const HeatNodes<3>&);
template void fluxToNodes(const State<2>&, const HeatNodes<2>&, const View<double*>&);
template void fluxToNodes(const State<3>&, const HeatNodes<3>&, const View<double*>&);
template double changeTemperature(const State<2>&, const HeatNodes<2>&, double);
template double changeTemperature(const State<3>&, const HeatNodes<3>&, double);
template void changeToParticles(State<2>&, const HeatNodes<2>&, double);
template void changeToParticles(State<3>&, const HeatNodes<3>&, double);

} // namespace Rhegma::thermal
