#pragma once
/// Text of comma-separated values.

#include <cstdio>
#include <string>

namespace Rhegma
{

/// A number with 17 digits, which represent a double exactly.
inline std::string digits(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// A name as a field of a row: in quotes where it holds what separates fields (RFC 4180).
inline std::string quoted(const std::string& name)
{
  if (name.find_first_of(",\"\r\n") == std::string::npos)
    return name;
  std::string text = "\"";
  for (const char c : name)
    text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

} // namespace Rhegma
