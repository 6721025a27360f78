#pragma once
/// Report of the path of equilibrium of growing cracks.

#include "state/EquilibriumGrowth.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::propagation
{

/// What a path of equilibrium says, by indices of its states; -1: there is none.
struct PathEvents
{
  int largest = -1; ///< of the largest factor
  /// From it on the factor falls while the crack grows: under the loads of this state the crack runs.
  int falls = -1;
  int again = -1;     ///< after it the first that needs as large a factor: there it would arrest
  int snapsBack = -1; ///< from it on the displacement of the loads falls, too
};

/// The events of a path whose loads have a factor.
PathEvents eventsOf(const std::vector<PathState>& path);

/// Load at which the largest hoop stress makes a front start and turn, over that at which G of a straight
/// extension reaches the toughness (Erdogan and Sih, J. Basic Eng. 85 (1963) 519). \param turn angle by which
/// it turns, of either sign, at most that of shear alone, 70.5 degrees [rad]
double hoopStressLoad(double turn);

/// What shear does to the load at which a front starts, such as "it turned by 41 degrees as it started, for which
/// the largest hoop stress needs about 0.87 of the load"; empty below half a per cent, and where directions are
/// not those of the largest hoop stress. \param front its entry in the summary, with `first_turn` and
/// `hoop_stress_load`
std::string effectOfShear(const nlohmann::json& front);

/// Adds to `propagation` of the summary, and to the answers, at which load cracks start, which is the
/// largest, and where growth is unstable; where a front turned as it started, also the lower load at which
/// the largest hoop stress makes it start. \param hasFactor whether the loads have a factor
/// \param summary with `first_turn` of fronts
void reportPathOfEquilibrium(const std::vector<PathState>& path, bool hasFactor, nlohmann::json& summary);

/// Saves or loads the path.
void storeGrowth(EquilibriumGrowth& growth, Archive& archive);

} // namespace Rhegma::propagation
