#include "thermal/MeetingMaterials.hpp"

#include "state/Subdomain.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma::thermal
{

namespace
{

template <int D, class Connect>
struct MarkBlock
{
  Connect connect;
  HeatNodes<D> nodes;
  ThermoTables tables;
  BorrowedView<double*> temperature;
  BorrowedView<int*> material;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
    {
      if (!(ThermoPoint(tables, material(p), temperature(p)).conductivity() > 0.0))
        continue;
      const double number = material(p);
      connect.visit(p,
                    [&](int node, double weight, const double*)
                    {
                      if (!HeatNodes<D>::touches(weight))
                        return;
                      nodes.meets(node, 0) += 1.0;
                      nodes.meets(node, 1) += number;
                      nodes.meets(node, 2) += number * number;
                    });
    }
  }
};

template <int D, class Connect>
struct JoinBlock
{
  Connect connect;
  HeatNodes<D> heat;
  Nodes<D> nodes;
  NodePositions<D> positions;
  ThermoTables tables;
  BorrowedView<double*[D]> position, gradient;
  BorrowedView<double*> temperature;
  BorrowedView<int*> material;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
    {
      double change = 0.0;
      connect.visit(p,
                    [&](int node, double weight, const double*)
                    {
                      const double fraction = heat.meets(node, HeatNodes<D>::joinAt);
                      if (fraction == 0.0 || !(weight > 0.0)) // as in the nodes' means
                        return;
                      const Vector<D> x = positions(latticeNode(nodes, node));
                      double expected = temperature(p);
                      for (int d = 0; d < D; ++d)
                        expected += gradient(p, d) * (x[d] - position(p, d));
                      change += fraction * weight * (heat.value(node, 2) - expected);
                    });
      const bool conducts = ThermoPoint(tables, material(p), temperature(p)).conductivity() > 0.0;
      heat.joined(p) = conducts ? change : 0.0;
    }
  }
};

} // namespace

template <int D>
void markMaterials(const State<D>& state, const HeatNodes<D>& nodes, double fraction)
{
  const Nodes<D> all = state.mesh.nodes;
  const HeatNodes<D> heat = nodes;
  Kokkos::parallel_for(
      "rhegma::thermal::clearMaterials", Kokkos::RangePolicy<ExecSpace>(0, all.numActive()),
      KOKKOS_LAMBDA(const int i) {
        for (int k = 0; k < HeatNodes<D>::meetWidth; ++k)
          heat.meets(activeNode(all, i), k) = 0.0;
      });
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     const MarkBlock<D, Connect> block{connect, nodes, state.materials.thermo,
                                                       state.particles.scalar(fields::temperature),
                                                       state.particles.integer(fields::material)};
                     forEachBlock("rhegma::thermal::markMaterials", state.mesh.blocks, block);
                   });
  sumOverRanks(state, nodes.meets.data(), HeatNodes<D>::meetWidth, 0, HeatNodes<D>::joinAt);
  Kokkos::parallel_for(
      "rhegma::thermal::fractionOfNodes", Kokkos::RangePolicy<ExecSpace>(0, all.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(all, i);
        heat.meets(n, HeatNodes<D>::joinAt) = heat.severalAt(n) ? fraction : 0.0;
      });
}

template <int D>
void joinMaterials(const State<D>& state, const HeatNodes<D>& nodes)
{
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     const FieldTable& table = state.particles;
                     const JoinBlock<D, Connect> block{connect,
                                                       nodes,
                                                       state.mesh.nodes,
                                                       nodePositions(state),
                                                       state.materials.thermo,
                                                       table.real<D>(fields::position),
                                                       table.real<D>(fields::temperatureGradient),
                                                       table.scalar(fields::temperature),
                                                       table.integer(fields::material)};
                     forEachBlock("rhegma::thermal::joinMaterials", state.mesh.blocks, block);
                   });
}

template void markMaterials(const State<2>&, const HeatNodes<2>&, double);
template void markMaterials(const State<3>&, const HeatNodes<3>&, double);
template void joinMaterials(const State<2>&, const HeatNodes<2>&);
template void joinMaterials(const State<3>&, const HeatNodes<3>&);

} // namespace Rhegma::thermal
