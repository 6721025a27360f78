#include "checkpoint/SceneText.hpp"

#include "base/FileChecksum.hpp"
#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "scene/Validation.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <zlib.h>

namespace Rhegma
{

namespace
{

/// The text on one line: white space becomes a single blank.
std::string onOneLine(const std::string& text)
{
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;)
    line += (line.empty() ? "" : " ") + word;
  return line;
}

/// Whether a parameter is the path of a file (readScene).
bool isFile(const std::string& name)
{
  const std::string whole = "File", mark = " File";
  return name == whole ||
         (name.size() > mark.size() && name.compare(name.size() - mark.size(), mark.size(), mark) == 0);
}

/// Without its folder, which depends on where the program runs.
std::string nameOfFile(const std::string& path) { return std::filesystem::path(path).filename().string(); }

/// The name of a file; of a law its content, too.
std::string textOfFile(const std::string& parameter, const std::string& path)
{
  return nameOfFile(path) + (parameter == "Library File" ? ", CRC-32 " + fileChecksum(path) : "");
}

std::string valueOf(const Teuchos::ParameterList& list, const std::string& name)
{
  if (list.isType<double>(name))
    return formatExactly(list.get<double>(name));
  if (list.isType<int>(name))
    return std::to_string(list.get<int>(name));
  if (list.isType<bool>(name))
    return list.get<bool>(name) ? "true" : "false";
  if (list.isType<std::string>(name))
    return onOneLine(isFile(name) ? textOfFile(name, list.get<std::string>(name))
                                  : list.get<std::string>(name));
  std::vector<double> all;
  if (list.isType<Teuchos::Array<int>>(name))
    for (const int value : list.get<Teuchos::Array<int>>(name))
      all.push_back(value);
  else
    for (const double value : list.get<Teuchos::Array<double>>(name))
      all.push_back(value);
  return formatReals(all);
}

void addLines(const Teuchos::ParameterList& list, const Section& section, const std::string& path,
              std::vector<std::string>& lines)
{
  lines.push_back(path);
  const ActiveSection active(section, list);
  std::vector<std::string> parameters;
  for (const Parameter* parameter : active.parameters)
    if (!parameter->changeable && list.isParameter(parameter->name))
      parameters.push_back(parameter->name);
  std::sort(parameters.begin(), parameters.end());
  for (const std::string& name : parameters)
    lines.push_back(scenePath(path, name) + " = " + valueOf(list, name));
  for (const std::string& name : sublistNames(list))
  {
    const Section* sub = active.findSection(name);
    sub = sub == nullptr ? active.entry : sub;
    if (sub != nullptr && !sub->changeable)
      addLines(list.sublist(name), *sub, scenePath(path, name), lines);
  }
}

/// The part of a line before the value.
std::string positionOf(const std::string& line) { return line.substr(0, line.find(" = ")); }

std::string inQuotes(const std::string& line)
{
  constexpr std::size_t longest = 60;
  const std::size_t at = line.find(" = ");
  if (at == std::string::npos)
    return "there";
  const std::string value = line.substr(at + 3);
  return "\"" + (value.size() > longest ? value.substr(0, longest) + "..." : value) + "\"";
}

} // namespace

std::vector<std::string> sceneLines(const Teuchos::ParameterList& scene, const SceneSchema& schema)
{
  std::vector<std::string> lines;
  for (const Section& section : schema.root().sections)
    if (!section.changeable && scene.isSublist(section.name))
      addLines(scene.sublist(section.name), section, section.name, lines);
  for (const KeptParameter& kept : keptParameters(scene, schema))
    if (const auto& list = scene.sublist(kept.section); list.isParameter(kept.name))
      lines.push_back(scenePath(kept.section, kept.name) + " = " + valueOf(list, kept.name));
  return lines;
}

std::string reasonOfDifference(const std::string& difference, const Teuchos::ParameterList& scene,
                               const SceneSchema& schema)
{
  for (const KeptParameter& kept : keptParameters(scene, schema))
    if (difference.rfind(scenePath(kept.section, kept.name) + " is ", 0) == 0)
      return "; " + kept.reason;
  return {};
}

std::string differenceOfScenes(const std::vector<std::string>& now, const std::vector<std::string>& then)
{
  const auto has = [](const std::vector<std::string>& lines, const std::string& position)
  {
    return std::any_of(lines.begin(), lines.end(),
                       [&](const std::string& line) { return positionOf(line) == position; });
  };
  for (std::size_t k = 0; k < std::max(now.size(), then.size()); ++k)
  {
    if (k < now.size() && k < then.size() && now[k] == then[k])
      continue;
    if (k < now.size() && k < then.size() && positionOf(now[k]) == positionOf(then[k]))
      return positionOf(now[k]) + " is " + inQuotes(now[k]) + " in the scene and " + inQuotes(then[k]) +
             " in the checkpoint";
    if (k < now.size() && !has(then, positionOf(now[k])))
      return positionOf(now[k]) + " is in the scene and not in the checkpoint";
    if (k < then.size() && !has(now, positionOf(then[k])))
      return positionOf(then[k]) + " is in the checkpoint and not in the scene";
    return positionOf(now[k]) + " is at another position in the order of the scene than in the checkpoint";
  }
  return {};
}

long hashOfScene(const std::vector<std::string>& lines)
{
  uLong hash = crc32(0, nullptr, 0);
  for (const std::string& line : lines)
    hash =
        crc32(hash, reinterpret_cast<const Bytef*>((line + "\n").data()), static_cast<uInt>(line.size() + 1));
  return static_cast<long>(hash);
}

} // namespace Rhegma
