#include "cracks/Normals.hpp"

#include "cracks/CrackGeometry.hpp"

namespace Rhegma::cracks
{

void updateNormals(const State<2>& state, const View<int*>& row)
{
  const CrackSight<2> sight(state.cracks, state.mesh.grid.spacing);
  const auto position = state.particles.real<2>(fields::position);
  const auto side = state.particles.integer(fields::side);
  const auto normal = state.particles.real<2>(crackNormal);
  Kokkos::parallel_for(
      "rhegma::cracks::updateNormals", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p) {
        const int named = row(p) < 0 ? 0 : side(p);
        const int crack = (named > 0 ? named : -named) - 1;
        if (crack < 0)
          return;
        const Vector<2> x{position(p, 0), position(p, 1)};
        int nearest = -1;
        double least = 1e300;
        for (int s = 0; s < static_cast<int>(sight.simplex.extent(0)); ++s)
        {
          const double square = sight.crackOf(s) == crack ? sight.square(s, x) : 1e300;
          if (square < least)
          {
            least = square;
            nearest = s;
          }
        }
        // From side -1 to side +1, so out of the material on side -1.
        for (int d = 0; d < 2; ++d)
          normal(p, d) = named > 0 ? -sight.normal(nearest, d) : sight.normal(nearest, d);
      });
}

} // namespace Rhegma::cracks
