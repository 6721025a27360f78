#pragma once
/// Text files that are replaced atomically.

#include <string>

namespace Rhegma
{

/// Writes a temporary file, PATH.part, next to `path` and renames it to `path`. File and folder are
/// synchronised to the disk, so that after a power failure `path` is the older or the new file. Throws
/// OutputError when it can't be written; the older file then stays.
void replaceFile(const std::string& path, const std::string& text);

/// The same for a file that is replaced often, without waiting for the disk: after a power failure `path` may
/// be empty.
void replaceFileUnsynced(const std::string& path, const std::string& text);

/// The same for a file that several processes may replace at the same time, also unsynchronised: each
/// temporary file has a name of its own, PATH.XXXXXX.
void replaceSharedFile(const std::string& path, const std::string& text);

} // namespace Rhegma
