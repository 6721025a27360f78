#pragma once
/// Numbers of things in messages.

#include <string>

namespace Rhegma
{

/// Such as "1 step" and "2 steps". \param noun in the singular, whose plural ends in s
inline std::string counted(long number, const std::string& noun)
{
  return std::to_string(number) + " " + noun + (number == 1 ? "" : "s");
}

} // namespace Rhegma
