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

/// Removes all snapshots of a file except the first `count`. Throws OutputError where the file can't be read
/// or has fewer.
void keepSnapshots(const std::string& path, int count);

/// Adds a group with the attribute `time` and a group per mesh inside, and closes the file.
///
/// With several ranks each has a part (partOfAll). The first makes groups and tables and reserves their space
/// in the file system, so that a full disk is found before anything is written; then all write their rows at
/// their offsets, collectively through MPI, and the first links the snapshot into the file. HDF5 itself runs
/// on one rank only, so that a failure leaves it no unwritten data. Collective; throws on all ranks or on
/// none.
void appendSnapshot(const std::string& path, const std::string& group, const Snapshot& snapshot,
                    const Ranks& ranks = {});

} // namespace Rhegma
