#include "energy_release/SharedNodes.hpp"

#include "state/Subdomain.hpp"
#include "transfer/Stencils.hpp"

namespace Rhegma::energy_release
{

template <int D>
std::vector<double> fractionOfNodes(const State<D>& state, int crack, const std::vector<Vector<D>>& positions)
{
  ObservedPoints<D> points;
  points.onAllRanks = true;
  points.count = static_cast<int>(positions.size());
  points.position = View<double* [D]>("rhegma::nearFrontPosition", points.count);
  points.half = View<double* [D]>("rhegma::nearFrontHalf", points.count);
  points.side = View<int*>("rhegma::nearFrontSide", points.count);
  const auto position = Kokkos::create_mirror_view(points.position);
  for (int k = 0; k < points.count; ++k)
    for (int d = 0; d < D; ++d)
      position(k, d) = positions[k][d];
  Kokkos::deep_copy(points.position, position);
  Kokkos::deep_copy(points.side, crack + 1);
  StencilTable<D> stencils;
  pointStencils(state, points, stencils, true);
  const auto count = onHost(stencils.count);
  const auto node = onHost(stencils.node);
  const auto weight = onHost(stencils.weight);
  const auto nodeSide = onHost(state.cracks.nodeSide);
  std::vector<double> shared(points.count, 0.0);
  for (int k = 0; k < points.count; ++k)
    for (int e = 0; e < count(k); ++e)
      if (node(k, e) < state.mesh.nodes.numLattice && nodeSide(node(k, e)) == 0)
        shared[k] += weight(k, e);
  sumParts(state, shared.data(), points.count);
  return shared;
}

template std::vector<double> fractionOfNodes(const State<2>&, int, const std::vector<Vector<2>>&);
template std::vector<double> fractionOfNodes(const State<3>&, int, const std::vector<Vector<3>>&);

} // namespace Rhegma::energy_release
