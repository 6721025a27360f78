#pragma once
/// The content of a checkpoint in memory.

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace Rhegma
{

/// A table of numbers of one type, row by row; without extents one number. A text is a row of characters.
struct RecordTable
{
  enum class Type
  {
    Real,    ///< double
    Integer, ///< int of 32 bits
    Long,    ///< int of 64 bits
    Byte     ///< char, and text
  };
  Type type = Type::Real;
  std::vector<std::size_t> extent;
  std::vector<char> bytes;

  static std::size_t sizeOf(Type type) { return type == Type::Byte ? 1 : type == Type::Integer ? 4 : 8; }
  /// Bytes by the extents.
  std::size_t size() const
  {
    std::size_t all = sizeOf(type);
    for (const std::size_t n : extent)
      all *= n;
    return all;
  }
  bool operator==(const RecordTable& other) const
  {
    return type == other.type && extent == other.extent && bytes == other.bytes;
  }
};

/// Tables by path, such as "particles/velocity".
using Record = std::map<std::string, RecordTable>;

} // namespace Rhegma
