#pragma once
/// Options of propagation.

#include "material/StartOfGrowth.hpp"
#include "plan/Effect.hpp"
#include "propagation/Direction.hpp"
#include "propagation/FrontHistory.hpp"
#include "propagation/ToughnessRatio.hpp"

#include <optional>

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
  double samplingCells = 0.0; ///< cells that a Rayleigh wave travels between two evaluations of G
  double waveSpeed = 0.0;     ///< of the fastest Rayleigh wave of all materials, set at the start [m/s]
  bool equilibrium = false;   ///< fronts advance in equilibrium instead of in time
  bool endsAtStops = true;    ///< the run ends where a front node stops for a numerical reason
  std::optional<ToughnessRatio> ratio{}; ///< if the toughness depends on the direction of growth
  double criticalIntensity = 0.0; ///< K_Ic that Toughness is from [Pa m^0.5]; 0: the scene does not give it
};

Section propagationSection();
void checkPropagation(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors);

/// \param scene validated
Options readOptions(const Teuchos::ParameterList& scene, const RunOptions& run);

/// Declares to other effects that cracks may grow, and the contours.
void declareGrowth(const Teuchos::ParameterList& list, RunOptions& run);

/// Speed that no front exceeds at a position [m/s].
template <int D>
double speedLimitAt(const State<D>& state, const Vector<D>& position, const Options& options);

/// Speed of the fastest Rayleigh wave of all materials [m/s].
template <int D>
double fastestRayleighWave(const State<D>& state);

/// The rule at a front, whose toughness depends on its temperature [K].
AdvanceRule ruleAt(double temperature, const Options& options);

/// Whether the toughness of a rule is not positive.
bool isWeak(const AdvanceRule& rule, double fastest);
std::string failureOfWeak(double temperature);

/// Refuses a toughness that is not positive at the start, up to the largest speed of the scene.
/// \throws std::invalid_argument, with the parameter's path
template <int D>
void refuseWeak(const State<D>& state, const Options& options);

/// The energy release rate without closing mode I: under compression a crack does not open, though J is
/// positive. The rate is J times the fraction of sliding, K_II^2/E' + K_III^2/(2 mu), in the sum of all modes
/// (Irwin). \param modes of the material at the front
double openingRelease(const DrivingForce& driving, const ModeRelease& modes);

/// Refuses what the rule of growth can't do in bodies whose stiffness depends on direction: turns, which need
/// the anisotropic hoop stress, and in time a front without Speed Limit, as the speed of Rayleigh waves
/// depends on direction. \throws std::invalid_argument, with the parameter's path
template <int D>
void refuseAnisotropic(const State<D>& state, const Options& options);

} // namespace Rhegma::propagation
