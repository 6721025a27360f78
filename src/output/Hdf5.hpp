#pragma once
/// Writing tables to HDF5 files.

#include "output/Snapshot.hpp"

#include <string>

namespace Rhegma
{

/// Makes an empty file; an older one is replaced, which those who have it open don't notice.
/// Throws OutputError when it can't, as does the next.
void createHdf5(const std::string& path);

/// Name of the group of a snapshot, counted from 0.
std::string snapshotName(int number);

/// Removes all snapshots of a file but the first `count`. Throws OutputError where the file can't be read or
/// has not so many.
void keepSnapshots(const std::string& path, int count);

/// Adds a group with the attribute `time` and a group per mesh inside, and closes the file.
///
/// Where there are many ranks each brings its part (partOfAll). The first makes groups and tables and has the
/// file system reserve their room, so that a full disk shows before anything is written; then all write their
/// rows where these lie, collectively through MPI, and the first lets the file know of the snapshot. HDF5
/// itself never works for several ranks at once: a failure leaves it nothing that it could not bring to the
/// disk. Collective; throws on all ranks or on none.
void appendSnapshot(const std::string& path, const std::string& group, const Snapshot& snapshot,
                    const Ranks& ranks = {});

} // namespace Rhegma
