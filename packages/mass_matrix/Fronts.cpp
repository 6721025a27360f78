#include "mass_matrix/Fronts.hpp"

namespace Rhegma::mass_matrix
{

template <int D>
void listFronts(const State<D>& state, View<double* [D]>& places, int& count)
{
  const View<int*> kind = state.cracks.kind;
  const View<double* [D]> vertex = state.cracks.vertex;
  const int vertices = static_cast<int>(kind.extent(0));
  if (static_cast<int>(places.extent(0)) < vertices)
    places = View<double* [D]>("rhegma::massFronts", vertices);
  const View<double* [D]> list = places;
  count = 0;
  Kokkos::parallel_scan(
      "rhegma::mass::listFronts", Kokkos::RangePolicy<ExecSpace>(0, vertices),
      KOKKOS_LAMBDA(const int v, int& at, const bool final) {
        if ((kind(v) & vertexKind::front) == 0)
          return;
        if (final)
          for (int d = 0; d < D; ++d)
            list(at, d) = vertex(v, d);
        ++at;
      },
      count);
}

template void listFronts(const State<2>&, View<double* [2]>&, int&);
template void listFronts(const State<3>&, View<double* [3]>&, int&);

} // namespace Rhegma::mass_matrix
