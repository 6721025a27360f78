#pragma once
/// The last stage of a step, and the stage from which the motion of faces is known.

#include "plan/Effect.hpp"

#include <Teuchos_ParameterList.hpp>

namespace Rhegma
{

/// Whether the scene asks for equilibrium instead of motion.
inline bool isEquilibrium(const Teuchos::ParameterList& scene)
{
  const char* const name = "Analysis";
  const Teuchos::ParameterList& time = scene.sublist("Time");
  return time.isType<std::string>(name) && time.get<std::string>(name) != "Dynamic";
}

/// Whether the motion of a scene of equilibrium follows unstable growth of its cracks; also in that motion.
inline bool handsOver(const Teuchos::ParameterList& scene)
{
  const char* const name = "Unstable Growth";
  const Teuchos::ParameterList& time = scene.sublist("Time");
  return time.isType<std::string>(name) && time.get<std::string>(name) == "Dynamic";
}

/// The last stage of a step except for samples. The nodal and particle values of the step are still available
/// in it, but not always between two steps, as a run may continue from a checkpoint or with other cells.
/// Calls that read "particle stress", "particle velocity" and "crack geometry" run last in it.
inline Stage lastStage(const Teuchos::ParameterList& scene)
{
  const char* const name = "Update Scheme";
  const Teuchos::ParameterList& time = scene.sublist("Time");
  const bool stressFirst =
      !isEquilibrium(scene) && time.isType<std::string>(name) && time.get<std::string>(name) == "USF";
  return stressFirst ? Stage::Gather : Stage::OnParticles;
}

/// Whether the velocity that moves particles and faces is known only after the gather (MUSL, USAVG).
inline bool projectsLast(const Teuchos::ParameterList& scene)
{
  const char* const name = "Update Scheme";
  const Teuchos::ParameterList& time = scene.sublist("Time");
  return !time.isType<std::string>(name) || time.get<std::string>(name) == "MUSL" ||
         time.get<std::string>(name) == "USAVG";
}

/// The stage in which that velocity is known.
inline Stage stageOfFaceVelocity(const Teuchos::ParameterList& scene)
{
  return projectsLast(scene) ? Stage::AfterProjection : Stage::Gather;
}

} // namespace Rhegma
