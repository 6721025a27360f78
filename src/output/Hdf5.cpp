#include "output/Hdf5.hpp"

#include "output/OutputError.hpp"

#include <cstdio>
#include <hdf5.h>

namespace Rhegma
{

namespace
{

/// HDF5 prints its errors unless told not to; here they become exceptions.
class Silence
{
public:
  Silence()
  {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Silence() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

/// An identifier of HDF5 that closes itself.
class Handle
{
public:
  using Close = herr_t (*)(hid_t);

  Handle(hid_t id, Close closer, const std::string& path) : id_(id), close_(closer), path_(path)
  {
    if (id_ < 0)
      fail();
  }
  ~Handle()
  {
    if (id_ >= 0)
      close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  operator hid_t() const { return id_; }

  /// Throws when HDF5 says that something went wrong.
  void require(herr_t status) const
  {
    if (status < 0)
      fail();
  }

  /// Closes, which is when the last of the data goes out.
  void close()
  {
    const herr_t status = close_(id_);
    id_ = -1;
    require(status);
  }

private:
  [[noreturn]] void fail() const
  {
    throw OutputError(path_ + " can't be written; is the disk full or the file open elsewhere?");
  }

  hid_t id_;
  Close close_;
  std::string path_;
};

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
