#include "sub_cycling/LocalSteps.hpp"

#include "archive/Archive.hpp"
#include "state/Subdomain.hpp"
#include "transfer/LaneHeat.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::sub_cycling
{

namespace
{

using Range = Kokkos::RangePolicy<ExecSpace>;

/// to += factor * from.
template <int D>
void add(const View<double* [D]>& to, double factor, const View<double* [D]>& from, int slots)
{
  parallelForSmall<smallSlots>(
      "rhegma::subcycling::add", 0, slots, KOKKOS_LAMBDA(const int i) {
        for (int d = 0; d < D; ++d)
          to(i, d) += factor * from(i, d);
      });
}

} // namespace

template <int D>
void LocalSteps<D>::reserveRows(int slots)
{
  const auto fit = [slots](Values& values)
  {
    if (static_cast<int>(values.extent(0)) < slots)
      values = Values("rhegma::subcycling::values", slots + slots / 4);
  };
  for (Values* values : {&others_, &loads_, &force_, &impulse_, &waiting_, &velocity_, &displacement_})
    fit(*values);
  for (int level = first_ - 1; level <= last_; ++level)
  {
    fit(start_[level]);
    fit(mean_[level]);
  }
}

template <int D>
void LocalSteps<D>::begin(State<D>& state, int first, int last)
{
  first_ = first;
  last_ = last;
  active_ = first <= last && state.mesh.tree.refined();
  state.motion.substeps = {};
  if (state.particles.has(fields::firstFraction))
    Kokkos::deep_copy(state.particles.scalar(fields::firstFraction), 1.0);
  if (!active_)
    return;
  fine_.select(state, first);
  active_ = fine_.numParticles() > 0.0;
  if (!active_)
    return;
  state.motion.substeps.nodes = fine_.slots();
  state.motion.substeps.length = std::ldexp(state.clock.dt, first - 1 - last);
  if (state.particles.has(fields::firstFraction))
    fine_.writeFirstFractions(state, state.particles.scalar(fields::firstFraction));
  const int slots = fine_.numSlots();
  reserveRows(slots);
  Kokkos::deep_copy(displacement_, 0.0);
  elapsed_ = 0.0;
  fine_.load(state, others_);
  Kokkos::deep_copy(loads_, 0.0);
  add<D>(loads_, -1.0, others_, slots); // loads: all forces less these
  for (int level = first_; level <= last_; ++level)
  {
    if (fine_.particlesFrom(level) == fine_.particlesFrom(level + 1))
      continue;
    fine_.force(state, level, displacement_, elapsed_, start_[level]);
    fine_.sumSlots(state, start_[level]);
    atStart_[level] = true;
    add<D>(others_, -1.0, start_[level], slots);
    if (level < last_)
    {
      steady(state, level, start_[level], mean_[level]);
      add<D>(start_[level], -1.0, mean_[level], slots);
    }
  }
}

template <int D>
void LocalSteps<D>::steady(const State<D>& state, int level, const Values& force, const Values& mean)
{
  fine_.smooth(state, level, force, mean);
  add<D>(loads_, 1.0, mean, fine_.numSlots());
}

template <int D>
void LocalSteps<D>::evolve(State<D>& state)
{
  if (!active_)
    return;
  const int slots = fine_.numSlots();
  fine_.load(state, force_);
  add<D>(loads_, 1.0, force_, slots);
  finishOuterNodes();
  for (const DisplacementDependentForce<D>& dependent : state.motion.displacementDependentForces)
  {
    Kokkos::deep_copy(force_, 0.0);
    dependent.frozen(state, fine_.slots(), force_);
    fine_.sumSlots(state, force_);
    add<D>(loads_, -1.0, force_, fine_.numInner());
    add<D>(others_, 1.0, force_, fine_.numInner());
  }
  steady(state, first_ - 1, others_, mean_[first_ - 1]);
  add<D>(others_, -1.0, mean_[first_ - 1], slots);
  Kokkos::deep_copy(impulse_, 0.0);
  add<D>(impulse_, state.clock.dt, loads_, slots);
  fine_.startVelocity(state, velocity_);
  startWork_ = {};
  if (needsWork(state))
    addStartWork(state, loads_, state.motion.substeps.length);
  Kokkos::deep_copy(force_, 0.0);
  fine_.accelerate(state, 0, 1.0, loads_, force_);
  Kokkos::deep_copy(loads_, force_);
  Kokkos::deep_copy(waiting_, 0.0);
  add<D>(waiting_, state.clock.dt, others_, slots);
  waitingFrom_ = 0;
  atFirst_ = true;
  step(state, first_, 0.5 * state.clock.dt);
  step(state, first_, 0.5 * state.clock.dt);
  if (needsWork(state))
    recordWork(state);
  fine_.store(state, impulse_, 1.0 / state.clock.dt);
}

template <int D>
void LocalSteps<D>::addStartWork(const State<D>& state, const Values& force, double duration)
{
  const auto work = fine_.workOf(state, force);
  startWork_.free += duration * work.free;
  startWork_.held += duration * work.held;
}

// A support sets a node to its velocity at the start of the step and keeps it there, so that later impulses
// of other forces find the node at that velocity; the support's own energy balance, written at the ends of
// the step, use half the velocity before for them too where masses are coupled. The support supplies the
// opposite impulses.
template <int D>
void LocalSteps<D>::recordWork(State<D>& state)
{
  const auto all = fine_.workOf(state, impulse_);
  state.energy.externalWork -= all.held - startWork_.held;
  double late = all.free - startWork_.free;
  sumParts(state, &late, 1);
  state.motion.substeps.lateWork = late;
}

template <int D>
void LocalSteps<D>::finishOuterNodes()
{
  const Values others = others_, loads = loads_, all = force_;
  parallelForSmall<smallSlots>(
      "rhegma::subcycling::finishOuterNodes", fine_.numInner(), fine_.numSlots(), KOKKOS_LAMBDA(const int i) {
        for (int d = 0; d < D; ++d)
        {
          others(i, d) = all(i, d);
          loads(i, d) = 0.0;
        }
      });
}

template <int D>
void LocalSteps<D>::step(const State<D>& state, int level, double length)
{
  addImpulse(state, level, length);
  if (level == last_)
  {
    recordWorkOfDependentForces(state, 0.5 * length);
    kick(state);
    drift(length);
    recordWorkOfDependentForces(state, 0.5 * length);
    return;
  }
  step(state, level + 1, 0.5 * length);
  step(state, level + 1, 0.5 * length);
}

template <int D>
void LocalSteps<D>::addImpulse(const State<D>& state, int level, double length)
{
  const double particles = fine_.particlesFrom(level) - fine_.particlesFrom(level + 1);
  const bool dependsOnMotion = level == last_ && !state.motion.displacementDependentForces.empty(),
             first = atStart_[level];
  extraSteps_ += particles;
  atStart_[level] = false;
  if (particles == 0.0 && !dependsOnMotion)
    return;
  const Values force = first ? start_[level] : force_;
  if (!first)
  {
    fine_.force(state, level, displacement_, elapsed_, force);
    if (level == last_)
      for (const DisplacementDependentForce<D>& dependent : state.motion.displacementDependentForces)
        dependent.change(state, fine_.slots(), displacement_, velocity_, force);
    fine_.sumSlots(state, force);
    if (level < last_)
      add<D>(force, -1.0, mean_[level], fine_.numSlots());
  }
  add<D>(waiting_, length, force, fine_.numSlots());
  // Displacement-dependent forces may act on nodes of any class.
  waitingFrom_ = std::min(waitingFrom_, dependsOnMotion ? first_ : level);
}

template <int D>
void LocalSteps<D>::kick(const State<D>& state)
{
  fine_.accelerate(state, waitingFrom_, 1.0, waiting_, velocity_, atFirst_);
  if (atFirst_ && needsWork(state))
    addStartWork(state, waiting_, 1.0);
  atFirst_ = false;
  add<D>(impulse_, 1.0, waiting_, fine_.numSlots());
  Kokkos::deep_copy(waiting_, 0.0);
  waitingFrom_ = last_;
}

template <int D>
void LocalSteps<D>::drift(double length)
{
  elapsed_ += length;
  const Values velocity = velocity_, displacement = displacement_, rate = loads_;
  parallelForSmall<smallSlots>(
      "rhegma::subcycling::drift", 0, fine_.numSlots(), KOKKOS_LAMBDA(const int i) {
        for (int d = 0; d < D; ++d)
        {
          velocity(i, d) += length * rate(i, d);
          displacement(i, d) += length * velocity(i, d);
        }
      });
}

template <int D>
void LocalSteps<D>::recordWorkOfDependentForces(const State<D>& state, double duration) const
{
  for (const DisplacementDependentForce<D>& dependent : state.motion.displacementDependentForces)
    if (dependent.work)
      dependent.work(state, fine_.slots(), velocity_, duration);
}

template <int D>
void LocalSteps<D>::correctMotion(State<D>& state) const
{
  if (active_)
    fine_.correctMotion(state, displacement_, state.clock.dt, velocity_);
}

template <int D>
void LocalSteps<D>::correctProjection(State<D>& state) const
{
  if (active_)
    fine_.correctProjection(state, displacement_, state.clock.dt, velocity_);
}

template <int D>
void LocalSteps<D>::serialize(Archive& archive)
{
  archive("extra_steps", extraSteps_);
}

template class LocalSteps<2>;
template class LocalSteps<3>;

} // namespace Rhegma::sub_cycling
