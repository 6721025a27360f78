#include "output/Hdf5.hpp"

#include "files/Hdf5Handle.hpp"
#include "parallel/FirstRank.hpp"

#include <algorithm>
#include <cstdio>
#include <fcntl.h>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace Rhegma
{

namespace
{

void writeTime(hid_t group, double time, const std::string& path)
{
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, path);
  const Handle attribute(H5Acreate2(group, "time", H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         path);
  attribute.require(H5Awrite(attribute, H5T_NATIVE_DOUBLE, &time));
}

/// Bytes of a chunk: as large as the cache that HDF5 gives each table of a reader.
constexpr std::size_t chunkBytes = 1 << 20;

/// Chunks of nearly the same number of rows: the last one takes as much of the file as the others.
hsize_t rowsOfChunk(const DataSet& data)
{
  const std::size_t row = data.columns * (data.integer ? sizeof(int) : sizeof(double));
  const hsize_t chunks = data.rowsOfAll() * row / chunkBytes + 1;
  return std::max<hsize_t>(1, (data.rowsOfAll() + chunks - 1) / chunks);
}

hid_t typeOf(const DataSet& data) { return data.integer ? H5T_NATIVE_INT : H5T_NATIVE_DOUBLE; }

/// A table without numbers yet, whose chunks will have checksums.
Handle makeTable(hid_t group, const DataSet& data, const std::string& path)
{
  const hsize_t extent[2] = {data.rowsOfAll(), static_cast<hsize_t>(data.columns)};
  const int axes = data.columns == 1 ? 1 : 2;
  const Handle space(H5Screate_simple(axes, extent, nullptr), H5Sclose, path);
  const Handle made(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, path);
  const Handle access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose, path);
  if (extent[0] > 0)
  {
    const hsize_t chunk[2] = {rowsOfChunk(data), extent[1]};
    made.require(H5Pset_chunk(made, axes, chunk));
    made.require(H5Pset_fletcher32(made));
    // What is written goes to the file at once, so that a full disk is noticed where it can be reported.
    access.require(H5Pset_chunk_cache(access, 1, 0, 1.0));
  }
  return Handle(H5Dcreate2(group, data.name.c_str(), typeOf(data), space, H5P_DEFAULT, made, access),
                H5Dclose, path);
}

/// Writes rows into a table. \param values as many as the rows have
void writeRows(hid_t set, const DataSet& data, hsize_t first, hsize_t rows, const void* values,
               const std::string& path)
{
  const hsize_t start[2] = {first, 0}, count[2] = {rows, static_cast<hsize_t>(data.columns)};
  const Handle inFile(H5Dget_space(set), H5Sclose, path);
  inFile.require(H5Sselect_hyperslab(inFile, H5S_SELECT_SET, start, nullptr, count, nullptr));
  const Handle inMemory(H5Screate_simple(data.columns == 1 ? 1 : 2, count, nullptr), H5Sclose, path);
  if (H5Dwrite(set, typeOf(data), inMemory, inFile, H5P_DEFAULT, values) < 0)
    throw OutputError(unwritable(path));
}

/// The rows of all ranks between two, on the first rank. Collective.
template <class T>
std::vector<T> gatherRows(const Ranks& ranks, const DataSet& data, const std::vector<T>& own,
                          std::size_t first, std::size_t end)
{
  const std::size_t from = std::clamp(first, data.before, data.before + data.rows()) - data.before;
  const std::size_t to = std::clamp(end, data.before, data.before + data.rows()) - data.before;
  return ranks.gather(std::vector<T>(own.begin() + from * data.columns, own.begin() + to * data.columns));
}

/// How a file of fields is opened, with tables of a form. The file of H5F_LIBVER_V18 is one that a kill
/// leaves readable, later forms of it are marked as open; tables of H5F_LIBVER_V110 have their index under
/// checksums as well.
hid_t accessTo(H5F_libver_t form)
{
  const hid_t access = accessWithoutLock();
  H5Pset_libver_bounds(access, form, form);
  return access;
}

/// A snapshot that goes out before the file knows of it, so that a run that is killed meanwhile leaves a file
/// that can be read.
class Unlinked
{
public:
  Unlinked(const std::string& path, const Snapshot& snapshot)
      : access_(accessTo(H5F_LIBVER_V110), H5Pclose, path),
        file_(H5Fopen(path.c_str(), H5F_ACC_RDWR, access_), H5Fclose, path),
        top_(H5Gcreate_anon(file_, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, path),
        path_(path)
  {
    writeTime(top_, snapshot.time, path);
    for (const OutputMesh& mesh : snapshot.meshes)
      Handle(H5Gcreate2(top_, mesh.name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, path)
          .close();
  }

  /// Makes the next table of a mesh; write() then writes to it.
  void begin(const OutputMesh& mesh, const DataSet& data)
  {
    table_.reset();
    const Handle group(H5Gopen2(top_, mesh.name.c_str(), H5P_DEFAULT), H5Gclose, path_);
    table_.reset(new Handle(makeTable(group, data, path_))); // it can't be moved
  }

  void write(const DataSet& data, hsize_t first, hsize_t rows, const void* values)
  {
    writeRows(*table_, data, first, rows, values, path_);
  }

  void link(const std::string& group)
  {
    table_.reset();
    // First all that the link leads to, with the end of the file, so that a kill between leaves no dead link.
    file_.require(H5Fflush(file_, H5F_SCOPE_GLOBAL));
    file_.require(H5Olink(top_, file_, group.c_str(), H5P_DEFAULT, H5P_DEFAULT));
    file_.require(H5Fflush(file_, H5F_SCOPE_GLOBAL));
    top_.close();
    file_.close();
  }

private:
  Handle access_, file_, top_;
  std::string path_;
  std::unique_ptr<Handle> table_;
};

/// Writes the rows of one table, chunk by chunk; on the first rank only `made` is there. \return why it
/// failed; empty: it did not. Collective.
template <class T>
std::string writeTable(const Ranks& ranks, Unlinked* made, const OutputMesh& mesh, const DataSet& data,
                       const std::vector<T>& own)
{
  std::string failure;
  const auto attempt = [&](const auto& work)
  {
    if (made != nullptr && failure.empty())
      try
      {
        work();
      }
      catch (const OutputError& error)
      {
        failure = error.what();
      }
  };
  attempt([&] { made->begin(mesh, data); });
  const std::size_t all = data.rowsOfAll(), piece = rowsOfChunk(data);
  // The others go on sending where the first can't write.
  for (std::size_t first = 0; first < all; first += piece)
  {
    const std::size_t end = std::min(first + piece, all);
    const std::vector<T> rows = gatherRows(ranks, data, own, first, end);
    attempt([&] { made->write(data, first, end - first, rows.data()); });
  }
  return failure;
}

/// Has the file system set aside what a snapshot takes at most, before HDF5 has anything that it could not
/// write: it can't close such a file, and fails when the program ends.
void reserve(const std::string& path, const Snapshot& snapshot)
{
#ifndef __APPLE__ // which has no such call
  std::size_t bytes = 1 << 16;
  for (const OutputMesh& mesh : snapshot.meshes)
    for (const DataSet& data : mesh.data)
    {
      const std::size_t table =
          data.rowsOfAll() * data.columns * (data.integer ? sizeof(int) : sizeof(double));
      // Its last chunk may be partly empty; each has a checksum and an entry of the index.
      bytes += table + std::min(table, chunkBytes) + (1 << 13) + 64 * (table / chunkBytes + 1);
    }
  const int file = open(path.c_str(), O_RDWR | O_CLOEXEC);
  struct stat now = {};
  const bool good = file >= 0 && fstat(file, &now) == 0 &&
                    posix_fallocate(file, now.st_size, static_cast<off_t>(bytes)) == 0;
  // What was set aside stays so for the moment that it takes.
  const bool back = file >= 0 && (good || ftruncate(file, now.st_size) == 0);
  if (file >= 0)
    close(file);
  if (!good || !back)
    throw OutputError(unwritable(path));
#endif
}

/// Reads a table, which checks its chunks. \return whether it can be read
bool readsWhole(hid_t set)
{
  const hid_t space = H5Dget_space(set);
  std::vector<hsize_t> extent(std::max(H5Sget_simple_extent_ndims(space), 0));
  const bool known = space >= 0 && H5Sget_simple_extent_dims(space, extent.data(), nullptr) >= 0;
  H5Sclose(space);
  if (!known || extent.empty() || extent.size() > 2)
    return false;
  const hsize_t columns = extent.size() == 2 ? extent[1] : 1;
  if (columns > 16)
    return false;
  constexpr hsize_t atOnce = 1 << 16;
  std::vector<double> values(std::min(atOnce, extent[0]) * columns);
  for (hsize_t first = 0; first < extent[0]; first += atOnce)
  {
    const hsize_t start[2] = {first, 0}, count[2] = {std::min(atOnce, extent[0] - first), columns};
    const hid_t inFile = H5Dget_space(set);
    const hid_t inMemory = H5Screate_simple(static_cast<int>(extent.size()), count, nullptr);
    const bool read = H5Sselect_hyperslab(inFile, H5S_SELECT_SET, start, nullptr, count, nullptr) >= 0 &&
                      H5Dread(set, H5T_NATIVE_DOUBLE, inMemory, inFile, H5P_DEFAULT, values.data()) >= 0;
    H5Sclose(inMemory);
    H5Sclose(inFile);
    if (!read)
      return false;
  }
  return true;
}

/// Whether the properties of a group or table can be read, which some readers ask for: they are in parts of
/// the file that its numbers and names do not need.
bool isDescribed(hid_t object)
{
#if H5_VERSION_GE(1, 12, 0)
  H5O_native_info_t info{};
  return H5Oget_native_info(object, &info, H5O_NATIVE_INFO_ALL) >= 0;
#else
  H5O_info_t info{};
  return H5Oget_info(object, &info) >= 0;
#endif
}

/// H5Lvisit calls it for each object of a snapshot; more than 0 ends that.
herr_t findDamage(hid_t group, const char* name, const H5L_info_t*, void*)
{
  const hid_t object = H5Oopen(group, name, H5P_DEFAULT);
  const bool whole =
      object >= 0 && isDescribed(object) && (H5Iget_type(object) != H5I_DATASET || readsWhole(object));
  const bool closed = object >= 0 && H5Oclose(object) >= 0;
  return whole && closed ? 0 : 1;
}

/// For H5Literate, which reads all names.
herr_t passOver(hid_t, const char*, const H5L_info_t*, void*) { return 0; }

bool isWhole(hid_t file, const std::string& name)
{
  const hid_t group = H5Gopen2(file, name.c_str(), H5P_DEFAULT);
  // In native order: for any other one HDF5 makes a list of the names, and where their index is damaged it
  // frees a list that it has not filled.
  const bool whole = group >= 0 && isDescribed(group) && H5Aexists(group, "time") > 0 &&
                     H5Lvisit(group, H5_INDEX_NAME, H5_ITER_NATIVE, findDamage, nullptr) == 0;
  const bool closed = group >= 0 && H5Gclose(group) >= 0;
  return whole && closed;
}

/// A list for a message; the first few where they are many.
std::string few(const std::vector<std::string>& names)
{
  constexpr std::size_t most = 10;
  std::string text;
  for (std::size_t k = 0; k < std::min(names.size(), most); ++k)
    text += (k > 0 ? ", " : "") + names[k];
  return names.size() > most ? text + " and " + std::to_string(names.size() - most) + " more" : text;
}

/// Compares the snapshots of a file with their checksums, and leaves the file as it is. Throws OutputError
/// where some of the first `count` are missing, or any is damaged: to remove one that HDF5 can't read may end
/// the program when it closes the file.
void refuseDamage(const std::string& path, int count)
{
  const Handle access(accessWithoutLock(), H5Pclose, path);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
  if (!Silence::unlessDamaged(file >= 0))
    throw OutputError("HDF5 can't open it");
  std::vector<std::string> missing, damaged;
  int frames = 0;
  htri_t exists = 0;
  for (;; ++frames)
  {
    exists = H5Lexists(file, snapshotName(frames).c_str(), H5P_DEFAULT);
    if (exists < 0 || (exists == 0 && frames >= count))
      break;
    if (exists == 0)
      missing.push_back(snapshotName(frames));
    else if (!isWhole(file, snapshotName(frames)))
      damaged.push_back(snapshotName(frames));
  }
  const bool names = exists == 0 && isDescribed(file) &&
                     H5Literate(file, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, passOver, nullptr) >= 0;
  const bool closed = H5Fclose(file) >= 0;
  Silence::unlessDamaged(missing.empty() && damaged.empty() && names && closed);
  if (!names)
    throw OutputError("the checksums show damage in the list of its frames");
  if (!missing.empty() || !damaged.empty())
    throw OutputError("of its " + std::to_string(frames) + " frames" +
                      (damaged.empty() ? "" : " the checksums show damage in " + few(damaged)) +
                      (missing.empty() ? ""
                                       : (damaged.empty() ? " " : ", and ") + few(missing) +
                                             (missing.size() == 1 ? " is" : " are") + " missing"));
  if (!closed)
    throw OutputError("HDF5 can't close it");
}

} // namespace

void createHdf5(const std::string& path)
{
  const Silence silence;
  std::remove(path.c_str());
  const Handle access(accessTo(H5F_LIBVER_V18), H5Pclose, path);
  Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, path);
  file.close();
}

std::string snapshotName(int number)
{
  char name[32];
  std::snprintf(name, sizeof name, "t%05d", number);
  return name;
}

void keepSnapshots(const std::string& path, int count)
{
  const Silence silence;
  refuseDamage(path, count);
  const Handle access(accessTo(H5F_LIBVER_V110), H5Pclose, path);
  Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, access), H5Fclose, path);
  for (int k = count; H5Lexists(file, snapshotName(k).c_str(), H5P_DEFAULT) > 0; ++k)
    if (!Silence::unlessDamaged(H5Ldelete(file, snapshotName(k).c_str(), H5P_DEFAULT) >= 0))
      throw OutputError("its later frame " + snapshotName(k) + " can't be removed");
  file.close();
}

void appendSnapshot(const std::string& path, const std::string& group, const Snapshot& snapshot,
                    const Ranks& ranks)
{
  const Silence silence;
  std::unique_ptr<Unlinked> made;
  onFirstRank<OutputError>(ranks,
                           [&]
                           {
                             reserve(path, snapshot);
                             made = std::make_unique<Unlinked>(path, snapshot);
                           });
  for (const OutputMesh& mesh : snapshot.meshes)
    for (const DataSet& data : mesh.data)
    {
      const std::string failure = data.integer ? writeTable(ranks, made.get(), mesh, data, data.whole)
                                               : writeTable(ranks, made.get(), mesh, data, data.real);
      onFirstRank<OutputError>(ranks,
                               [&]
                               {
                                 if (!failure.empty())
                                   throw OutputError(failure);
                               });
    }
  onFirstRank<OutputError>(ranks, [&] { made->link(group); });
}

} // namespace Rhegma
