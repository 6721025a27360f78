#pragma once
/// What a scene says of cracks that run.

#include "material/MaterialTable.hpp"
#include "plan/Effect.hpp"
#include "propagation/Direction.hpp"
#include "propagation/FrontHistory.hpp"

#include <string>
#include <vector>

namespace Rhegma::propagation
{

struct Options
{
  AdvanceRule rule;
  DirectionRule direction;
  double cells;       ///< an increment has [cells]
  double speedLimit;  ///< [m/s]; 0: that of Rayleigh waves
  double temperature; ///< at the start [K]
  DrivingContours contours;
};

Section propagationSection();
void checkPropagation(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors);

/// \param scene validated
Options readOptions(const Teuchos::ParameterList& scene, const RunOptions& run);

/// Has the other effects know that cracks may grow, and of the contours.
void declareGrowth(const Teuchos::ParameterList& list, RunOptions& run);

/// Speed that no front exceeds at a position [m/s].
template <int D>
double speedLimitAt(const State<D>& state, const Vector<D>& position, const Options& options);

/// The rule at a front, whose toughness depends on how warm it is [K].
AdvanceRule ruleAt(double temperature, const Options& options);

/// Whether the toughness of a rule is not positive, and what to say of it.
bool isWeak(const AdvanceRule& rule, double fastest);
std::string failureOfWeak(double temperature);

/// Refuses a toughness that is not positive at the start, up to the largest speed of the scene.
/// \throws std::invalid_argument, with the parameter's path
template <int D>
void refuseWeak(const State<D>& state, const Options& options);

/// The energy release rate without what closes the crack: a front that is pressed together does not break,
/// though J is positive. Its fraction of J is that of sliding, K_II^2/E' + K_III^2/(2 mu), in what the
/// intensities release (Irwin), K_I^2/E' being what closes. \param e of the material at the front
double openingRelease(const DrivingForce& driving, const Elasticity& e);

} // namespace Rhegma::propagation
