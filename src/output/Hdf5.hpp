#pragma once
/// Writing tables to HDF5 files.

#include "output/Snapshot.hpp"

#include <string>

namespace Rhegma
{

/// Makes an empty file; an older one is replaced, but stays valid for programs that have it open. Throws
/// OutputError when it can't, as does the next.
void createHdf5(const std::string& path);

/// Name of the group of a snapshot, counted from 0.
std::string snapshotName(int number);

/// Removes all snapshots of a file except the first `count`, which are read and compared with their
/// checksums. Throws OutputError where the file can't be opened, or with the names of those that are missing
/// or damaged.
void keepSnapshots(const std::string& path, int count);

/// Adds a group with the attribute `time` and a group per mesh inside, and closes the file.
///
/// Each chunk of a table has HDF5's checksum (Fletcher-32); groups, attributes and indices have those of HDF5
/// 1.10, which readers need. With several ranks each has a part (partOfAll), which the first gathers chunk by
/// chunk and writes: HDF5 runs on one rank only. Collective; throws on all ranks or on none.
void appendSnapshot(const std::string& path, const std::string& group, const Snapshot& snapshot,
                    const Ranks& ranks = {});

} // namespace Rhegma
