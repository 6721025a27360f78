#include "energy_release/ForceOfPressure.hpp"

#include "state/NodalValues.hpp"
#include "state/Subdomain.hpp"
#include "transfer/FacePoints.hpp"
#include "transfer/PushNodes.hpp"

namespace Rhegma::energy_release
{

template <int D>
bool isPressed(const State<D>& state)
{
  return haveNodalValues(state) && state.cracks.pressure.extent(0) > 0 &&
         state.cracks.pressure.extent(0) == state.cracks.simplex.extent(0);
}

template <int D>
View<double* [D]> forceOfPressure(const State<D>& state)
{
  if (!isPressed(state))
    return {};
  FacePoints<D> points;
  points.update(state);
  const View<double* [D]> force("rhegma::forceOfFacePressure", state.mesh.nodes.sums.extent(0));
  const View<double*> pressure = state.cracks.pressure;
  const View<int*> simplex = points.simplex();
  const FacePoints<D> p = points;
  const Depth depth = state.method.depth();
  forEachPushing(
      "rhegma::forceOfFacePressure", points.count(), KOKKOS_LAMBDA(const int k) {
        Vector<D> onUpper;
        for (int d = 0; d < D; ++d)
          onUpper[d] = pressure(simplex(k)) * p.currentSize(k) * depth.at(p.position(k, 0)) * p.normal(k, d);
        addFaceForces<D>(force, p.below, p.above, k, onUpper);
      });
  sumOverRanks(state, force.data(), D, 0, D);
  return force;
}

template bool isPressed(const State<2>&);
template bool isPressed(const State<3>&);
template View<double* [2]> forceOfPressure(const State<2>&);
template View<double* [3]> forceOfPressure(const State<3>&);

} // namespace Rhegma::energy_release
