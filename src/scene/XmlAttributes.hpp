#pragma once
/// Attributes of the tags of a scene.

#include "scene/SceneError.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

/// Adds an error for every attribute that <ParameterList> and <Parameter> do not have, and for every one that
/// a tag has twice: Teuchos leaves out the one and keeps the last of the other.
/// \param xml well-formed
void checkAttributes(const std::string& xml, std::vector<SceneError>& errors);

/// Position of the end of the tag that begins at `from`: its `>` outside of quotes, or the end of the text.
std::size_t endOfTag(const std::string& xml, std::size_t from);

} // namespace Rhegma
