#pragma once
/// Writing tables to HDF5 files.

#include "output/Snapshot.hpp"

#include <string>

namespace Rhegma
{

/// Makes an empty file; an older one is replaced, which those who have it open don't notice.
/// Throws OutputError when it can't, as does the next.
void createHdf5(const std::string& path);

/// Adds a group with the attribute `time` and a group per mesh inside, and closes the file.
void appendSnapshot(const std::string& path, const std::string& group, const Snapshot& snapshot);

} // namespace Rhegma
