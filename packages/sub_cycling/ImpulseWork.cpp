#include "sub_cycling/FineParticles.hpp"

namespace Rhegma::sub_cycling
{

template <int D>
typename FineParticles<D>::ImpulseWork FineParticles<D>::workOf(const State<D>& state,
                                                                const Values& impulse) const
{
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int*> nodeOf = nodeOf_;
  const Values velocity = before_;
  const View<int*> coupledRow = state.motion.coupledRow;
  const View<int* [D]> held = held_;
  const View<double* [D]> heldVelocity = heldVelocity_;
  ImpulseWork work;
  Kokkos::parallel_reduce(
      "rhegma::subcycling::workOfImpulses", Kokkos::RangePolicy<ExecSpace>(0, numInner_),
      KOKKOS_LAMBDA(const int i, double& free, double& atSupports) {
        for (int d = 0; d < D && isOwnedByThisRank(nodes, nodeOf(i)); ++d)
        {
          const double before = velocity(i, d);
          if (held(i, d) == 0)
            free += before * impulse(i, d);
          else if (coupledRow.extent(0) > 0 && coupledRow(nodeOf(i)) >= 0)
            atSupports += 0.5 * (heldVelocity(i, d) - before) * impulse(i, d);
        }
      },
      work.free, work.held);
  return work;
}

template FineParticles<2>::ImpulseWork FineParticles<2>::workOf(const State<2>&, const Values&) const;
template FineParticles<3>::ImpulseWork FineParticles<3>::workOf(const State<3>&, const Values&) const;

} // namespace Rhegma::sub_cycling
