#pragma once
/// Time and step of a run.

#include <limits>

namespace Rhegma
{

/// One of the passes in which a step strains its particles: USAVG has two, other schemes one.
struct StrainPass
{
  double fraction = 1.0; ///< fraction of the step that the pass strains over
  bool before = false;   ///< whether it comes before the forces of the step
};

/// The factor of the loads over a step of equilibrium whose loads are no functions of time.
struct LoadFactor
{
  double begin = 0.0; ///< at the start of the step
  double end = 0.0;   ///< at its end
};

/// Time, step and how the run ends.
struct Clock
{
  double time = 0.0;                                         ///< at the start of the step [s]
  double dt = 0.0;                                           ///< length of the step [s]
  double finalTime = 0.0;                                    ///< of the scene [s]
  double lastTime = std::numeric_limits<double>::infinity(); ///< at which a run ends before that [s]
  long step = 0;                                             ///< steps taken
  long maximumSteps = std::numeric_limits<long>::max();      ///< the run ends after them, if not before
  double stepOfMotion = 0.0;    ///< of the motion that starts in this equilibrium [s]; 0: none does
  double fastestSpeed = 0.0;    ///< largest wave speed plus particle speed [m/s]
  LoadFactor factor;            ///< where the analysis has one (Analysis::LoadFactor)
  StrainPass strainPass;        ///< the current pass, or the next
  bool observing = false;       ///< a sample is taken at the end of this step
  bool settled = false;         ///< the bodies are at rest
  bool stopWhenSettled = false; ///< the scene ends the run once they are

  /// Whether the run ends here, before its final time.
  bool ended() const { return (settled && stopWhenSettled) || step >= maximumSteps || time >= lastTime; }
};

} // namespace Rhegma
