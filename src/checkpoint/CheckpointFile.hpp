#pragma once
/// checkpoint.h5 on the disk: written completely or not at all, with checksums.

#include "archive/Record.hpp"

#include <string>

namespace Rhegma
{

/// Number of the layout of a checkpoint; another number is refused. It is raised with every change of the
/// names or types of what a checkpoint holds, which unit_tests/restart/checkpoint_names.txt lists.
constexpr int checkpointSchema = 23;

/// Writes a record as an HDF5 file: tables as datasets in groups, single numbers as attributes of their
/// groups.
///
/// The file begins with a block of 512 bytes that HDF5 leaves to its user: 16 bytes of magic, then as
/// little-endian numbers the schema (4 bytes), the CRC-32 of all that follows the block (4), how many bytes
/// that is (8), zeros, and in its last 4 bytes the CRC-32 of the block before them. So every bit of the file,
/// those of HDF5's own structures included, is under a checksum.
///
/// The file is written next to `path` under the name PATH.part, synchronised to the disk and then renamed, so
/// that a kill, a full disk or a power failure leaves the older file. Throws OutputError when it can't be
/// written.
void writeCheckpoint(const std::string& path, const Record& record);

/// Reads a checkpoint. Throws std::invalid_argument where the file can't be read, is no checkpoint, is of
/// another schema, is cut short or has changed since it was written.
Record readCheckpoint(const std::string& path);

} // namespace Rhegma
