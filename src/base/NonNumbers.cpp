#include "base/NonNumbers.hpp"

#include <algorithm>
#include <cctype>

namespace Rhegma
{

std::size_t findNonNumber(const std::string& message, std::size_t from)
{
  const auto isPartOfWord = [&](std::size_t at)
  { return at < message.size() && std::isalnum(static_cast<unsigned char>(message[at])) != 0; };
  const auto next = [&](std::size_t after)
  { return std::min(message.find("nan", after), message.find("inf", after)); };
  for (std::size_t at = next(from); at != std::string::npos; at = next(at + 1))
  {
    const bool quoted = std::count(message.begin(), message.begin() + at, '"') % 2 == 1;
    const bool named = at >= 2 && message.compare(at - 2, 2, "> ") == 0;
    if (!quoted && !named && !(at > 0 && isPartOfWord(at - 1)) && !isPartOfWord(at + 3))
      return at;
  }
  return std::string::npos;
}

std::string withWordsForNonNumbers(std::string message)
{
  for (std::size_t at = findNonNumber(message); at != std::string::npos; at = findNonNumber(message, at))
  {
    const std::string words = message[at] == 'n' ? "no number of" : "endlessly many";
    const std::size_t sign = at > 0 && message[at - 1] == '-' ? 1 : 0;
    message.replace(at - sign, 3 + sign, words);
    at += words.size() - sign;
  }
  return message;
}

} // namespace Rhegma
