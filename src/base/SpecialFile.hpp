#pragma once
/// Files whose content is not on a disk.

#include <filesystem>
#include <string>

namespace Rhegma
{

/// "a pipe", "a socket" or "a device"; empty for a regular file, a folder, and where there is none. Reading
/// such a file may wait for ever.
inline std::string kindOfSpecialFile(const std::filesystem::file_status& status)
{
  switch (status.type())
  {
  case std::filesystem::file_type::fifo:
    return "a pipe";
  case std::filesystem::file_type::socket:
    return "a socket";
  case std::filesystem::file_type::block:
  case std::filesystem::file_type::character:
    return "a device";
  default:
    return {};
  }
}

} // namespace Rhegma
