#pragma once
/// Calendar time as text.

#include <ctime>
#include <string>

namespace Rhegma
{

/// Date and time of day in UTC, such as "2026-11-23 09:12:05 UTC". \param time seconds since 1970
inline std::string utcTime(std::time_t time)
{
  std::tm parts{};
  gmtime_r(&time, &parts);
  char text[48];
  const std::size_t length = std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S UTC", &parts);
  return {text, length};
}

} // namespace Rhegma
