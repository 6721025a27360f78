#include "contact/Balance.hpp"

#include "archive/Archive.hpp"
#include "state/ParticleEnergy.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>

namespace Rhegma::contact
{

namespace
{

/// Sum of momentum times acceleration of the nodes [W].
template <int D>
double power(const Nodes<D>& nodes)
{
  double total = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::contact::power", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i, double& sum) {
        const int n = activeNode(nodes, i);
        for (int d = 0; d < D && isOwnedByThisRank(nodes, n); ++d)
          sum += nodes.sums(n, Nodes<D>::momentumAt + d) * nodes.motion(n, Nodes<D>::accelerationAt + d);
      },
      total);
  return total;
}

/// Kinetic and strain energy of all particles [J].
template <int D>
double totalEnergy(const State<D>& state)
{
  const ParticleEnergy<D> energy(state);
  double total = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::contact::totalEnergy", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& sum) { sum += energy.kinetic(p) + energy.strain(p); }, total);
  return total;
}

/// What loads, supports and burnt gas have done [J].
double workIn(const EnergyBalance& energy) { return energy.externalWork + energy.combustion; }

} // namespace

template <int D>
void Balance<D>::begin(const State<D>& state)
{
  workBefore_ = workIn(state.energy);
  if (!state.mesh.subdomain || !state.clock.observing)
    return;
  // Records since the last sample belong to each rank.
  const double before = workIn(state.sample.energy);
  workBefore_ = before + state.ranks.sum(workBefore_ - before);
}

template <int D>
void Balance<D>::measure(const State<D>& state, double stored)
{
  double parts[2] = {power(state.mesh.nodes), totalEnergy(state)};
  sumParts(state, parts, 2);
  const double soon = state.clock.dt * parts[0] - state.motion.substeps.lateWork;
  found_ = parts[1] + 0.5 * soon + stored;
}

template <int D>
void Balance<D>::compare(const State<D>& state, double lost)
{
  const double in = state.energy.start + 0.5 * (workBefore_ + workIn(state.energy)) - lost;
  scale_ = std::max(scale_, in);
  last_ = found_ - in;
  smallest_ = std::min(smallest_, last_);
  largest_ = std::max(largest_, last_);
}

template <int D>
void Balance<D>::serialize(Archive& archive)
{
  archive("work_before", workBefore_);
  archive("found", found_);
  archive("smallest", smallest_);
  archive("largest", largest_);
  archive("last", last_);
  archive("scale", scale_);
}

template class Balance<2>;
template class Balance<3>;

} // namespace Rhegma::contact
