#pragma once
/// The folder in which a run leaves its files.

#include <string>

namespace Rhegma
{

/// The scene's path with .out in place of .xml.
std::string defaultOutputFolder(const std::string& scene);

/// Makes the folder, and those above it, unless it is there, and tries whether files can be written in it.
/// Nothing in it is changed. \return the folder
/// Throws std::invalid_argument with one sentence when it can't be made or written.
std::string makeOutputFolder(const std::string& folder);

/// Removes the summary of a run that goes on, and files that a kill left half written.
void removeOldSummary(const std::string& folder);

/// Removes what an older run left in the folder, so that a run that is killed leaves no file of another.
void removeOldResults(const std::string& folder);

} // namespace Rhegma
