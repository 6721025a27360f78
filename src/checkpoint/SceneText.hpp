#pragma once
/// The scene of a checkpoint as text.

#include "scene/Schema.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

/// A scene with its defaults, a line a parameter (`Materials > Steel > Density = 7800`), without those that
/// may change when a run continues (Parameter::changeable, Section::changeable; KeptParameter are at the
/// end). Numbers have all their digits. Parameters are in the order of their names, sections in the order of
/// the scene, the top ones in the order of the schema: the order of bodies, materials and cracks is their
/// numbering.
std::vector<std::string> sceneLines(const Teuchos::ParameterList& scene, const SceneSchema& schema);

/// \return the first difference as text; empty if there is none
std::string differenceOfScenes(const std::vector<std::string>& now, const std::vector<std::string>& then);

/// Why a parameter that may differ in other scenes may not in this one, and what to do, as in a message after
/// the difference; empty if it may not differ in any. \param difference by differenceOfScenes
std::string reasonOfDifference(const std::string& difference, const Teuchos::ParameterList& scene,
                               const SceneSchema& schema);

/// CRC-32 of the lines.
long hashOfScene(const std::vector<std::string>& lines);

} // namespace Rhegma
