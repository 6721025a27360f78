#pragma once
/// HDF5's identifiers as objects that close themselves and throw.

#include "base/OutputError.hpp"

#include <hdf5.h>
#include <string>

namespace Rhegma
{

/// Switches off the error messages of HDF5; errors become exceptions here.
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

/// The message for the user.
inline std::string unwritable(const std::string& path)
{
  return path + " can't be written; is the disk full or the file open elsewhere?";
}

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

  /// Throws when HDF5 reports an error.
  void require(herr_t status) const
  {
    if (status < 0)
      fail();
  }

  /// Closes, which writes the remaining data.
  void close()
  {
    const herr_t status = close_(id_);
    id_ = -1;
    require(status);
  }

private:
  [[noreturn]] void fail() const { throw OutputError(unwritable(path_)); }

  hid_t id_;
  Close close_;
  std::string path_;
};

} // namespace Rhegma
