#pragma once
/// Whether a file that is used has the same content as in an earlier run.

#include <string>

namespace Rhegma
{

/// Reads a file that is about to be used, and keeps its checksum: the file may be replaced later. Not to be
/// called by several threads.
void keepChecksum(const std::string& file);

/// CRC-32 of the content of a file, in hexadecimal digits: as keepChecksum found it, if it was called; empty
/// if the file can't be read.
std::string fileChecksum(const std::string& file);

} // namespace Rhegma
