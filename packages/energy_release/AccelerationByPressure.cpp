#include "energy_release/AccelerationByPressure.hpp"

#include "state/Subdomain.hpp"
#include "transfer/FacePoints.hpp"
#include "transfer/PushNodes.hpp"

namespace Rhegma::energy_release
{

template <int D>
bool isPressed(const State<D>& state)
{
  return state.clock.step > 0 && state.cracks.pressure.extent(0) > 0 &&
         state.cracks.pressure.extent(0) == state.cracks.simplex.extent(0);
}

template <int D>
void addAccelerationByPressure(const State<D>& state, const NodalAcceleration<D>& acceleration)
{
  if (!isPressed(state))
    return;
  FacePoints<D> points;
  points.update(state);
  const View<double* [D]> force("rhegma::forceOfFacePressure", acceleration.extent(0));
  const View<double*> pressure = state.cracks.pressure;
  const View<int*> simplex = points.simplex();
  const FacePoints<D> p = points;
  const double thickness = D == 2 ? state.method.thickness : 1.0;
  forEachPushing(
      "rhegma::forceOfFacePressure", points.count(), KOKKOS_LAMBDA(const int k) {
        const double size = pressure(simplex(k)) * p.currentSize(k) * thickness;
        for (int d = 0; d < D; ++d)
        {
          for (int e = 0; e < p.above.count(k); ++e)
            Kokkos::atomic_add(&force(p.above.node(k, e), d), p.above.weight(k, e) * size * p.normal(k, d));
          for (int e = 0; e < p.below.count(k); ++e)
            Kokkos::atomic_add(&force(p.below.node(k, e), d), -p.below.weight(k, e) * size * p.normal(k, d));
        }
      });
  sumOverRanks(state, force.data(), D, 0, D);
  Kokkos::parallel_for(
      "rhegma::accelerationByFacePressure", Kokkos::RangePolicy<ExecSpace>(0, acceleration.extent(0)),
      KOKKOS_LAMBDA(const int n) {
        const double mass = acceleration(n, D);
        for (int d = 0; d < D; ++d)
          acceleration(n, d) += mass > 0.0 ? force(n, d) / mass : 0.0;
      });
}

template bool isPressed(const State<2>&);
template bool isPressed(const State<3>&);
template void addAccelerationByPressure(const State<2>&, const NodalAcceleration<2>&);
template void addAccelerationByPressure(const State<3>&, const NodalAcceleration<3>&);

} // namespace Rhegma::energy_release
