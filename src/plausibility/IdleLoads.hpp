#pragma once
/// Loads of zero, and those whose function of time is in other units of time than the run.

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

/// Messages on a load one of whose values is zero, or whose `History` stays below 1e-3 up to the end.
/// \param list its parameters \param values names of those that are its size \param end of the run [s]
std::vector<std::string> idleMessages(const GivenLoad& load, const Teuchos::ParameterList& list,
                                      const std::vector<std::string>& values, double end);

/// The same of a load whose size is itself a function of time: zero up to the end, or below 1e-3 of what it
/// reaches later. \param parameter its name \param function its text \param unit of its value
std::vector<std::string> idleMessages(const GivenLoad& load, const std::string& parameter,
                                      const std::string& function, const std::string& unit, double end);

/// Largest absolute value of a function of time that has an upper bound, at any time up to 1e9 times `end`;
/// zero where it still rises there: then nothing is known of its time.
double largestEver(const std::string& function, double end);

} // namespace Rhegma
