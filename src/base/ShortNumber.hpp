#pragma once

#include <cstdio>
#include <string>

namespace Rhegma
{

/// A measured number for a message, in four digits: enough to judge by, too few to copy.
inline std::string formatShort(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

} // namespace Rhegma
