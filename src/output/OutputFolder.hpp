#pragma once
/// The folder in which a run leaves its files.

#include <string>
#include <vector>

namespace Rhegma
{

/// The scene's path with .out instead of .xml.
std::string defaultOutputFolder(const std::string& scene);

/// Makes the folder, and those above it, unless it exists, and tests whether files can be written in it.
/// Nothing in it is changed. \return the folder Throws std::invalid_argument when it can't be made or
/// written.
std::string makeOutputFolder(const std::string& folder);

/// Names of the files that a run leaves.
const std::vector<std::string>& resultNames();

/// Throws std::invalid_argument where a file that a run would replace is the scene, or is none that a run
/// wrote. Nothing is changed.
void refuseForeignFiles(const std::string& folder, const std::string& scene);

/// Name of the file in which `--twice` compares two runs.
constexpr const char* comparisonName = "twice.json";

/// The same for the files that `--twice` replaces in the folder around its two runs.
void refuseForeignComparison(const std::string& folder, const std::string& scene);

/// Removes the comparison of older runs.
void removeOldComparison(const std::string& folder);

/// Renames a file that can't be used: fields.h5 to fields.unread.h5, or to fields.unread.2.h5 and so on where
/// that exists. \return the new path Throws OutputError when it can't be renamed.
std::string setAside(const std::string& path);

/// Removes the summary and the manifest of a run that continues, and partial files of a killed run.
void removeOldSummary(const std::string& folder);

/// Removes the files of an older run in the folder, so that a killed run leaves no file of another.
void removeOldResults(const std::string& folder);

} // namespace Rhegma
