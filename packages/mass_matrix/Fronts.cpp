#include "mass_matrix/Fronts.hpp"

#include "transfer/LocalSpacing.hpp"

namespace Rhegma::mass_matrix
{

namespace
{

/// Edge of the cell at each vertex of a front, in cells of the lattice, where it may lie in another rank's;
/// else empty.
template <int D>
View<double*> edgesOnRanks(const State<D>& state)
{
  if (!state.mesh.subdomain || !state.mesh.tree.refined())
    return {};
  const auto host = [](const auto& view) { return onHost(view); };
  const auto kind = host(state.cracks.kind);
  const auto vertex = host(state.cracks.vertex);
  const View<double*> edges("rhegma::massFrontEdges", kind.extent(0));
  const auto edge = Kokkos::create_mirror_view(edges);
  for (std::size_t v = 0; v < kind.extent(0); ++v)
  {
    if ((kind(v) & vertexKind::front) == 0)
      continue;
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = vertex(v, d);
    edge(v) = spacingAt(state, x) / state.mesh.grid.spacing;
  }
  Kokkos::deep_copy(edges, edge);
  return edges;
}

} // namespace

template <int D>
void listFronts(const State<D>& state, const Unlumping& unlumping, View<double* [D]>& positions,
                View<double* [2]>& zones, int& count)
{
  const View<int*> kind = state.cracks.kind;
  const View<double* [D]> vertex = state.cracks.vertex;
  const int vertices = static_cast<int>(kind.extent(0));
  if (static_cast<int>(positions.extent(0)) < vertices)
  {
    positions = View<double* [D]>("rhegma::massFronts", vertices);
    zones = View<double* [2]>("rhegma::massZones", vertices);
  }
  const View<double* [D]> list = positions;
  const View<double* [2]> zone = zones;
  const TreeSight<D> sight(state.mesh.grid, state.mesh.tree);
  const View<double*> edges = edgesOnRanks(state);
  const Unlumping u = unlumping;
  count = 0;
  Kokkos::parallel_scan(
      "rhegma::mass::listFronts", Kokkos::RangePolicy<ExecSpace>(0, vertices),
      KOKKOS_LAMBDA(const int v, int& at, const bool final) {
        if ((kind(v) & vertexKind::front) == 0)
          return;
        if (final)
        {
          Vector<D> x;
          for (int d = 0; d < D; ++d)
            x[d] = list(at, d) = vertex(v, d);
          const double shrunk = edges.extent(0) > 0 ? edges(v) : sight.refined ? sight.leafAt(x).edge : 1.0;
          zone(at, 0) = u.radiusShrinks ? shrunk * u.radius : u.radius;
          zone(at, 1) = u.edgeShrinks ? shrunk * u.edge : u.edge;
        }
        ++at;
      },
      count);
}

template void listFronts(const State<2>&, const Unlumping&, View<double* [2]>&, View<double* [2]>&, int&);
template void listFronts(const State<3>&, const Unlumping&, View<double* [3]>&, View<double* [2]>&, int&);

} // namespace Rhegma::mass_matrix
