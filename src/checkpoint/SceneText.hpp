#pragma once
/// What a checkpoint knows of its scene.

#include "scene/Schema.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

/// A scene with its defaults, a line a parameter (`Materials > Steel > Density = 7800`), without those that
/// may be different when a run goes on (Parameter::changeable, Section::changeable). Numbers have all their
/// digits. Parameters are in the order of their names, sections as they come, the top ones in the order of
/// the schema: the order of bodies, materials and cracks is their numbering.
std::vector<std::string> sceneLines(const Teuchos::ParameterList& scene, const SceneSchema& schema);

/// \return the first difference in words; empty if there is none
std::string differenceOfScenes(const std::vector<std::string>& now, const std::vector<std::string>& then);

/// CRC-32 of the lines.
long hashOfScene(const std::vector<std::string>& lines);

} // namespace Rhegma
