#include "cracks/Normals.hpp"

#include "cracks/Sides.hpp"

namespace Rhegma::cracks
{

namespace
{

void carryNormalsOf(const State<2>& state, const Polyline& line, int crack, const View<int*>& row)
{
  const auto position = state.particles.real<2>(fields::position);
  const auto side = state.particles.integer(fields::side);
  const auto normal = state.particles.real<2>(crackNormal);
  Kokkos::parallel_for(
      "rhegma::cracks::carryNormals", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p) {
        const int named = row(p) < 0 ? 0 : side(p);
        if ((named > 0 ? named : -named) != crack + 1)
          return;
        const Sight sight = look(line, {position(p, 0), position(p, 1)});
        // From side -1 to side +1, so out of the material on side -1.
        for (int d = 0; d < 2; ++d)
          normal(p, d) = named > 0 ? -sight.normal[d] : sight.normal[d];
      });
}

} // namespace

void carryNormals(const State<2>& state, const View<int*>& row)
{
  const std::vector<Polyline> lines = polylines(state.cracks);
  for (std::size_t c = 0; c < lines.size(); ++c)
    carryNormalsOf(state, lines[c], static_cast<int>(c), row);
}

} // namespace Rhegma::cracks
