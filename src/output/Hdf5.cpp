#include "output/Hdf5.hpp"

#include "files/Hdf5Handle.hpp"
#include "output/WriteParts.hpp"
#include "parallel/FirstRank.hpp"

#include <cstdio>
#include <memory>

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

/// An empty table with contiguous layout.
Handle makeTable(hid_t group, const DataSet& data, const std::string& path)
{
  const hsize_t extent[2] = {data.rowsOfAll(), static_cast<hsize_t>(data.columns)};
  const Handle space(H5Screate_simple(data.columns == 1 ? 1 : 2, extent, nullptr), H5Sclose, path);
  const Handle now(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, path);
  now.require(H5Pset_alloc_time(now, H5D_ALLOC_TIME_EARLY));
  now.require(H5Pset_fill_time(now, H5D_FILL_TIME_NEVER));
  return Handle(H5Dcreate2(group, data.name.c_str(), data.integer ? H5T_NATIVE_INT : H5T_NATIVE_DOUBLE, space,
                           H5P_DEFAULT, now, H5P_DEFAULT),
                H5Dclose, path);
}

void writeTable(hid_t set, const DataSet& data, const std::string& path)
{
  if (data.rows() > 0 && H5Dwrite(set, data.integer ? H5T_NATIVE_INT : H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL,
                                  H5P_DEFAULT, valuesOf(data)) < 0)
    throw OutputError(unwritable(path));
}

/// A snapshot that is written before it is linked into the file, so that a run killed meanwhile leaves a
/// readable file.
class Unlinked
{
public:
  /// \param parts whether rows are written later; else they are now
  Unlinked(const std::string& path, const Snapshot& snapshot, bool parts)
      : file_(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, path),
        top_(H5Gcreate_anon(file_, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, path)
  {
    writeTime(top_, snapshot.time, path);
    for (const OutputMesh& mesh : snapshot.meshes)
    {
      const Handle inner(H5Gcreate2(top_, mesh.name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
                         path);
      for (const DataSet& data : mesh.data)
      {
        const Handle table = makeTable(inner, data, path);
        if (!parts)
          writeTable(table, data, path);
        offsets_.push_back(data.rowsOfAll() > 0 ? static_cast<double>(H5Dget_offset(table)) : 0.0);
      }
    }
    file_.require(H5Fflush(file_, H5F_SCOPE_GLOBAL));
    if (parts)
      reserve(path, snapshot, offsets_);
  }

  void link(const std::string& group)
  {
    file_.require(H5Olink(top_, file_, group.c_str(), H5P_DEFAULT, H5P_DEFAULT));
    file_.require(H5Fflush(file_, H5F_SCOPE_GLOBAL));
    top_.close();
    file_.close();
  }

  /// Byte of the file at which each table begins, mesh after mesh; below 2^53, so that they are exact.
  const std::vector<double>& offsets() const { return offsets_; }

private:
  Handle file_, top_;
  std::vector<double> offsets_;
};

} // namespace

void createHdf5(const std::string& path)
{
  const Silence silence;
  std::remove(path.c_str());
  Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose, path);
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
  Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, path);
  for (int k = 0; k < count; ++k)
    if (H5Lexists(file, snapshotName(k).c_str(), H5P_DEFAULT) <= 0)
      throw OutputError(path + " has no output " + snapshotName(k));
  for (int k = count; H5Lexists(file, snapshotName(k).c_str(), H5P_DEFAULT) > 0; ++k)
    file.require(H5Ldelete(file, snapshotName(k).c_str(), H5P_DEFAULT));
  file.close();
}

void appendSnapshot(const std::string& path, const std::string& group, const Snapshot& snapshot,
                    const Ranks& ranks)
{
  const Silence silence;
  std::unique_ptr<Unlinked> made;
  std::vector<double> offsets;
  for (const OutputMesh& mesh : snapshot.meshes)
    offsets.resize(offsets.size() + mesh.data.size());
  onFirstRank<OutputError>(ranks,
                           [&]
                           {
                             made = std::make_unique<Unlinked>(path, snapshot, ranks.many());
                             offsets = made->offsets();
                           });
  if (ranks.many())
  {
    ranks.sum(offsets.data(), static_cast<int>(offsets.size())); // zeros on all but the first
    writeParts(ranks, path, snapshot, offsets);
  }
  onFirstRank<OutputError>(ranks, [&] { made->link(group); });
}

} // namespace Rhegma
