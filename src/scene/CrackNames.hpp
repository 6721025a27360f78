#pragma once
/// Sections whose sublists have the names of cracks.

#include "scene/SceneError.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma
{

/// Names one after the other: "A, B".
std::string joined(const std::vector<std::string>& names);

/// Complains of a scene without cracks, and of names that no crack has. \param section of the scene, which
/// must be there \param could what it would do with faces: "there are no crack faces that `could`"
/// \return false where the scene has no section Cracks
bool checkCrackNames(const Teuchos::ParameterList& scene, const std::string& section,
                     const std::string& could, std::vector<SceneError>& errors);

} // namespace Rhegma
