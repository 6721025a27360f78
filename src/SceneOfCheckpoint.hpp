#pragma once
/// The scene and the version of the program as a checkpoint holds them.

#include "archive/Record.hpp"

#include <sstream>
#include <string>
#include <vector>

namespace Rhegma
{

/// The version of the program that wrote a checkpoint.
inline std::string versionOf(const Record& record)
{
  const auto found = record.find("version");
  return found == record.end() ? "unknown"
                               : std::string(found->second.bytes.begin(), found->second.bytes.end());
}

/// The lines of a scene as one text.
inline std::string text(const std::vector<std::string>& lines)
{
  std::string all;
  for (const std::string& line : lines)
    all += line + "\n";
  return all;
}

/// The lines of such a text.
inline std::vector<std::string> linesOf(const std::string& text)
{
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}

} // namespace Rhegma
