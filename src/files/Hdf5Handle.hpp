#pragma once
/// HDF5's identifiers as objects that close themselves and throw.

#include "base/OutputError.hpp"

#include <hdf5.h>
#include <string>

namespace Rhegma
{

/// Switches off the error messages of HDF5; errors become exceptions here.
///
/// What HDF5 could not read because it is damaged it may not be able to close either, and prints that when
/// the program ends. After damage it therefore stays silent.
class Silence
{
public:
  Silence()
  {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Silence()
  {
    if (!stays_)
      H5Eset_auto2(H5E_DEFAULT, function_, data_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

  /// To be called with what shows damage: HDF5 then stays silent. \param whole whether there is none \return
  /// the same
  static bool unlessDamaged(bool whole)
  {
    stays_ = stays_ || !whole;
    return whole;
  }

private:
  inline static bool stays_ = false;
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

/// The message for the user.
inline std::string unwritable(const std::string& path)
{
  return path + " can't be written; is the disk full or the file open elsewhere?";
}

/// Access to a file that HDF5 does not lock: run.lock keeps other runs out, and a program that reads the
/// file, or has it open for writing, must not change what a run does.
inline hid_t accessWithoutLock()
{
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
#if H5_VERSION_GE(1, 10, 7)
  H5Pset_file_locking(access, 0, 1);
#endif
  return access;
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
      Silence::unlessDamaged(close_(id_) >= 0);
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
    const bool closed = Silence::unlessDamaged(close_(id_) >= 0);
    id_ = -1;
    if (!closed)
      fail();
  }

private:
  [[noreturn]] void fail() const { throw OutputError(unwritable(path_)); }

  hid_t id_;
  Close close_;
  std::string path_;
};

} // namespace Rhegma
