#include "mass_matrix/Fronts.hpp"

namespace Rhegma::mass_matrix
{

template <int D>
void listFronts(const State<D>& state, const Unlumping& unlumping, View<double* [D]>& places,
                View<double* [2]>& zones, int& count)
{
  const View<int*> kind = state.cracks.kind;
  const View<double* [D]> vertex = state.cracks.vertex;
  const int vertices = static_cast<int>(kind.extent(0));
  if (static_cast<int>(places.extent(0)) < vertices)
  {
    places = View<double* [D]>("rhegma::massFronts", vertices);
    zones = View<double* [2]>("rhegma::massZones", vertices);
  }
  const View<double* [D]> list = places;
  const View<double* [2]> zone = zones;
  const TreeSight<D> sight(state.grid, state.tree);
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
          const double shrunk = sight.refined ? sight.leafAt(x).edge : 1.0;
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
