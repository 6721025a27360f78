#pragma once
/// Steps of conduction that are tried again with a shorter time.

#include "thermal/Conduction.hpp"

namespace Rhegma::thermal
{

/// What a step of conduction changes, as it was before the step. A load step of equilibrium that does not
/// converge is tried again with a part of its length, and conducts for that part only. Steps at one time that
/// follow an accepted solution (growth, forces that a motion left out of balance) start from it.
template <int D>
class RepeatedStep
{
public:
  /// Before a step of conduction: keeps the state, or takes it back if the last solution was not accepted.
  void begin(State<D>& state, Conduction<D>& conduction)
  {
    FieldTable& particles = state.particles;
    if (isTried(state))
    {
      Kokkos::deep_copy(particles.scalar(fields::temperature), temperature_);
      Kokkos::deep_copy(particles.scalar(fields::internalEnergy), internal_);
      Kokkos::deep_copy(particles.template real<D>(fields::temperatureGradient), gradient_);
      Kokkos::deep_copy(particles.template real<gradientSize<D>>(fields::deformation), deformation_);
      state.energy.heat = heat_;
      conduction.stepsTaken = stepsTaken_;
      conduction.pending = pending_;
      conduction.frontTemperature = frontTemperature_;
      conduction.fractureSeen = fractureSeen_;
      conduction.frontHeat = frontHeat_;
      return;
    }
    kept_ = true;
    time_ = state.clock.time;
    step_ = state.clock.step;
    temperature_ = View<double*>("rhegma::thermal::keptTemperature", particles.size());
    internal_ = View<double*>("rhegma::thermal::keptEnergy", particles.size());
    gradient_ = View<double* [D]>("rhegma::thermal::keptGradient", particles.size());
    deformation_ = View<double * [gradientSize<D>]>("rhegma::thermal::keptDeformation", particles.size());
    Kokkos::deep_copy(temperature_, particles.scalar(fields::temperature));
    Kokkos::deep_copy(internal_, particles.scalar(fields::internalEnergy));
    Kokkos::deep_copy(gradient_, particles.template real<D>(fields::temperatureGradient));
    Kokkos::deep_copy(deformation_, particles.template real<gradientSize<D>>(fields::deformation));
    heat_ = state.energy.heat;
    stepsTaken_ = conduction.stepsTaken;
    pending_ = conduction.pending;
    frontTemperature_ = conduction.frontTemperature;
    fractureSeen_ = conduction.fractureSeen;
    frontHeat_ = conduction.frontHeat;
  }

  /// After particles have taken the displacements of the solution.
  void accept() { kept_ = false; }

private:
  /// Whether the kept state is that before this step.
  bool isTried(const State<D>& state) const
  {
    return kept_ && time_ == state.clock.time && step_ == state.clock.step &&
           static_cast<int>(temperature_.extent(0)) == state.particles.size();
  }

  bool kept_ = false; ///< by a step whose solution is not accepted yet
  double time_ = 0.0, heat_ = 0.0, pending_ = 0.0, fractureSeen_ = 0.0;
  long step_ = 0, stepsTaken_ = 0;
  View<double*> temperature_, internal_;
  View<double* [D]> gradient_;
  View<double * [gradientSize<D>]> deformation_;
  std::vector<double> frontTemperature_, frontHeat_;
};

} // namespace Rhegma::thermal
