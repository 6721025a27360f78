#pragma once
/// Judgments of a scene by its own numbers: what would run, and mislead (docs/reference/warnings.md).

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
  double step;                     ///< first stable step [s]; not a number where it is not known
  bool driven = false; ///< effects may load or move bodies as well: heat, pressure, those of an application
};

/// Messages with path and number, one for each doubt.
using Messages = std::vector<std::string>;

/// Numbers that no quantity has: of the whole scene.
Messages judgeNumbers(const Teuchos::ParameterList& scene);
/// Densities, thickness of a plane scene, and materials that make cells lock.
template <int D>
Messages judgeQuantities(const JudgedScene<D>& judged);
/// Fewer than one step or more than 1e8; waves that do not cross a body; weight above all loads.
template <int D>
Messages judgeTimes(const JudgedScene<D>& judged);
/// Bodies, holes and added parts thinner than two cells, walls and gaps that they leave together
/// (JudgeWalls.hpp); cuts that meet no material. \param state has its cells; particles are not looked at
template <int D>
Messages judgeThickness(const Teuchos::ParameterList& scene, const State<D>& state);
/// What was mended in the files of bodies, and files that seem to be in millimetres.
template <int D>
Messages judgeFiles(const Teuchos::ParameterList& scene);
/// Bodies that share nodes, and bonded ones that do not.
template <int D>
Messages judgeNeighbours(const JudgedScene<D>& judged);
/// Bodies that meet in the course of the run.
template <int D>
Messages judgeMeetings(const JudgedScene<D>& judged);
/// Bodies that their operations leave in pieces, one of which no support holds, or that share nodes.
template <int D>
Messages judgePieces(const JudgedScene<D>& judged);
/// Strains that no solid or no linear law withstands, and loads that are zero.
template <int D>
Messages judgeLoads(const JudgedScene<D>& judged);
/// Loads on the same points whose forces cancel.
template <int D>
Messages judgeCancelling(const JudgedScene<D>& judged);
/// A scene in which nothing moves; gravity in other units.
template <int D>
Messages judgeMotion(const JudgedScene<D>& judged);
/// Planes of symmetry with material on the side of the mirror image.
template <int D>
Messages judgeMirrors(const JudgedScene<D>& judged);
/// Loads on bodies that a support holds everywhere.
template <int D>
Messages judgeHeld(const JudgedScene<D>& judged);
/// Supports of which no node lies on the face that they hold.
template <int D>
Messages judgeGrips(const JudgedScene<D>& judged);
/// Supports that are faster than waves, and forces that a cell cannot bear.
template <int D>
Messages judgeFirstSteps(const JudgedScene<D>& judged);
/// Supports that hold both faces of a crack.
template <int D>
Messages judgeShutCracks(const JudgedScene<D>& judged);
/// Bodies that cracks cut in pieces at the start of a dynamic run, one of which no support holds.
template <int D>
Messages judgeSevered(const JudgedScene<D>& judged);
/// Supports that move both ends of a body alike, and values along axes that a support leaves free.
template <int D>
Messages judgeCarried(const JudgedScene<D>& judged);
/// Bores of bodies of revolution that are so narrow that nodes at the axis hold their walls.
template <int D>
Messages judgeBores(const JudgedScene<D>& judged);
/// Damping by PIC that takes a tenth of the energy of waves.
template <int D>
Messages judgePic(const JudgedScene<D>& judged);
/// Bodies that fly away under a load that nothing balances.
template <int D>
Messages judgeFlight(const JudgedScene<D>& judged);

/// Adds what all judges of the core say to the warnings of the state, at most ten messages of each. Effects
/// add their own (plan/Effect.hpp). Call it before particles are divided among ranks.
/// \param step first stable step [s]; not a number where it is not known \param driven as in JudgedScene
/// \param pressures on faces of cracks, by their paths (RunOptions)
template <int D>
void judgeScene(const Teuchos::ParameterList& scene, double step, bool driven,
                const std::map<std::string, std::string>& pressures, State<D>& state);

/// The part of it that needs no particles, for a scene whose bodies can't be placed.
template <int D>
void judgeWithoutParticles(const Teuchos::ParameterList& scene, State<D>& state);

/// The first ten messages and how many more there are.
Messages firstTen(Messages messages);

/// The messages without those that would print what is not a finite number: of each the place is said, once,
/// and that its numbers are implausible, unless another message of that place does.
Messages withoutNonNumbers(const Messages& messages);

} // namespace Rhegma
