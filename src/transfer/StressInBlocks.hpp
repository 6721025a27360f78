#pragma once
/// Laws that compute the stress of many particles at once: they are called after the pass that strains the
/// particles, on the host, for blocks of particles.

#include "state/State.hpp"

namespace Rhegma
{

/// Whether a material of the run has such a law.
template <int D>
bool hasLawInBlocks(const State<D>& state);

/// Deformation gradients before a pass. \return empty where no law needs them
template <int D>
View<double * [gradientSize<D>]> deformationBefore(const State<D>& state);

/// Stress, energy and history of all particles of such laws. If a law fails, state.failure says so, and at
/// which particle and time. \param before the pass \param duration of its strain [s]
/// \return largest speed of waves, of particles and waves if cells are not those of the undeformed body [m/s]
template <int D>
double stressInBlocks(State<D>& state, const View<double * [gradientSize<D>]>& before, double duration);

/// Gives such laws the time at the end of the present step.
template <int D>
void setTimeOfLaws(State<D>& state);

} // namespace Rhegma
