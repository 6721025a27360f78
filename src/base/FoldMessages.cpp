#include "base/FoldMessages.hpp"

#include <cctype>
#include <map>

namespace Rhegma
{

namespace
{

constexpr int most = 10;
const std::string begin = "and ", middle = " more like: ";

/// A path of names such as "Bodies > Ball 3 > Radius" from its first > on: what the scene names is left out,
/// the parameter at its end is not. \return position after it
std::size_t skipPath(const std::string& text, std::size_t at, std::string& kind)
{
  const std::size_t end = std::min(text.find_first_of(",:;()\"", at), text.size());
  const std::size_t last = text.rfind(" > ", end - 1);
  kind += '>';
  if (last != std::string::npos && last > at)
    kind += text.substr(last + 3, end - last - 3);
  return end;
}

/// The message without what differs within a kind.
std::string kindOf(const std::string& text)
{
  std::string kind;
  for (std::size_t at = 0; at < text.size();)
  {
    const char c = text[at];
    if (c == '"')
    {
      const std::size_t close = text.find('"', at + 1);
      at = close == std::string::npos ? text.size() : close + 1;
    }
    else if (c == '>')
      at = skipPath(text, at, kind);
    else if (std::isdigit(static_cast<unsigned char>(c)) != 0)
    {
      at = text.find_first_not_of("0123456789.e+-", at);
      at = at == std::string::npos ? text.size() : at;
    }
    else
    {
      if (c != '-') // of a number
        kind += c;
      ++at;
    }
  }
  return kind;
}

struct Kind
{
  int shown = 0;
  long hidden = 0;
  std::size_t line = 0; ///< of the last one that is shown
  std::string first;
};

/// A line of an earlier fold: how many it stands for, and the message after that; 0: it is none.
long hiddenIn(const std::string& text, std::string& message)
{
  const std::size_t end = text.find(middle);
  if (text.compare(0, begin.size(), begin) != 0 || end == std::string::npos)
    return 0;
  const std::string number = text.substr(begin.size(), end - begin.size());
  if (number.empty() || number.find_first_not_of("0123456789") != std::string::npos || number.size() > 12)
    return 0;
  message = text.substr(end + middle.size());
  return std::stol(number);
}

} // namespace

std::vector<std::string> foldMessages(const std::vector<std::string>& messages)
{
  std::map<std::string, Kind> kinds;
  std::vector<std::string> shown;
  for (const std::string& message : messages)
  {
    std::string like;
    const long hidden = hiddenIn(message, like);
    Kind& kind = kinds[kindOf(hidden > 0 ? like : message)];
    if (kind.first.empty())
      kind.first = hidden > 0 ? like : message;
    kind.hidden += hidden;
    if (hidden > 0)
      continue;
    if (kind.shown < most)
    {
      ++kind.shown;
      shown.push_back(message);
      kind.line = shown.size();
    }
    else
      ++kind.hidden;
  }
  std::map<std::size_t, std::vector<std::string>> after;
  for (const auto& [text, kind] : kinds)
    if (kind.hidden > 0)
      after[kind.line].push_back(begin + std::to_string(kind.hidden) + middle + kind.first);
  std::vector<std::string> all;
  for (std::size_t k = 0; k <= shown.size(); ++k)
  {
    if (k > 0)
      all.push_back(shown[k - 1]);
    if (const auto counts = after.find(k); counts != after.end())
      all.insert(all.end(), counts->second.begin(), counts->second.end());
  }
  return all;
}

} // namespace Rhegma
