#include "thermal/HeatNodes.hpp"

#include "material/Tensors.hpp"
#include "state/Subdomain.hpp"
#include "thermal/Insulators.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma::thermal
{

namespace
{

/// Origin of positions, the same on all ranks.
template <int D>
Vector<D> commonOrigin(const State<D>& state)
{
  return state.mesh.subdomain ? state.mesh.subdomain->division.lattice.origin : state.mesh.grid.origin;
}

template <int D, class Connect>
struct CapacityBlock
{
  static constexpr int width = HeatNodes<D>::sumWidth;
  Connect connect;
  HeatNodes<D> nodes;
  ThermoTables tables;
  Vector<D> origin;
  BorrowedView<double*[D]> position, gradient;
  BorrowedView<double*> volume, temperature;
  BorrowedView<int*> material;
  Nodes<D> all;
  NodePositions<D> positions;
  View<int*> storedRow; ///< of the particles' stored stencils; empty where there are none

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end && storedRow.extent(0) > 0; ++p)
      if (storedRow(p) >= 0)
        addStored(p);
    double* const rows = nodes.sums.data();
    if (nodes.meets.extent(0) == 0)
      connect.forEachParticle(begin, end,
                              [&](int p, const auto& stencil)
                              { stencil.template addValue<width>(rows, fractions(p)); });
    else
      connect.forEachParticle(begin, end,
                              [&](int p, const auto& stencil)
                              {
                                if (ThermoPoint(tables, material(p), temperature(p)).conductivity() > 0.0)
                                  stencil.template addValue<width>(rows, fractions(p));
                                else
                                  addInsulator(p);
                              });
  }

  /// Of a particle with a stored stencil: how far its nodes are aside, and the parts of negative weight taken
  /// out again of the means.
  KOKKOS_INLINE_FUNCTION void addStored(int p) const
  {
    double aside = 0.0, row[width];
    fractions(p).store(row);
    const bool conducts =
        nodes.meets.extent(0) == 0 || ThermoPoint(tables, material(p), temperature(p)).conductivity() > 0.0;
    connect.visit(p,
                  [&](int node, double weight, const double*)
                  {
                    const Vector<D> x = positions(latticeNode(all, node));
                    for (int d = 0; d < D && weight > 0.0; ++d)
                      aside += weight * gradient(p, d) * (x[d] - position(p, d));
                    if (weight < 0.0 && (conducts || !nodes.conductsAt(node)))
                    {
                      nodes.rate(node, HeatNodes<D>::leftOutAt) -= weight * row[HeatNodes<D>::capacityAt];
                      for (int k = HeatNodes<D>::heatAt; k < width; ++k)
                        nodes.sums(node, k) -= weight * row[k];
                    }
                  });
    nodes.aside(p) = aside;
  }

  /// Adds an insulator to nodes without conductors.
  KOKKOS_INLINE_FUNCTION void addInsulator(int p) const
  {
    double row[width];
    fractions(p).store(row);
    connect.visit(p,
                  [&](int node, double weight, const double*)
                  {
                    for (int k = 0; k < width && !nodes.conductsAt(node); ++k)
                      nodes.sums(node, k) += weight * row[k];
                  });
  }

  KOKKOS_FORCEINLINE_FUNCTION Pack<width> fractions(int p) const
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
  HeatNodes<D> nodes;
  ParticleFlux<D> conducts;
  BorrowedView<double* [D]> gradient;
  View<double*> supply;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    const double* const rows = nodes.value.data();
    double* const to = nodes.rate.data();
    connect.forEachParticle(begin, end,
                            [&](int p, const auto& stencil)
                            {
                              if (leftOut(p))
                                return;
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

  /// Insulators next to a conductor have no gradient.
  KOKKOS_INLINE_FUNCTION bool leftOut(int p) const
  {
    if (!isLeftOut(connect, nodes, conducts, p))
      return false;
    for (int d = 0; d < D; ++d)
      gradient(p, d) = 0.0;
    return true;
  }
};

template <int D, class Connect>
struct ChangeBlock
{
  Connect connect;
  HeatNodes<D> nodes;
  ThermoTables tables;
  BorrowedView<double*> volume, temperature, internal;
  BorrowedView<int*> material;
  View<double*> supply;
  View<int*> storedRow; ///< of the particles' stored stencils; empty where there are none
  double fraction, dt;
  bool mechanics;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    const double* const rows = nodes.value.data();
    const bool several = nodes.meets.extent(0) > 0;
    connect.forEachParticle(begin, end,
                            [&](int p, const auto& stencil)
                            {
                              const ThermoPoint at(tables, material(p), temperature(p));
                              double change = 0.0;
                              if (several && !(at.conductivity() > 0.0))
                                change = ofInsulator(p, at.capacity());
                              else
                              {
                                const Pack<4> seen = stencil.template value<4, 4>(rows);
                                const bool edited = storedRow.extent(0) > 0 && storedRow(p) >= 0;
                                change =
                                    seen[1] + fraction * (edited ? unresolved(p) : seen[2] - temperature(p));
                                if (several)
                                  change += nodes.joined(p);
                              }
                              internal(p) += at.capacity() * change;
                              // With mechanics, the temperature follows with the stress from the internal
                              // energy.
                              temperature(p) = mechanics
                                                   ? temperature(p) + change
                                                   : temperatureOfHeat(tables, material(p), internal(p));
                            });
  }

  /// Sum of positive weights times the differences to the nodes that they do not resolve, of a particle with
  /// a stored stencil: as the means of the nodes have positive weights only, these sums leave the heat as it
  /// is.
  KOKKOS_INLINE_FUNCTION double unresolved(int p) const
  {
    double sum = -nodes.aside(p);
    connect.visit(p,
                  [&](int node, double weight, const double*)
                  {
                    if (weight > 0.0)
                      sum += weight * (nodes.value(node, 2) - temperature(p));
                  });
    return sum;
  }

  /// Change of an insulator on nodes without conductors; next to a conductor also its own supply.
  KOKKOS_INLINE_FUNCTION double ofInsulator(int p, double capacity) const
  {
    double change = 0.0;
    connect.visit(p, [&](int node, double weight, const double*)
                  { change += nodes.conductsAt(node) ? 0.0 : weight * nodes.value(node, 1); });
    if (supply.extent(0) > 0 && supply(p) != 0.0 && isNextToConductor(connect, nodes, p))
      change += dt * supply(p) / (volume(p) * capacity);
    return change;
  }
};

} // namespace

template <int D>
void HeatNodes<D>::clear(const State<D>& state, bool several)
{
  const std::size_t rows = state.mesh.nodes.sums.extent(0);
  if (sums.extent(0) < rows)
  {
    sums = View<double* [sumWidth]>("rhegma::thermal::sums", rows);
    rate = View<double* [2]>("rhegma::thermal::rate", rows);
    value = View<double* [4]>("rhegma::thermal::value", rows);
    held = View<char*>("rhegma::thermal::held", rows);
    if (several)
      meets = View<double* [meetWidth]>("rhegma::thermal::meets", rows);
  }
  if (several && static_cast<int>(joined.extent(0)) < state.particles.size())
    joined = View<double*>("rhegma::thermal::joined", state.particles.size());
  if (state.stored.count > 0 && static_cast<int>(aside.extent(0)) < state.particles.size())
    aside = View<double*>("rhegma::thermal::aside", state.particles.size());
  const Nodes<D> nodes = state.mesh.nodes;
  const HeatNodes<D> heat = *this;
  Kokkos::parallel_for(
      "rhegma::thermal::clear", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        for (int k = 0; k < sumWidth; ++k)
          heat.sums(n, k) = 0.0;
        heat.rate(n, 0) = heat.rate(n, HeatNodes<D>::leftOutAt) = 0.0;
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
                                                           nodes,
                                                           state.materials.thermo,
                                                           commonOrigin(state),
                                                           table.real<D>(fields::position),
                                                           table.real<D>(fields::temperatureGradient),
                                                           table.scalar(fields::volume),
                                                           table.scalar(fields::temperature),
                                                           table.integer(fields::material),
                                                           state.mesh.nodes,
                                                           nodePositions(state),
                                                           state.stored.count > 0 ? state.stored.row
                                                                                  : View<int*>()};
                     forEachBlock("rhegma::thermal::heatToNodes", state.mesh.blocks, block);
                   });
}

template <int D>
double largestPositiveSum(const State<D>& state)
{
  if (state.cracks.cracks.empty())
    return 1.0;
  const StencilTable<D> table = state.stored.table;
  double largest = 1.0;
  Kokkos::parallel_reduce(
      "rhegma::thermal::largestPositiveSum", Kokkos::RangePolicy<ExecSpace>(0, state.stored.count),
      KOKKOS_LAMBDA(const int row, double& most) {
        double sum = 0.0;
        for (int k = 0; k < table.count(row); ++k)
          sum += table.weight(row, k) > 0.0 ? table.weight(row, k) : 0.0;
        most = sum > most ? sum : most;
      },
      Kokkos::Max<double>(largest));
  return state.ranks.max(largest > 1.0 ? largest : 1.0);
}

template <int D>
void findTemperature(State<D>& state, const HeatNodes<D>& heat)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const NodePositions<D> positions = nodePositions(state);
  const Vector<D> origin = commonOrigin(state);
  const bool mechanics = state.method.mechanics;
  Kokkos::parallel_for(
      "rhegma::thermal::findTemperature", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        const Vector<D> x = positions(latticeNode(nodes, n)) - origin;
        const double capacity =
            heat.sums(n, HeatNodes<D>::capacityAt) + heat.rate(n, HeatNodes<D>::leftOutAt);
        double sum = heat.sums(n, HeatNodes<D>::heatAt);
        for (int d = 0; d < D; ++d)
          sum += x[d] * heat.sums(n, HeatNodes<D>::momentAt + d);
        heat.value(n, 0) = capacity > 0.0 ? sum / capacity : 0.0;
        heat.value(n, 1) = 0.0;
        heat.value(n, 2) = heat.value(n, 0);
        // Points on surfaces only need ratios of nodal masses.
        if (!mechanics)
          nodes.sums(n, Nodes<D>::massAt) = heat.sums(n, HeatNodes<D>::capacityAt);
      });
}

template <int D>
void fluxToNodes(const State<D>& state, const HeatNodes<D>& nodes, const View<double*>& supply)
{
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     const FieldTable& table = state.particles;
                     const FluxBlock<D, Connect> block{connect, nodes, particleFlux(state),
                                                       table.real<D>(fields::temperatureGradient), supply};
                     forEachBlock("rhegma::thermal::fluxToNodes", state.mesh.blocks, block);
                   });
}

template <int D>
double changeTemperature(const State<D>& state, const HeatNodes<D>& heat, double dt)
{
  const Nodes<D> nodes = state.mesh.nodes;
  double fromOutside = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::thermal::changeTemperature", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i, double& sum) {
        const int n = activeNode(nodes, i);
        const double capacity = heat.sums(n, HeatNodes<D>::capacityAt), flow = dt * heat.rate(n, 0);
        if (heat.held(n) == 0)
          heat.value(n, 1) = capacity > 0.0 ? flow / capacity : 0.0;
        else if (isOwnedByThisRank(nodes, n))
          sum += capacity * heat.value(n, 1) - flow;
      },
      fromOutside);
  return fromOutside;
}

template <int D>
void changeToParticles(State<D>& state, const HeatNodes<D>& nodes, double fraction,
                       const View<double*>& supply, double dt)
{
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     const FieldTable& table = state.particles;
                     const ChangeBlock<D, Connect> block{connect,
                                                         nodes,
                                                         state.materials.thermo,
                                                         table.scalar(fields::volume),
                                                         table.scalar(fields::temperature),
                                                         table.scalar(fields::internalEnergy),
                                                         table.integer(fields::material),
                                                         supply,
                                                         state.stored.count > 0 ? state.stored.row
                                                                                : View<int*>(),
                                                         fraction,
                                                         dt,
                                                         state.method.mechanics};
                     forEachBlock("rhegma::thermal::changeToParticles", state.mesh.blocks, block);
                   });
}

template struct HeatNodes<2>;
template struct HeatNodes<3>;
template double largestPositiveSum(const State<2>&);
template double largestPositiveSum(const State<3>&);
template void heatToNodes(const State<2>&, const HeatNodes<2>&);
template void heatToNodes(const State<3>&, const HeatNodes<3>&);
template void findTemperature(State<2>&, const HeatNodes<2>&);
template void findTemperature(State<3>&, const HeatNodes<3>&);
template void fluxToNodes(const State<2>&, const HeatNodes<2>&, const View<double*>&);
template void fluxToNodes(const State<3>&, const HeatNodes<3>&, const View<double*>&);
template double changeTemperature(const State<2>&, const HeatNodes<2>&, double);
template double changeTemperature(const State<3>&, const HeatNodes<3>&, double);
template void changeToParticles(State<2>&, const HeatNodes<2>&, double, const View<double*>&, double);
template void changeToParticles(State<3>&, const HeatNodes<3>&, double, const View<double*>&, double);

} // namespace Rhegma::thermal
