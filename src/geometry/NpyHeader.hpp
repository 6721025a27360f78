#pragma once
/// What the header of a .npy file says.

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <vector>

namespace Rhegma::Geometry
{

/// An array of integers in C order.
struct NpyHeader
{
  std::vector<std::int64_t> shape;
  std::size_t bytes = 1;     ///< of a number
  bool isSigned = false;     ///< two's complement
  bool isBigEndian = false;  ///< the most significant byte is the first one
  std::size_t dataBegin = 0; ///< position of the first number in the file
};

/// Reads a header (format versions 1 to 3 of NumPy).
/// \throws std::invalid_argument where the file is no array of integers in C order
NpyHeader readNpyHeader(std::istream& file);

} // namespace Rhegma::Geometry
