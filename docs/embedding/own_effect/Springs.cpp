/// An effect of an application's own: bodies on a bed of springs. See ../own_effect.md.

#include "Springs.hpp"

#include <algorithm>
#include <cmath>

using namespace Rhegma;

namespace
{

/// One kernel for 2D and 3D: springs pull every particle back to where it was, for one step.
/// \return the work that they do [J]
template <int D>
double pullBack(State<D>& state, double stiffness)
{
  const auto position = state.particles.template real<D>(fields::position);
  const auto reference = state.particles.template real<D>(fields::reference);
  const auto velocity = state.particles.template real<D>(fields::velocity);
  const auto mass = state.particles.scalar(fields::mass), volume = state.particles.scalar(fields::volume);
  const double push = -state.clock.dt * stiffness;
  double work = 0.0;
  Kokkos::parallel_reduce(
      "springs::pullBack", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& sum) {
        for (int d = 0; d < D; ++d)
        {
          const double impulse = push * volume(p) * (position(p, d) - reference(p, d));
          sum += impulse * (velocity(p, d) + 0.5 * impulse / mass(p));
          velocity(p, d) += impulse / mass(p);
        }
      },
      work);
  return work;
}

template <int D>
Effect<D> makeSprings(const Teuchos::ParameterList& scene)
{
  const double stiffness = scene.sublist("Springs").get<double>("Stiffness");
  Effect<D> effect;
  effect.name = "Springs";
  effect.call({Stage::Scatter, "springs", {}, {"particle velocity"}, {}, [=](State<D>& state) {
                 state.energy.externalWork += pullBack(state, stiffness);
               }});
  effect.timeStepLimit = [=](const State<D>& state) // a tenth of a radian of the lightest body's swing
  {
    double lightest = state.materials.list.front().density;
    for (const Properties& material : state.materials.list)
      lightest = std::min(lightest, material.density);
    return 0.1 * std::sqrt(lightest / stiffness);
  };
  return effect;
}

} // namespace

EffectEntry springs()
{
  Section section("Springs", "A bed of springs that pulls all material back to where it was at the start.");
  section.real("Stiffness").unit("N/m4").positive().meaning("Force per displacement and undeformed volume.");
  EffectEntry entry{section, {}, makeSprings<2>, makeSprings<3>};
  entry.onRanks = true;
  return entry;
}
