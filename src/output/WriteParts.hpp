#pragma once
/// Rows that ranks write into a file of HDF5 where their tables lie.

#include "output/Snapshot.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

inline const void* valuesOf(const DataSet& data)
{
  return data.integer ? static_cast<const void*>(data.whole.data()) : data.real.data();
}

/// Has the file system set room aside for the rows of all ranks. Throws OutputError where there is none.
/// \param positions byte at which each table begins, mesh after mesh
void reserve(const std::string& path, const Snapshot& snapshot, const std::vector<double>& places);

/// Writes this rank's rows of all tables. Collective; throws OutputError on all ranks where it fails on any.
void writeParts(const Ranks& ranks, const std::string& path, const Snapshot& snapshot,
                const std::vector<double>& places);

} // namespace Rhegma
