#include "checkpoint/CheckpointFile.hpp"

#include "base/SpecialFile.hpp"
#include "files/Hdf5Handle.hpp"
#include "files/Sync.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>
#include <set>
#include <stdexcept>
#include <unistd.h>
#include <vector>
#include <zlib.h>

namespace Rhegma
{

namespace
{

constexpr std::size_t blockSize = 512;
/// Line ends and a byte with its highest bit set reveal a transfer as text.
constexpr unsigned char magic[16] = {0x89, 'R', 'H', 'E',  'G',  'M',  'A',  ' ',
                                     'c',  'h', 'k', '\r', '\n', 0x1a, '\n', 0};
constexpr std::size_t schemaAt = 16, bodyCrcAt = 20, bodyLengthAt = 24, blockCrcAt = blockSize - 4;

using Block = std::array<unsigned char, blockSize>;

void put(Block& block, std::size_t at, int bytes, std::uint64_t value)
{
  for (int k = 0; k < bytes; ++k)
    block[at + k] = static_cast<unsigned char>(value >> (8 * k));
}

std::uint64_t take(const Block& block, std::size_t at, int bytes)
{
  std::uint64_t value = 0;
  for (int k = bytes - 1; k >= 0; --k)
    value = value << 8 | block[at + k];
  return value;
}

std::uint64_t blockCrc(const Block& block) { return crc32(0, block.data(), blockCrcAt); }

struct CloseFile
{
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

struct Body
{
  std::uint64_t length = 0, crc = crc32(0, nullptr, 0);

  void add(const unsigned char* bytes, std::size_t count)
  {
    constexpr std::size_t atOnce = 1 << 30; // zlib counts in 32 bits
    length += count;
    for (; count > 0; bytes += std::min(count, atOnce), count -= std::min(count, atOnce))
      crc = crc32(crc, bytes, static_cast<uInt>(std::min(count, atOnce)));
  }
};

/// Length and checksum of the data after the block; the file is read up to there.
Body readBody(std::FILE* file)
{
  Body body;
  std::vector<unsigned char> piece(1 << 20);
  for (;;)
  {
    const std::size_t got = std::fread(piece.data(), 1, piece.size(), file);
    if (got == 0)
      return body;
    body.add(piece.data(), got);
  }
}

[[noreturn]] void cantWrite(const std::string& path, int reason)
{
  throw OutputError(path + " can't be written: " + std::strerror(reason));
}

Block blockFor(const std::vector<unsigned char>& image)
{
  Body body;
  body.add(image.data(), image.size());
  Block block{};
  std::copy(std::begin(magic), std::end(magic), block.begin());
  put(block, schemaAt, 4, checkpointSchema);
  put(block, bodyCrcAt, 4, body.crc);
  put(block, bodyLengthAt, 8, body.length);
  put(block, blockCrcAt, 4, blockCrc(block));
  return block;
}

/// Writes a file and synchronises it to the disk.
void writeThrough(const std::string& path, const std::vector<unsigned char>& image)
{
  File file(std::fopen(path.c_str(), "wb"));
  if (!file)
    cantWrite(path, errno);
  std::setvbuf(file.get(), nullptr, _IONBF, 0);
  const Block block = blockFor(image);
  const bool good = std::fwrite(block.data(), 1, blockSize, file.get()) == blockSize &&
                    std::fwrite(image.data(), 1, image.size(), file.get()) == image.size() &&
                    fsync(fileno(file.get())) == 0;
  const int reason = errno;
  if (!good || std::fclose(file.release()) != 0)
    cantWrite(path, good ? errno : reason);
}

hid_t typeInFile(RecordTable::Type type)
{
  return type == RecordTable::Type::Real      ? H5T_IEEE_F64LE
         : type == RecordTable::Type::Integer ? H5T_STD_I32LE
         : type == RecordTable::Type::Long    ? H5T_STD_I64LE
                                              : H5T_STD_I8LE;
}

hid_t typeInMemory(RecordTable::Type type)
{
  return type == RecordTable::Type::Real      ? H5T_NATIVE_DOUBLE
         : type == RecordTable::Type::Integer ? H5T_NATIVE_INT32
         : type == RecordTable::Type::Long    ? H5T_NATIVE_INT64
                                              : H5T_NATIVE_INT8;
}

std::string groupOf(const std::string& path)
{
  const std::size_t end = path.rfind('/');
  return end == std::string::npos ? "/" : "/" + path.substr(0, end);
}

std::string nameOf(const std::string& path)
{
  const std::size_t end = path.rfind('/');
  return end == std::string::npos ? path : path.substr(end + 1);
}

/// Makes a group and its parents unless they exist.
void makeGroup(hid_t file, const std::string& group, std::set<std::string>& made, const std::string& path)
{
  for (std::size_t end = 0; end != std::string::npos;)
  {
    end = group.find('/', end + 1);
    const std::string part = group.substr(0, end);
    if (part != "/" && made.insert(part).second)
      Handle(H5Gcreate2(file, part.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, path).close();
  }
}

void writeNumber(hid_t group, const std::string& name, const RecordTable& table, const std::string& path)
{
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, path);
  const Handle attribute(
      H5Acreate2(group, name.c_str(), typeInFile(table.type), space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
      path);
  attribute.require(H5Awrite(attribute, typeInMemory(table.type), table.bytes.data()));
}

void writeSet(hid_t group, const std::string& name, const RecordTable& table, const std::string& path)
{
  const Handle plain(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, path);
  plain.require(H5Pset_obj_track_times(plain, false)); // the same state makes the same file
  const std::vector<hsize_t> extent(table.extent.begin(), table.extent.end());
  const Handle space(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), H5Sclose,
                     path);
  const Handle set(
      H5Dcreate2(group, name.c_str(), typeInFile(table.type), space, H5P_DEFAULT, plain, H5P_DEFAULT),
      H5Dclose, path);
  if (!table.bytes.empty())
    set.require(H5Dwrite(set, typeInMemory(table.type), H5S_ALL, H5S_ALL, H5P_DEFAULT, table.bytes.data()));
}

void writeTables(hid_t file, const std::string& path, const Record& record)
{
  std::set<std::string> made;
  for (const auto& [where, table] : record)
  {
    makeGroup(file, groupOf(where), made, path);
    const Handle group(H5Gopen2(file, groupOf(where).c_str(), H5P_DEFAULT), H5Gclose, path);
    if (table.extent.empty())
      writeNumber(group, nameOf(where), table, path);
    else
      writeSet(group, nameOf(where), table, path);
  }
}

/// The bytes of an HDF5 file. It is made in memory: if the disk is full HDF5 can't close a file, and aborts
/// the program later.
std::vector<unsigned char> hdf5Image(const std::string& path, const Record& record)
{
  const Silence silence;
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, path);
  constexpr std::size_t growth = 4 << 20;
  access.require(H5Pset_fapl_core(access, growth, 0));
  Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, path);
  writeTables(file, path, record);
  file.require(H5Fflush(file, H5F_SCOPE_GLOBAL));
  std::vector<unsigned char> image(std::max<ssize_t>(H5Fget_file_image(file, nullptr, 0), 0));
  if (image.empty() || H5Fget_file_image(file, image.data(), image.size()) < 0)
    throw std::bad_alloc();
  file.close();
  return image;
}

[[noreturn]] void refuse(const std::string& path, const std::string& why)
{
  throw std::invalid_argument("the checkpoint " + path + " " + why);
}

/// A file that is being read.
struct Source
{
  std::string path;
  std::uint64_t length; ///< bytes: no table of it can have more
};

/// Largest nesting of groups; more than any checkpoint has.
constexpr int mostGroups = 16;

RecordTable::Type typeOf(hid_t type)
{
  const bool real = H5Tget_class(type) == H5T_FLOAT;
  const std::size_t size = H5Tget_size(type);
  return real        ? RecordTable::Type::Real
         : size == 8 ? RecordTable::Type::Long
         : size == 4 ? RecordTable::Type::Integer
                     : RecordTable::Type::Byte;
}

/// Sets type and extents of a table and allocates it.
void shape(RecordTable& table, hid_t type, hid_t space, const Source& from)
{
  table.type = typeOf(type);
  std::vector<hsize_t> extent(std::max(H5Sget_simple_extent_ndims(space), 0));
  H5Sget_simple_extent_dims(space, extent.data(), nullptr);
  table.extent.assign(extent.begin(), extent.end());
  std::uint64_t numbers = 1;
  for (const hsize_t count : extent)
  {
    if (count > 0 && numbers > from.length / count)
      refuse(from.path, "is damaged: a table in it is larger than the file; use an older one");
    numbers *= count;
  }
  table.bytes.resize(table.size());
}

/// Reads the attributes of a group.
void readNumbers(hid_t group, const std::string& prefix, const Source& from, Record& record)
{
  for (hsize_t k = 0;; ++k)
  {
    const hid_t id = H5Aopen_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, k, H5P_DEFAULT, H5P_DEFAULT);
    if (id < 0)
      return;
    const Handle attribute(id, H5Aclose, from.path);
    char name[256];
    H5Aget_name(attribute, sizeof name, name);
    const Handle type(H5Aget_type(attribute), H5Tclose, from.path),
        space(H5Aget_space(attribute), H5Sclose, from.path);
    RecordTable& table = record[prefix + name];
    shape(table, type, space, from);
    attribute.require(H5Aread(attribute, typeInMemory(table.type), table.bytes.data()));
  }
}

void readSet(hid_t set, RecordTable& table, const Source& from)
{
  const Handle type(H5Dget_type(set), H5Tclose, from.path), space(H5Dget_space(set), H5Sclose, from.path);
  shape(table, type, space, from);
  if (!table.bytes.empty() &&
      H5Dread(set, typeInMemory(table.type), H5S_ALL, H5S_ALL, H5P_DEFAULT, table.bytes.data()) < 0)
    throw OutputError(from.path);
}

void readGroup(hid_t group, const std::string& prefix, const Source& from, Record& record, int depth = 0)
{
  if (depth > mostGroups) // a damaged group may contain itself
    throw OutputError(from.path);
  readNumbers(group, prefix, from, record);
  H5G_info_t info;
  if (H5Gget_info(group, &info) < 0)
    throw OutputError(from.path);
  for (hsize_t k = 0; k < info.nlinks; ++k)
  {
    char name[256];
    if (H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, k, name, sizeof name, H5P_DEFAULT) < 0)
      throw OutputError(from.path);
    const Handle item(H5Oopen(group, name, H5P_DEFAULT), H5Oclose, from.path);
    if (H5Iget_type(item) == H5I_GROUP)
      readGroup(item, prefix + name + "/", from, record, depth + 1);
    else
      readSet(item, record[prefix + name], from);
  }
}

/// Throws where the file differs from the one that writeCheckpoint wrote.
void verify(const std::string& path)
{
  std::error_code none;
  if (std::filesystem::is_directory(path, none))
    refuse(path, "can't be read: it is a folder; write the path of the file in it");
  // To open a pipe waits for a program that writes into it, and no checkpoint comes through one.
  if (const std::string kind = kindOfSpecialFile(std::filesystem::status(path, none)); !kind.empty())
    refuse(path, "is " + kind + "; write the path of a checkpoint.h5");
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file)
    refuse(path, std::string("can't be read: ") + std::strerror(errno));
  Block block{};
  const std::size_t got = std::fread(block.data(), 1, blockSize, file.get());
  if (got < sizeof magic || std::memcmp(block.data(), magic, sizeof magic) != 0)
    refuse(path, "is not a checkpoint of rhegma; write the path of a checkpoint.h5 after --restart");
  if (got < blockSize)
    refuse(path, "is truncated: it has fewer than the " + std::to_string(blockSize) +
                     " bytes of a header; use an older one");
  if (take(block, blockCrcAt, 4) != blockCrc(block))
    refuse(path, "is damaged: its first " + std::to_string(blockSize) +
                     " bytes have changed since it was written; use an older one");
  const std::uint64_t schema = take(block, schemaAt, 4);
  if (schema != checkpointSchema)
    refuse(path, "is of schema " + std::to_string(schema) + " and this program reads schema " +
                     std::to_string(checkpointSchema) + "; restart with the version that wrote it");
  const Body body = readBody(file.get());
  const std::uint64_t length = take(block, bodyLengthAt, 8);
  if (std::ferror(file.get()) != 0)
    refuse(path, "can't be read to its end");
  if (body.length < length)
    refuse(path, "is truncated: " + std::to_string(body.length + blockSize) + " of " +
                     std::to_string(length + blockSize) + " bytes of a header; use an older one");
  if (body.length > length || body.crc != take(block, bodyCrcAt, 4))
    refuse(path, "is damaged: its content has changed since it was written; use an older one");
}

} // namespace

void writeCheckpoint(const std::string& path, const Record& record)
{
  const std::string part = path + ".part";
  try
  {
    writeThrough(part, hdf5Image(path, record));
    if (std::rename(part.c_str(), path.c_str()) != 0)
      cantWrite(path, errno);
  }
  catch (...)
  {
    std::remove(part.c_str());
    throw;
  }
  syncFolderOf(path);
}

Record readCheckpoint(const std::string& path)
{
  verify(path);
  const Silence silence;
  Record record;
  try
  {
    const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, path);
    const Handle top(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose, path);
    readGroup(top, "", {path, std::filesystem::file_size(path)}, record);
  }
  catch (const OutputError&)
  {
    refuse(path, "can't be read by HDF5, though its checksum is right");
  }
  return record;
}

} // namespace Rhegma
