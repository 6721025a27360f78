#include "output/Hdf5.hpp"

#include "output/Hdf5Handle.hpp"

#include <cstdio>

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

void writeTable(hid_t group, const DataSet& data, const std::string& path)
{
  const hsize_t extent[2] = {data.rows(), static_cast<hsize_t>(data.columns)};
  const int rank = data.columns == 1 ? 1 : 2;
  const Handle space(H5Screate_simple(rank, extent, nullptr), H5Sclose, path);
  const Handle set(H5Dcreate2(group, data.name.c_str(), data.integer ? H5T_STD_I32LE : H5T_IEEE_F64LE, space,
                              H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                   H5Dclose, path);
  const void* values = data.integer ? static_cast<const void*>(data.whole.data()) : data.real.data();
  if (data.rows() > 0)
    set.require(H5Dwrite(set, data.integer ? H5T_NATIVE_INT : H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL,
                         H5P_DEFAULT, values));
}

Handle makeGroup(hid_t where, const std::string& name, const std::string& path)
{
  return Handle(H5Gcreate2(where, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, path);
}

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
      throw OutputError(path + " has no snapshot " + snapshotName(k));
  for (int k = count; H5Lexists(file, snapshotName(k).c_str(), H5P_DEFAULT) > 0; ++k)
    file.require(H5Ldelete(file, snapshotName(k).c_str(), H5P_DEFAULT));
  file.close();
}

void appendSnapshot(const std::string& path, const std::string& group, const Snapshot& snapshot)
{
  const Silence silence;
  Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, path);
  {
    // All of the snapshot goes out before the file knows of it, so that a run that is killed meanwhile leaves
    // a file that can be read.
    const Handle top(H5Gcreate_anon(file, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, path);
    writeTime(top, snapshot.time, path);
    for (const Mesh& mesh : snapshot.meshes)
    {
      const Handle inner = makeGroup(top, mesh.name, path);
      for (const DataSet& data : mesh.data)
        writeTable(inner, data, path);
    }
    file.require(H5Fflush(file, H5F_SCOPE_GLOBAL));
    file.require(H5Olink(top, file, group.c_str(), H5P_DEFAULT, H5P_DEFAULT));
    file.require(H5Fflush(file, H5F_SCOPE_GLOBAL));
  }
  file.close();
}

} // namespace Rhegma
