#pragma once
/// Report of the path of equilibrium of growing cracks.

#include "state/EquilibriumGrowth.hpp"

#include <nlohmann/json.hpp>

#include <optional>
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

/// Adds to `propagation` of the summary, and to the answers, at which load cracks start, which is the
/// largest, and where growth is unstable; where a front is under shear, also the lower load at which the
/// largest hoop stress makes it start. \param hasFactor whether the loads have a factor
/// \param summary with the entries of fronts \param motionFrom where the scene lets motion follow unstable
/// growth, the time from which the run is one of motion [s]; negative: it is not yet
void reportPathOfEquilibrium(const std::vector<PathState>& path, bool hasFactor, nlohmann::json& summary,
                             const std::optional<double>& motionFrom = {});

/// Saves or loads the path.
void storeGrowth(EquilibriumGrowth& growth, Archive& archive);

} // namespace Rhegma::propagation
