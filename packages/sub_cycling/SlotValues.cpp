#include "state/Subdomain.hpp"
#include "sub_cycling/FineParticles.hpp"

namespace Rhegma::sub_cycling
{

namespace
{

/// Number of steps over which the mean of a force is taken.
constexpr double meanOver = 500.0;

} // namespace

template <int D>
void FineParticles<D>::sumSlots(const State<D>& state, const Values& values) const
{
  sumOverRanks(state, values.data(), D, 0, D, slotOf_);
}

template <int D>
void FineParticles<D>::load(const State<D>& state, const Values& force) const
{
  const auto sums = state.mesh.nodes.sums;
  const View<int*> nodeOf = nodeOf_;
  parallelForSmall<smallSlots>(
      "rhegma::subcycling::load", 0, numSlots_, KOKKOS_LAMBDA(const int i) {
        for (int d = 0; d < D; ++d)
          force(i, d) = sums(nodeOf(i), Nodes<D>::forceAt + d);
      });
  sumSlots(state, force);
}

template <int D>
void FineParticles<D>::store(const State<D>& state, const Values& force, double factor) const
{
  const Nodes<D> nodes = state.mesh.nodes;
  const auto sums = state.mesh.nodes.sums;
  const View<int*> nodeOf = nodeOf_;
  // The stored forces are summed over the ranks later.
  parallelForSmall<smallSlots>(
      "rhegma::subcycling::store", 0, numInner_, KOKKOS_LAMBDA(const int i) {
        const bool counts = isOwnedByThisRank(nodes, nodeOf(i));
        for (int d = 0; d < D; ++d)
          sums(nodeOf(i), Nodes<D>::forceAt + d) = counts ? factor * force(i, d) : 0.0;
      });
}

template <int D>
void FineParticles<D>::startVelocity(const State<D>& state, const Values& velocity)
{
  fit(before_, "rhegma::subcycling::before", numSlots_);
  fit(momentum_, "rhegma::subcycling::momentum", numSlots_);
  const auto sums = state.mesh.nodes.sums;
  const View<int*> nodeOf = nodeOf_;
  const View<double*> mass = mass_;
  const View<int* [D]> held = held_;
  const View<double* [D]> heldVelocity = heldVelocity_;
  const Values before = before_, momentum = momentum_;
  parallelForSmall<smallSlots>(
      "rhegma::subcycling::startVelocity", 0, numSlots_, KOKKOS_LAMBDA(const int i) {
        const double inverse = mass(i) > 0.0 ? 1.0 / mass(i) : 0.0;
        for (int d = 0; d < D; ++d)
        {
          momentum(i, d) = sums(nodeOf(i), Nodes<D>::momentumAt + d);
          before(i, d) = inverse * momentum(i, d);
        }
      });
  if (state.motion.coupledSlots.begin)
  {
    state.motion.coupledSlots.begin(state, slots(), held_);
    state.motion.coupledSlots.solve(momentum, before, false);
  }
  parallelForSmall<smallSlots>(
      "rhegma::subcycling::heldVelocity", 0, numSlots_, KOKKOS_LAMBDA(const int i) {
        for (int d = 0; d < D; ++d)
          velocity(i, d) = held(i, d) != 0 ? heldVelocity(i, d) : before(i, d);
      });
}

template <int D>
void FineParticles<D>::smooth(const State<D>& state, int level, const Values& force, const Values& mean)
{
  const auto kept = state.mesh.nodalFields.template real<D + 1>(meanForceField(level + 1 - first_));
  const NodalFieldRow<D> rowOf = state.mesh.nodalFields.rowsOf(state.mesh.nodes);
  const View<int*> nodeOf = nodeOf_;
  const auto now = static_cast<double>(state.clock.step);
  const int inner = numInner_;
  parallelForSmall<smallSlots>(
      "rhegma::subcycling::smooth", 0, numSlots_, KOKKOS_LAMBDA(const int i) {
        const int row = rowOf(nodeOf(i));
        for (int d = 0; d < D; ++d)
        {
          const double before = kept(row, D) == now - 1.0 ? kept(row, d) : 0.0;
          kept(row, d) = before + (force(i, d) - before) / meanOver;
          mean(i, d) = i < inner ? kept(row, d) : 0.0;
        }
        kept(row, D) = now;
      });
}

template <int D>
void FineParticles<D>::correctMotion(const State<D>& state, const Values& displacement, double duration,
                                     const Values& velocity) const
{
  const auto motion = state.mesh.nodes.motion;
  const View<int*> nodeOf = nodeOf_;
  const View<int* [D]> held = held_;
  parallelForSmall<smallSlots>(
      "rhegma::subcycling::correctMotion", 0, numSlots_, KOKKOS_LAMBDA(const int i) {
        for (int d = 0; d < D; ++d)
          if (held(i, d) == 0)
            motion(nodeOf(i), d) += displacement(i, d) / duration - velocity(i, d);
      });
}

template <int D>
void FineParticles<D>::correctProjection(const State<D>& state, const Values& displacement, double duration,
                                         const Values& velocity) const
{
  const auto projection = state.mesh.nodes.projection;
  const View<int*> nodeOf = nodeOf_;
  const View<int* [D]> held = held_;
  parallelForSmall<smallSlots>(
      "rhegma::subcycling::correctProjection", 0, numSlots_, KOKKOS_LAMBDA(const int i) {
        for (int d = 0; d < D; ++d)
          if (held(i, d) == 0)
            projection(nodeOf(i), d) += displacement(i, d) / duration - velocity(i, d);
      });
}

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

template void FineParticles<2>::sumSlots(const State<2>&, const Values&) const;
template void FineParticles<2>::load(const State<2>&, const Values&) const;
template void FineParticles<2>::store(const State<2>&, const Values&, double) const;
template void FineParticles<2>::startVelocity(const State<2>&, const Values&);
template void FineParticles<2>::smooth(const State<2>&, int, const Values&, const Values&);
template void FineParticles<2>::correctMotion(const State<2>&, const Values&, double, const Values&) const;
template void FineParticles<2>::correctProjection(const State<2>&, const Values&, double,
                                                  const Values&) const;
template FineParticles<2>::ImpulseWork FineParticles<2>::workOf(const State<2>&, const Values&) const;
template void FineParticles<3>::sumSlots(const State<3>&, const Values&) const;
template void FineParticles<3>::load(const State<3>&, const Values&) const;
template void FineParticles<3>::store(const State<3>&, const Values&, double) const;
template void FineParticles<3>::startVelocity(const State<3>&, const Values&);
template void FineParticles<3>::smooth(const State<3>&, int, const Values&, const Values&);
template void FineParticles<3>::correctMotion(const State<3>&, const Values&, double, const Values&) const;
template void FineParticles<3>::correctProjection(const State<3>&, const Values&, double,
                                                  const Values&) const;
template FineParticles<3>::ImpulseWork FineParticles<3>::workOf(const State<3>&, const Values&) const;

} // namespace Rhegma::sub_cycling
