#pragma once
/// The text of a scene's file.

#include "scene/SceneError.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

/// Whether a file is a pipe, such as that of a shell's process substitution <(...). It can be read once, and
/// reading it waits for the program that writes into it.
bool isPipe(const std::string& file);

/// The text of a file or a pipe; adds an error, and returns nothing, if there is no readable text. A device,
/// and a pipe into which no program writes, is refused, since its end might never come.
std::string readText(const std::string& file, std::vector<SceneError>& errors);

} // namespace Rhegma
