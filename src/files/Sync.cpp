#include "files/Sync.hpp"

#include "base/OutputError.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

namespace Rhegma
{

int syncOpenFile(int file) { return fsync(file) == 0 || errno == EINVAL ? 0 : errno; }

void syncFile(const std::string& path)
{
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const int reason = file < 0 ? errno : syncOpenFile(file);
  if (file >= 0)
    close(file);
  if (reason != 0)
    throw OutputError(path + " can't be written: " + std::strerror(reason));
}

void syncFolderOf(const std::string& path)
{
  const std::string folder = std::filesystem::path(path).parent_path().string();
  const int handle = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle < 0)
    return;
  fsync(handle);
  close(handle);
}

} // namespace Rhegma
