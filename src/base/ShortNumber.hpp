#pragma once

#include <cstdio>
#include <string>

namespace Rhegma
{

/// A measured number in a sentence, in four digits: enough to judge by, too few to copy.
inline std::string shortly(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

} // namespace Rhegma
