#include "sub_cycling/LocalSteps.hpp"

namespace Rhegma::sub_cycling
{

template <int D>
void LocalSteps<D>::makeRoom(int levels, int nodes)
{
  const auto fit = [&](std::vector<Values>& all)
  {
    all.resize(levels);
    for (Values& values : all)
      if (static_cast<int>(values.extent(0)) < nodes)
        values = Values("rhegma::subcycling::values", nodes + nodes / 4);
  };
  fit(changed_);
  fit(mean_);
  if (static_cast<int>(displacement_.extent(0)) < nodes)
    displacement_ = Values("rhegma::subcycling::displacement", nodes + nodes / 4);
}

template <int D>
void LocalSteps<D>::act(State<D>& state, int first, int last)
{
  if (last < first || !state.tree.refined())
    return;
  fine_.update(state, first);
  if (fine_.numParticles() == 0)
    return;
  makeRoom(last + 2, fine_.numSlots());
  const Values force = mean_[last + 1]; // no level has this one
  fine_.load(state, force);
  fine_.store(state, evolve(state, first, last, state.dt, force));
}

template <int D>
typename LocalSteps<D>::Values LocalSteps<D>::evolve(const State<D>& state, int level, int last,
                                                     double length, const Values& from)
{
  if (level > last)
    return from;
  const double half = 0.5 * length;
  const Values before = evolve(state, level + 1, last, half, from);
  const Values changed = changed_[level], mean = mean_[level];
  const int slots = fine_.numSlots();
  fine_.displace(state, level, 0.5 * (1.0 + damping_) * half * half, before, displacement_);
  fine_.relax(state, level, displacement_, from, changed);
  extraSteps_ += fine_.particlesOf(level);
  // The second half overwrites what the levels below hold of the first.
  if (before.data() != from.data())
    Kokkos::parallel_for(
        "rhegma::subcycling::keep", Kokkos::RangePolicy<ExecSpace>(0, slots), KOKKOS_LAMBDA(const int i) {
          for (int d = 0; d < D; ++d)
            mean(i, d) = before(i, d);
        });
  const Values kept = before.data() != from.data() ? mean : from;
  const Values after = evolve(state, level + 1, last, half, changed);
  Kokkos::parallel_for(
      "rhegma::subcycling::mean", Kokkos::RangePolicy<ExecSpace>(0, slots), KOKKOS_LAMBDA(const int i) {
        for (int d = 0; d < D; ++d)
          mean(i, d) = 0.5 * (kept(i, d) + after(i, d));
      });
  return mean;
}

template class LocalSteps<2>;
template class LocalSteps<3>;

} // namespace Rhegma::sub_cycling
