#pragma once
/// Where a step ends.

#include "step/Effect.hpp"

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

} // namespace Rhegma
