#pragma once
/// Loads of zero, and those whose function of time is in other units of time than the run.

#include "plausibility/HistoryRange.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma
{

/// A load of a scene, of the boundaries or of an effect.
struct GivenLoad
{
  std::string where; ///< its path in the scene
  std::string noun;  ///< what it is, for the message: "boundary"
};

/// Messages on a load one of whose values is zero, or whose `History` stays below 1e-3 up to the end; or, in
/// equilibrium, is at the times that count below half of what it reaches between them (1e-3 where the loads
/// have a factor); or, in a static analysis, depends on time and is below a half at Final Time. \param list
/// its parameters \param values names of those that are its size
std::vector<std::string> idleMessages(const GivenLoad& load, const Teuchos::ParameterList& list,
                                      const std::vector<std::string>& values, const ActingTimes& times);

/// The same of a load whose size is itself a function of time: zero up to the end, or below 1e-3 of what it
/// reaches later. \param parameter its name \param function its text \param unit of its value
std::vector<std::string> idleMessages(const GivenLoad& load, const std::string& parameter,
                                      const std::string& function, const std::string& unit,
                                      const ActingTimes& times);

/// The message in equilibrium on a support that comes back: whose displacement, at the times that count, is
/// below the same fractions of what it is between them; none in dynamics. \param history of its velocity
std::vector<std::string> idleSupportMessages(const GivenLoad& support, const std::string& history,
                                             const ActingTimes& times);

/// Largest absolute value of a function of time that has an upper bound, at any time up to 1e9 times `end`;
/// zero where it still rises there: then nothing is known of its time.
double largestEver(const std::string& function, double end);

} // namespace Rhegma
