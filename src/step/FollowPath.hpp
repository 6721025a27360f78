#pragma once
/// Steps of equilibrium in which cracks grow.

#include "equilibrium/EquilibriumCore.hpp"
#include "state/State.hpp"

#include <functional>

namespace Rhegma
{

/// What the loop does for a step of equilibrium.
struct EquilibriumCalls
{
  std::function<void()>
      between; ///< the stage BetweenSteps: fronts advance if EquilibriumGrowth::advance is set
  std::function<void()> solve;  ///< the stages up to Solve
  std::function<void()> accept; ///< the stages from AfterSolve on: the particles follow
  /// Restores equilibrium where the particles lie now, without new loads. \return whether it had to: the
  /// motion of the last solution left more out of balance than G notices
  std::function<bool()> settle;
};

/// Advances the cracks by an increment, except in the first step, and finds the factor of the loads with
/// which the largest G is its toughness. The factor is an unknown, so that it and the displacement of the
/// loads may fall. Leaves Clock::dt at `length`, and the state in EquilibriumGrowth::path; where no front is
/// left that can advance, nothing is solved. Sets State::failure where no factor is found.
///
/// Work of the loads is that of the mean of their values before and after: the increment and the change of
/// the factor, which is extrapolated from those before, are one step, and what is left of the factor is found
/// at rest. \param last of the solves \param length of the step in time, which only counts steps [s]
template <int D>
void followLoadFactor(State<D>& state, const EquilibriumCalls& calls, const equilibrium::LastStep& last,
                      double length);

/// Where the next load step ends, so that it does not pass the start of growth by much: energy that is
/// released above the toughness is missing from the balance, as it would become motion. The root of G/Gc is
/// taken to go on as in the last step (EquilibriumGrowth::rate), as it does where loads are linear in time.
/// \param until end of the step without growth [s] \param largest length of a load step [s]
template <int D>
double endBeforeGrowth(const State<D>& state, double until, double largest);

/// Advances the cracks under the loads of the time until no front's G is above its toughness, each time by an
/// increment. Where motion follows unstable growth (Method::handsOver), ends with EquilibriumGrowth::unstable
/// set once it is found: the state is then of no use. \param last of the solves \param from begin of the load
/// step [s] \param driveBefore G/Gc there
template <int D>
void growAtFixedLoads(State<D>& state, const EquilibriumCalls& calls, const equilibrium::LastStep& last,
                      double from, double driveBefore);

} // namespace Rhegma
