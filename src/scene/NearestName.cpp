#include "scene/NearestName.hpp"

#include <algorithm>
#include <cctype>

namespace Rhegma
{

std::string lowerCase(std::string text)
{
  for (char& c : text)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

int editDistance(const std::string& a, const std::string& b)
{
  const std::string from = lowerCase(a);
  const std::string to = lowerCase(b);
  const std::size_t rows = from.size() + 1;
  const std::size_t columns = to.size() + 1;
  std::vector<std::vector<int>> d(rows, std::vector<int>(columns));
  for (std::size_t i = 0; i < rows; ++i)
    d[i][0] = static_cast<int>(i);
  for (std::size_t j = 0; j < columns; ++j)
    d[0][j] = static_cast<int>(j);
  for (std::size_t i = 1; i < rows; ++i)
    for (std::size_t j = 1; j < columns; ++j)
    {
      const int change = from[i - 1] == to[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[rows - 1][columns - 1];
}

std::string nearestName(const std::string& given, const std::vector<std::string>& names)
{
  std::string nearest;
  int distance = std::max(2, static_cast<int>(given.size()) / 3) + 1; // a third of the letters may differ
  for (const auto& name : names)
  {
    const int d = editDistance(given, name);
    // At least one letter must match.
    if (d < distance && d < static_cast<int>(std::max(given.size(), name.size())))
    {
      distance = d;
      nearest = name;
    }
  }
  return nearest;
}

std::string suggestion(const std::string& given, const std::vector<std::string>& names)
{
  const std::string nearest = nearestName(given, names);
  if (!nearest.empty())
    return "did you mean \"" + nearest + "\"?";
  if (names.empty())
    return "nothing is allowed here.";
  return "possible here: " + asText(names, ", ") + ".";
}

std::string renamedTo(const std::string& newName)
{
  return "this parameter is now named \"" + newName + "\"; write that name.";
}

std::string asText(const std::vector<std::string>& names, const std::string& lastJoin)
{
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? lastJoin : ", ") + names[i];
  return text;
}

} // namespace Rhegma
