#include "base/NonNumbers.hpp"

#include <algorithm>
#include <cctype>
#include <initializer_list>

namespace Rhegma
{

namespace
{

/// Whether a word stands where a name of the user's does: after "> " or what it is the name of.
bool followsNoun(const std::string& message, std::size_t at)
{
  const std::initializer_list<std::string> nouns{"> ",    "crack ", "cracks ",  "Crack ",
                                                 "body ", "Body ",  "material "};
  return std::any_of(nouns.begin(), nouns.end(),
                     [&](const std::string& noun)
                     {
                       return at >= noun.size() &&
                              message.compare(at - noun.size(), noun.size(), noun) == 0 &&
                              (noun == "> " || at == noun.size() ||
                               std::isalnum(static_cast<unsigned char>(message[at - noun.size() - 1])) == 0);
                     });
}

} // namespace

std::size_t findNonNumber(const std::string& message, std::size_t from)
{
  const auto isLetter = [&](std::size_t at)
  {
    return at < message.size() &&
           (std::isalnum(static_cast<unsigned char>(message[at])) != 0 || message[at] == '_');
  };
  // Names of the user's have hyphens and points within them; a message ends in a point.
  const auto isPartOfWord = [&](std::size_t at, int step)
  {
    if (at < message.size() && (message[at] == '-' || message[at] == '.'))
      return isLetter(at + step);
    return isLetter(at) || (at < message.size() && (message[at] & 0x80) != 0); // part of a letter in UTF-8
  };
  const auto next = [&](std::size_t after)
  { return std::min(message.find("nan", after), message.find("inf", after)); };
  for (std::size_t at = next(from); at != std::string::npos; at = next(at + 1))
  {
    const bool quoted = std::count(message.begin(), message.begin() + at, '"') % 2 == 1;
    if (!quoted && !followsNoun(message, at) && !(at > 0 && isPartOfWord(at - 1, -1)) &&
        !isPartOfWord(at + 3, 1))
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
