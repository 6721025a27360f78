#include "transfer/NearestMaterial.hpp"

#include "state/Subdomain.hpp"

namespace Rhegma
{

template <int D>
int materialAt(const State<D>& state, const Vector<D>& x)
{
  using Reducer = Kokkos::MinLoc<double, int>;
  const auto position = state.particles.template real<D>(fields::position);
  typename Reducer::value_type nearest;
  Kokkos::parallel_reduce(
      "rhegma::nearestParticle", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, typename Reducer::value_type& best) {
        double square = 0.0;
        for (int d = 0; d < D; ++d)
          square += (position(p, d) - x[d]) * (position(p, d) - x[d]);
        if (square < best.val)
        {
          best.val = square;
          best.loc = p;
        }
      },
      Reducer(nearest));
  double closeness = -nearest.val; // least where this rank has no particle
  maxParts(state, &closeness, 1);
  int own = 0;
  if (state.particles.size() > 0 && closeness == -nearest.val)
    Kokkos::deep_copy(own, Kokkos::subview(state.particles.integer(fields::material), nearest.loc));
  double index = own;
  maxParts(state, &index, 1);
  return static_cast<int>(index);
}

template int materialAt(const State<2>&, const Vector<2>&);
template int materialAt(const State<3>&, const Vector<3>&);

} // namespace Rhegma
