#include "sub_cycling/FineParticles.hpp"

#include "state/CellFrame.hpp"
#include "state/Subdomain.hpp"
#include "sub_cycling/SlotRow.hpp"
#include "sub_cycling/TrialStress.hpp"
#include "transfer/Connectivity.hpp"
#include "transfer/Motion.hpp"

#include <algorithm>

namespace Rhegma::sub_cycling
{

namespace
{

/// Particles of a part of a sum. Each part has a sum for every slot, so small parts cost more than they share
/// among threads: small ones only where a few threads would have nothing to do.
constexpr int particlesPerPart = 2048, fewParticlesPerPart = 512;
constexpr int fewParts = 4, mostParts = 32;

/// Parts of the sum over a number of particles; the same for any number of threads.
int partsOf(int particles)
{
  const int large = (particles + particlesPerPart - 1) / particlesPerPart,
            small = (particles + fewParticlesPerPart - 1) / fewParticlesPerPart;
  return std::min(std::max(large, std::min(small, fewParts)), mostParts);
}

/// Number of steps over which the mean of a force is taken.
constexpr double meanOver = 500.0;

using Range = Kokkos::RangePolicy<ExecSpace>;

} // namespace

template <int D>
template <class Add>
void FineParticles<D>::sumInParts(const char* label, int begin, int end, const Add& add)
{
  const int number = partsOf(end - begin);
  if (static_cast<int>(parts_.extent(0)) < number || static_cast<int>(parts_.extent(1)) < numSlots_)
    parts_ = View<double** [D]>("rhegma::subcycling::parts", mostParts, numSlots_ + numSlots_ / 4);
  numParts_ = number;
  const View<double** [D]> parts = parts_;
  const int slots = numSlots_;
  Kokkos::parallel_for(
      label,
      Kokkos::RangePolicy<ExecSpace, Kokkos::Schedule<Kokkos::Dynamic>>(0, number, Kokkos::ChunkSize(1)),
      KOKKOS_LAMBDA(const int part) {
        double* const to = &parts(part, 0, 0);
        for (int i = 0; i < slots * D; ++i)
          to[i] = 0.0;
        const int from = begin + static_cast<int>(static_cast<long>(end - begin) * part / number);
        const int until = begin + static_cast<int>(static_cast<long>(end - begin) * (part + 1) / number);
        for (int i = from; i < until; ++i)
          add(i, to);
      });
}

template <int D>
template <ShearStrain H, class Trial>
void FineParticles<D>::sumForces(const State<D>& state, int level, const Values& displacement,
                                 const Trial& trial)
{
  const View<int*> count = count_, particle = particle_;
  const View<int * [stencilCapacity<D>]> slot = slot_;
  const View<double***> slope = slope_;
  const auto volume = state.particles.scalar(fields::volume);
  const CellFrame<D> frame(state);
  const double* const displaced = displacement.data();
  constexpr bool eachComponent = H == ShearStrain::AtCellCentres;
  constexpr int slopes = ComponentSlopes<D, H>::size;
  sumInParts(
      "rhegma::subcycling::force", particlesFrom_[level + 1], particlesFrom_[level],
      KOKKOS_LAMBDA(const int i, double* sums) {
        const int p = particle(i), entries = count(i);
        const int* const at = &slot(i, 0);
        const double* const of = &slope(i, 0, 0);
        SlotRow<D> steep[D]; // column b: slopes along axis b
        for (int b = 0; b < D; ++b)
          steep[b] = SlotRow<D>::zero();
        for (int k = 0; k < entries; ++k)
        {
          const SlotRow<D> moved = SlotRow<D>::load(displaced + D * at[k]);
          forEachSlope<D, eachComponent>(of + k * slopes,
                                         [&](int b, const auto& along) { steep[b].add(along, moved); });
        }
        double gradient[D][D], tau[symmetricSize<D>], back[D][D], change[D * D];
        for (int a = 0; a < D; ++a)
          for (int b = 0; b < D; ++b)
            change[a * D + b] = steep[b][a];
        if (frame.undeformed)
          frame.pushForward(p, change);
        for (int a = 0; a < D; ++a)
          for (int b = 0; b < D; ++b)
            gradient[a][b] = change[a * D + b];
        trial(p, gradient, tau);
        inverseOfMotion<D>(gradient, back);
        double T[D * D] = {}; // times the slopes before the step the force
        for (int a = 0; a < D; ++a)
          for (int c = 0; c < D; ++c)
            for (int b = 0; b < D; ++b)
              T[a * D + c] -= volume(p) * tau[symmetricIndex<D>(a, b)] * back[c][b];
        if (frame.undeformed)
          frame.pullBack(p, T);
        SlotRow<D> flux[D];
        for (int c = 0; c < D; ++c)
        {
          double column[D];
          for (int a = 0; a < D; ++a)
            column[a] = T[a * D + c];
          flux[c] = SlotRow<D>::load(column);
        }
        for (int k = 0; k < entries; ++k)
        {
          double* const to = sums + D * at[k];
          SlotRow<D> sum = SlotRow<D>::load(to);
          forEachSlope<D, eachComponent>(of + k * slopes,
                                         [&](int c, const auto& along) { sum.add(along, flux[c]); });
          sum.store(to);
        }
      });
}

template <int D>
void FineParticles<D>::force(const State<D>& state, int level, const Values& displacement, double duration,
                             const Values& force)
{
  const auto sumWith = [&](const auto& trial)
  {
    if (state.method.shear == ShearStrain::AtCellCentres)
      sumForces<ShearStrain::AtCellCentres>(state, level, displacement, trial);
    else
      sumForces<ShearStrain::AtParticles>(state, level, displacement, trial);
  };
  if (state.materials.thermo.empty())
    sumWith(LawStress<D>(state, duration));
  else
    sumWith(HeatedStress<D>(state, duration));
  addParts(force);
}

template <int D>
void FineParticles<D>::addParts(const Values& sum) const
{
  const View<double** [D]> parts = parts_;
  const int number = numParts_;
  parallelForSmall<smallSlots>(
      "rhegma::subcycling::addParts", 0, numSlots_, KOKKOS_LAMBDA(const int i) {
        for (int d = 0; d < D; ++d)
        {
          double all = 0.0;
          for (int part = 0; part < number; ++part)
            all += parts(part, i, d);
          sum(i, d) = all;
        }
      });
}

template <int D>
void FineParticles<D>::roundTrip(const State<D>& state, int lowest)
{
  const View<int*> count = count_, reach = reach_, particle = particle_;
  const View<int * [stencilCapacity<D>]> slot = slot_;
  const View<double * [stencilCapacity<D>]> weight = weight_;
  const double* const accelerated = acceleration_.data();
  const auto mass = state.particles.scalar(fields::mass);
  sumInParts(
      "rhegma::subcycling::roundTrip", 0, numListed_, KOKKOS_LAMBDA(const int i, double* to) {
        if (reach(i) < lowest)
          return;
        const int entries = count(i);
        const int* const at = &slot(i, 0);
        const double* const w = &weight(i, 0);
        SlotRow<D> own = SlotRow<D>::zero();
        for (int k = 0; k < entries; ++k)
          own.add(w[k], SlotRow<D>::load(accelerated + D * at[k]));
        const double m = mass(particle(i));
        for (int k = 0; k < entries; ++k)
        {
          SlotRow<D> sum = SlotRow<D>::load(to + D * at[k]);
          sum.add(m * w[k], own);
          sum.store(to + D * at[k]);
        }
      });
}

template <int D>
void FineParticles<D>::accelerate(const State<D>& state, int level, double duration, const Values& force,
                                  const Values& velocity, bool supports)
{
  fit(acceleration_, "rhegma::subcycling::acceleration", numSlots_);
  const Values acceleration = acceleration_, before = before_, momentum = momentum_;
  const View<int* [D]> held = held_;
  const View<double*> nodal = mass_;
  const View<double* [D]> heldVelocity = heldVelocity_;
  const bool coupled = static_cast<bool>(state.motion.coupledSlots.solve);
  const int lowest = coupled ? 0 : level; // a coupled mass moves nodes without a force too
  parallelForSmall<smallSlots>(
      "rhegma::subcycling::accelerate", 0, numSlots_, KOKKOS_LAMBDA(const int i) {
        const double inverse = nodal(i) > 0.0 ? 1.0 / nodal(i) : 0.0;
        for (int d = 0; d < D; ++d)
          acceleration(i, d) = held(i, d) == 0 ? inverse * force(i, d)
                               : supports      ? (heldVelocity(i, d) - before(i, d)) / duration
                                               : 0.0;
      });
  if (coupled)
    state.motion.coupledSlots.solve(force, acceleration, true);
  slowRelativeMotion(state, acceleration);
  roundTrip(state, lowest);
  addParts(momentum);
  sumSlots(state, momentum);
  parallelForSmall<smallSlots>(
      "rhegma::subcycling::arrive", 0, numSlots_, KOKKOS_LAMBDA(const int i) {
        const double inverse = nodal(i) > 0.0 ? 1.0 / nodal(i) : 0.0;
        for (int d = 0; d < D; ++d)
          acceleration(i, d) = held(i, d) != 0 ? 0.0 : inverse * momentum(i, d);
      });
  if (coupled)
    state.motion.coupledSlots.solve(momentum, acceleration, true);
  slowRelativeMotion(state, acceleration);
  parallelForSmall<smallSlots>(
      "rhegma::subcycling::kick", 0, numSlots_, KOKKOS_LAMBDA(const int i) {
        for (int d = 0; d < D; ++d)
          velocity(i, d) += duration * acceleration(i, d);
      });
}

template <int D>
void FineParticles<D>::slowRelativeMotion(const State<D>& state, const Values& acceleration) const
{
  const View<double*> added = state.motion.relativeInertia;
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int*> slotOf = slotOf_;
  const View<double*> mass = mass_;
  const View<int* [D]> held = held_;
  parallelForSmall(
      "rhegma::subcycling::slowRelativeMotion", added.extent(0) > 0 ? nodes.numOfCracks : 0,
      KOKKOS_LAMBDA(const int i) {
        const int primary = nodes.parent(i), a = slotOf(primary), b = slotOf(nodes.numLattice + i);
        if (!(added(primary) > 0.0) || a < 0 || b < 0)
          return;
        for (int d = 0; d < D; ++d)
        {
          if (held(a, d) != 0)
            continue;
          const double taken = takenByInertia(mass(a), mass(b), mass(a) * acceleration(a, d),
                                              mass(b) * acceleration(b, d), added(primary));
          acceleration(a, d) -= taken / mass(a);
          acceleration(b, d) += taken / mass(b);
        }
      });
}

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
  // A run that starts in equilibrium starts with its mean: from zero it would approach it by impulses. Nodes
  // that come later start from zero, because a force that is held for a step feeds waves where it is held
  // again and again.
  const bool starts = state.clock.step == 0;
  const int inner = numInner_;
  parallelForSmall<smallSlots>(
      "rhegma::subcycling::smooth", 0, numSlots_, KOKKOS_LAMBDA(const int i) {
        const int row = rowOf(nodeOf(i));
        for (int d = 0; d < D; ++d)
        {
          const double before = starts && i < inner         ? force(i, d)
                                : kept(row, D) == now - 1.0 ? kept(row, d)
                                                            : 0.0;
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

template void FineParticles<2>::force(const State<2>&, int, const Values&, double, const Values&);
template void FineParticles<2>::accelerate(const State<2>&, int, double, const Values&, const Values&, bool);
template void FineParticles<3>::force(const State<3>&, int, const Values&, double, const Values&);
template void FineParticles<3>::accelerate(const State<3>&, int, double, const Values&, const Values&, bool);
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
