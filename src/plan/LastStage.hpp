#pragma once
/// Where a step ends, and from where on its motion is known.

#include "plan/Effect.hpp"

#include <Teuchos_ParameterList.hpp>

namespace Rhegma
{

/// The last stage of a step but for samples: what the step has done to nodes and particles is still there in
/// it. Between two steps that is not sure, as a run may go on from a checkpoint or with other cells. What
/// reads "particle stress", "particle velocity" and "crack geometry" comes last in it.
inline Stage lastStage(const Teuchos::ParameterList& scene)
{
  const char* const name = "Update Scheme";
  const Teuchos::ParameterList& time = scene.sublist("Time");
  const bool stressFirst = time.isType<std::string>(name) && time.get<std::string>(name) == "USF";
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

/// The stage in which it is known.
inline Stage stageOfFaceVelocity(const Teuchos::ParameterList& scene)
{
  return projectsLast(scene) ? Stage::AfterProjection : Stage::Gather;
}

} // namespace Rhegma
