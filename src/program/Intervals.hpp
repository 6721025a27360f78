#pragma once
/// How often a run samples and writes fields and checkpoints.

#include <Teuchos_ParameterList.hpp>

#include <string>

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

/// Whether the values along fronts are written at the times of the fields, or of rows of the history.
/// \param scene validated \param times "With Fields" or "With History"
inline bool writesFronts(const Teuchos::ParameterList& scene, const char* times)
{
  const Teuchos::ParameterList& output = scene.sublist("Output");
  return output.isParameter("Front Values") && output.get<std::string>("Front Values") == times;
}

/// Time between two checkpoints [s]; 0: none by simulated time. \param scene validated
inline double checkpointInterval(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& output = scene.sublist("Output");
  return output.isParameter("Checkpoint Interval") ? output.get<double>("Checkpoint Interval") : 0.0;
}

/// Time by the clock between two checkpoints [min]; 0: none by the clock. \param scene validated
inline double checkpointMinutes(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& output = scene.sublist("Output");
  return output.isParameter("Checkpoint Minutes") ? output.get<double>("Checkpoint Minutes") : 0.0;
}

/// Whether a run writes checkpoints though nothing stops it. \param scene validated
inline bool writesCheckpoints(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& output = scene.sublist("Output");
  return output.isParameter("Checkpoints") && output.get<bool>("Checkpoints") &&
         (checkpointInterval(scene) > 0.0 || checkpointMinutes(scene) > 0.0);
}

} // namespace Rhegma::program
