#pragma once
/// Parallel writing of rows into the tables of an HDF5 file.

#include "output/Snapshot.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

inline const void* valuesOf(const DataSet& data)
{
  return data.integer ? static_cast<const void*>(data.whole.data()) : data.real.data();
}

/// Reserves space in the file system for the rows of all ranks. Throws OutputError where there is not enough.
/// \param offsets byte at which each table begins, mesh after mesh
void reserve(const std::string& path, const Snapshot& snapshot, const std::vector<double>& offsets);

/// Writes this rank's rows of all tables. Collective; throws OutputError on all ranks if it fails on one.
void writeParts(const Ranks& ranks, const std::string& path, const Snapshot& snapshot,
                const std::vector<double>& offsets);

} // namespace Rhegma
