#pragma once
/// How often a run samples and writes fields.

#include <Teuchos_ParameterList.hpp>

namespace Rhegma::program
{

/// Time between two rows of history.csv [s]. \param scene validated
inline double historyInterval(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& output = scene.sublist("Output");
  return output.isParameter("History Interval") ? output.get<double>("History Interval")
                                                : scene.sublist("Time").get<double>("Final Time") / 200.0;
}

/// Time between two snapshots [s]. \param scene validated
inline double fieldInterval(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& output = scene.sublist("Output");
  return output.isParameter("Field Interval") ? output.get<double>("Field Interval")
                                              : scene.sublist("Time").get<double>("Final Time");
}

} // namespace Rhegma::program
