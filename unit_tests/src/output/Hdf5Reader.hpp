#pragma once
/// Reads back what was written.

#include <hdf5.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace Rhegma
{

class Hdf5Reader
{
public:
  explicit Hdf5Reader(const std::string& path) : file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT))
  {
    if (file_ < 0)
      throw std::runtime_error(path + " can't be read");
  }
  ~Hdf5Reader() { H5Fclose(file_); }
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;

  bool has(const std::string& name) const { return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0; }

  double attribute(const std::string& object, const std::string& name) const
  {
    const hid_t attribute = H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    double value = 0.0;
    const herr_t status = H5Aread(attribute, H5T_NATIVE_DOUBLE, &value);
    H5Aclose(attribute);
    if (status < 0)
      throw std::runtime_error("no attribute " + name);
    return value;
  }

  std::vector<std::size_t> extents(const std::string& name) const
  {
    const hid_t set = H5Dopen2(file_, name.c_str(), H5P_DEFAULT);
    const hid_t space = H5Dget_space(set);
    std::vector<hsize_t> extent(H5Sget_simple_extent_ndims(space));
    H5Sget_simple_extent_dims(space, extent.data(), nullptr);
    H5Sclose(space);
    H5Dclose(set);
    return {extent.begin(), extent.end()};
  }

  std::vector<double> numbers(const std::string& name) const
  {
    std::size_t size = 1;
    for (const std::size_t n : extents(name))
      size *= n;
    std::vector<double> values(size);
    const hid_t set = H5Dopen2(file_, name.c_str(), H5P_DEFAULT);
    const herr_t status = H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(set);
    if (status < 0)
      throw std::runtime_error("no numbers " + name);
    return values;
  }

private:
  hid_t file_;
};

} // namespace Rhegma
