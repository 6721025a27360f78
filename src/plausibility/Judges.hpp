#pragma once
/// Judgments of a scene by its own numbers: what would run, and mislead (docs/plausibility.md).

#include "plausibility/LoadEstimate.hpp"

namespace Rhegma
{

/// What judges look at, before the first step.
template <int D>
struct JudgedScene
{
  const Teuchos::ParameterList& scene; ///< validated; only sections of the core are read
  const State<D>& state;
  std::vector<BodyMeasure<D>> bodies;
  std::vector<LoadEstimate> loads; ///< none without mechanics
  double step;                     ///< first stable step [s]
};

/// Messages with path and number, one for each doubt.
using Messages = std::vector<std::string>;

/// Numbers that no quantity has: of the whole scene, of densities, thickness and speeds.
template <int D>
Messages judgeNumbers(const JudgedScene<D>& judged);
/// Fewer than one step or more than 1e8; waves that do not cross a body; weight above all loads.
template <int D>
Messages judgeTimes(const JudgedScene<D>& judged);
/// Bodies, holes and added parts thinner than two cells; cuts that meet no material.
template <int D>
Messages judgeThickness(const JudgedScene<D>& judged);
/// Bodies that share nodes.
template <int D>
Messages judgeNeighbours(const JudgedScene<D>& judged);
/// Strains that no solid or no linear law withstands, and loads that are zero.
template <int D>
Messages judgeLoads(const JudgedScene<D>& judged);

/// Adds what all judges of the core say to the warnings of the state, at most ten messages of each. Effects
/// add their own where they start. Call it before particles are divided among ranks.
/// \param step first stable step [s]
template <int D>
void judgeScene(const Teuchos::ParameterList& scene, double step, State<D>& state);

/// The first ten messages and how many more there are.
Messages firstTen(Messages messages);

} // namespace Rhegma
