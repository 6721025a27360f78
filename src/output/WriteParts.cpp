#include "output/WriteParts.hpp"

#include "files/Hdf5Handle.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <fcntl.h>
#include <unistd.h>

namespace Rhegma
{

namespace
{

std::size_t bytesOfRow(const DataSet& data)
{
  return data.columns * (data.integer ? sizeof(int) : sizeof(double));
}

/// Calls call(table, its position) for each table that has rows on any rank.
template <class Call>
void forEachTable(const Snapshot& snapshot, const std::vector<double>& positions, const Call& call)
{
  std::size_t k = 0;
  for (const OutputMesh& mesh : snapshot.meshes)
    for (const DataSet& data : mesh.data)
    {
      const auto position = static_cast<long long>(positions[k++]);
      if (data.rowsOfAll() > 0)
        call(data, position);
    }
}

/// Writes this rank's part of a table.
bool writePart(MPI_File file, const DataSet& data, long long position)
{
  const MPI_Datatype type = data.integer ? MPI_INT : MPI_DOUBLE;
  const int count = static_cast<int>(data.rows() * data.columns);
  MPI_Status status;
  const auto at = static_cast<MPI_Offset>(position + static_cast<long long>(data.before * bytesOfRow(data)));
  if (MPI_File_write_at_all(file, at, valuesOf(data), count, type, &status) != MPI_SUCCESS)
    return false;
  int written = 0;
  MPI_Get_count(&status, type, &written);
  return written == count;
}

} // namespace

void reserve(const std::string& path, const Snapshot& snapshot, const std::vector<double>& positions)
{
  const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  bool good = file >= 0;
#ifndef __APPLE__ // which lacks this call
  forEachTable(snapshot, positions,
               [&](const DataSet& data, long long position)
               {
                 const auto bytes = static_cast<off_t>(data.rowsOfAll() * bytesOfRow(data));
                 good = good && posix_fallocate(file, position, bytes) == 0;
               });
#endif
  if (file >= 0)
    close(file);
  if (!good)
    throw OutputError(unwritable(path));
}

void writeParts(const Ranks& ranks, const std::string& path, const Snapshot& snapshot,
                const std::vector<double>& positions)
{
  const MPI_Comm all = *dynamic_cast<const Teuchos::MpiComm<int>&>(*ranks.comm()).getRawMpiComm();
  MPI_File file;
  // Files, unlike messages, return their errors.
  const bool opened = MPI_File_open(all, path.c_str(), MPI_MODE_WRONLY, MPI_INFO_NULL, &file) == MPI_SUCCESS;
  if (ranks.max(opened ? 0.0 : 1.0) > 0.0)
    throw OutputError(path + " can't be opened by all ranks; choose a folder that all ranks can write to");
  bool good = true;
  forEachTable(snapshot, positions,
               [&](const DataSet& data, long long position)
               { good = writePart(file, data, position) && good; });
  good = MPI_File_close(&file) == MPI_SUCCESS && good;
  if (ranks.max(good ? 0.0 : 1.0) > 0.0)
    throw OutputError(unwritable(path));
}

} // namespace Rhegma
