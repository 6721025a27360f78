#include "files/TextFile.hpp"

#include "base/OutputError.hpp"
#include "files/Sync.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <unistd.h>

namespace Rhegma
{

namespace
{

[[noreturn]] void failToReplace(const std::string& path, int reason)
{
  throw OutputError(path + " can't be written: " + std::strerror(reason));
}

/// Writes an open file and closes it. \return 0, or the error number
int writeAndClose(std::FILE* file, const std::string& text, bool synced)
{
  int reason = 0;
  if (std::fwrite(text.data(), 1, text.size(), file) != text.size() || std::fflush(file) != 0)
    reason = errno;
  else if (synced)
    reason = syncOpenFile(fileno(file));
  if (std::fclose(file) != 0 && reason == 0)
    reason = errno;
  return reason;
}

/// Fills a temporary file and renames it. \param file null: it could not be opened, for the reason in errno
void fillAndRename(std::FILE* file, const std::string& temporary, const std::string& path,
                   const std::string& text, bool synced)
{
  if (file == nullptr)
    failToReplace(path, errno);
  int reason = writeAndClose(file, text, synced);
  if (reason == 0 && std::rename(temporary.c_str(), path.c_str()) != 0)
    reason = errno;
  if (reason != 0)
  {
    std::remove(temporary.c_str());
    failToReplace(path, reason);
  }
  if (synced)
    syncFolderOf(path);
}

void replaceByRenaming(const std::string& path, const std::string& text, bool synced)
{
  const std::string temporary = path + ".part";
  fillAndRename(std::fopen(temporary.c_str(), "wb"), temporary, path, text, synced);
}

} // namespace

void replaceFile(const std::string& path, const std::string& text) { replaceByRenaming(path, text, true); }
void replaceFileUnsynced(const std::string& path, const std::string& text)
{
  replaceByRenaming(path, text, false);
}

void replaceSharedFile(const std::string& path, const std::string& text)
{
  std::string temporary = path + ".XXXXXX";
  const int file = mkstemp(temporary.data());
  fillAndRename(file < 0 ? nullptr : fdopen(file, "wb"), temporary, path, text, false);
}

} // namespace Rhegma
