#pragma once
/// Files and names of files that survive a power failure.

#include <string>

namespace Rhegma
{

/// Waits until the content of an open file is on the disk.
/// \param file descriptor
/// \return 0, or the error number; 0 also for what can't be synchronised, such as a pipe
int syncOpenFile(int file);

/// Waits until the content of a file is on the disk. Throws OutputError on failure.
void syncFile(const std::string& path);

/// Waits until the name of a file is on the disk, after the file was made or renamed. File systems that do
/// not support this are ignored.
void syncFolderOf(const std::string& path);

} // namespace Rhegma
