#include "scene/XmlAttributes.hpp"

#include "scene/NearestName.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

namespace Rhegma
{

namespace
{

bool isSpace(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// A tag that begins or stands alone: its name and its attributes, in their order.
struct Tag
{
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;

  /// \param content what stands between < and >
  explicit Tag(const std::string& content)
  {
    std::size_t at = 0;
    while (at < content.size() && !isSpace(content[at]) && content[at] != '/')
      ++at;
    name = content.substr(0, at);
    for (std::size_t equals = content.find('=', at); equals != std::string::npos;
         equals = content.find('=', at))
    {
      std::size_t begin = at, end = equals;
      while (begin < end && isSpace(content[begin]))
        ++begin;
      while (end > begin && isSpace(content[end - 1]))
        --end;
      const std::size_t open = content.find_first_of("\"'", equals);
      const std::size_t close = open == std::string::npos ? open : content.find(content[open], open + 1);
      if (close == std::string::npos)
        return;
      attributes.emplace_back(content.substr(begin, end - begin), content.substr(open + 1, close - open - 1));
      at = close + 1;
    }
  }

  std::string find(const std::string& attribute) const
  {
    for (const auto& [known, value] : attributes)
      if (known == attribute)
        return value;
    return {};
  }
};

/// What a scene may say, then what Teuchos adds where it writes a list.
const std::vector<std::string>& knownAttributes(const std::string& tag)
{
  static const std::vector<std::string> ofLists = {"name", "id", "docString"};
  static const std::vector<std::string> ofParameters = {"name",      "type",   "value",     "id",
                                                        "isDefault", "isUsed", "docString", "validatorId"};
  static const std::vector<std::string> none;
  return tag == "ParameterList" ? ofLists : tag == "Parameter" ? ofParameters : none;
}

/// \return what is wrong with the attributes of a tag; empty: nothing
std::string mistakeIn(const Tag& tag)
{
  const std::vector<std::string>& known = knownAttributes(tag.name);
  if (known.empty()) // the tag itself is refused
    return {};
  for (std::size_t k = 0; k < tag.attributes.size(); ++k)
  {
    const std::string& name = tag.attributes[k].first;
    if (std::find(known.begin(), known.end(), name) == known.end())
    {
      const std::string nearest = nearestName(name, known);
      return "<" + tag.name + "> has no attribute \"" + name + "\"; " +
             (nearest.empty()
                  ? "write " + asText({known.begin(), known.begin() + (known.size() > 3 ? 3 : 1)}, " and ") +
                        " only."
                  : "did you mean \"" + nearest + "\"?");
    }
    for (std::size_t other = 0; other < k; ++other)
      if (tag.attributes[other].first == name)
        return "<" + tag.name + "> has the attribute \"" + name + "\" twice; keep one of the two.";
  }
  return {};
}

} // namespace

std::size_t endOfTag(const std::string& xml, std::size_t from)
{
  if (xml.compare(from, 4, "<!--") == 0)
  {
    const std::size_t close = xml.find("-->", from);
    return close == std::string::npos ? xml.size() : close + 2;
  }
  char quote = '\0';
  for (std::size_t at = from; at < xml.size(); ++at)
    if (quote != '\0')
      quote = xml[at] == quote ? '\0' : quote;
    else if (xml[at] == '"' || xml[at] == '\'')
      quote = xml[at];
    else if (xml[at] == '>')
      return at;
  return xml.size();
}

void checkAttributes(const std::string& xml, std::vector<SceneError>& errors)
{
  std::vector<std::string> paths; // of the tags around
  std::size_t line = 1, counted = 0, end = 0;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', end))
  {
    end = endOfTag(xml, at);
    const char next = at + 1 < xml.size() ? xml[at + 1] : ' ';
    if (next == '!' || next == '?')
      continue;
    if (next == '/')
    {
      if (!paths.empty())
        paths.pop_back();
      continue;
    }
    const Tag tag(xml.substr(at + 1, end - at - 1));
    const std::string path = paths.empty() ? std::string() : scenePath(paths.back(), tag.find("name"));
    if (const std::string mistake = mistakeIn(tag); !mistake.empty())
    {
      line += std::count(xml.begin() + counted, xml.begin() + at, '\n');
      counted = at;
      errors.push_back({path, "line " + std::to_string(line) + ": " + mistake});
    }
    if (xml[end - 1] != '/')
      paths.push_back(path);
  }
}

} // namespace Rhegma
