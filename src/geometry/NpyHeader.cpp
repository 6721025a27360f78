#include "geometry/NpyHeader.hpp"

#include <algorithm>
#include <istream>
#include <stdexcept>
#include <string>

namespace Rhegma::Geometry
{

namespace
{

/// What follows a key of the dictionary in the header, without blanks before it.
std::string after(const std::string& text, const std::string& key)
{
  std::size_t at = text.find("'" + key + "'");
  at = at == std::string::npos ? at : text.find(':', at);
  at = at == std::string::npos ? at : text.find_first_not_of(' ', at + 1);
  if (at == std::string::npos)
    throw std::invalid_argument("its header has no \"" + key + "\"; write the file with numpy.save");
  return text.substr(at);
}

void readType(const std::string& text, NpyHeader& header)
{
  const std::size_t end = text.empty() ? std::string::npos : text.find(text[0], 1);
  const bool isText = !text.empty() && (text[0] == '\'' || text[0] == '"') && end != std::string::npos;
  const std::string type = isText ? text.substr(1, end - 1) : "";
  const char kind = type.size() == 3 ? type[1] : ' ', size = type.size() == 3 ? type[2] : ' ';
  const bool isInteger =
      (kind == 'u' || kind == 'i') && (size == '1' || size == '2' || size == '4' || size == '8');
  if (!isInteger && !(kind == 'b' && size == '1'))
    throw std::invalid_argument(
        (isText ? "its numbers are of the type \"" + type + "\"" : std::string("its elements are records")) +
        ", but values of voxels are integers; convert the array, such as with image.astype(\"uint8\") in "
        "NumPy");
  header.isSigned = kind == 'i';
  header.isBigEndian = type[0] == '>';
  header.bytes = static_cast<std::size_t>(size - '0');
}

void readShape(const std::string& text, NpyHeader& header)
{
  const std::size_t end = text.find(')');
  if (text.empty() || text[0] != '(' || end == std::string::npos)
    throw std::invalid_argument("its header has no shape; write the file with numpy.save");
  std::int64_t number = -1;
  for (const char c : text.substr(1, end))
  {
    const bool isDigit = c >= '0' && c <= '9';
    if (isDigit && number < 100000000000000000)
      number = std::max<std::int64_t>(number, 0) * 10 + (c - '0');
    else if (!isDigit && number >= 0)
    {
      header.shape.push_back(number);
      number = -1;
    }
  }
}

} // namespace

NpyHeader readNpyHeader(std::istream& file)
{
  const std::string magic = "\x93NUMPY";
  unsigned char start[12] = {};
  file.read(reinterpret_cast<char*>(start), 10);
  if (!file || std::string(start, start + 6) != magic)
    throw std::invalid_argument(
        "it is no .npy file; write an array with numpy.save, or name a picture that ends in .png or .tif");
  std::size_t length = start[8] + 256u * start[9], begin = 10;
  if (start[6] > 1)
  {
    file.read(reinterpret_cast<char*>(start + 10), 2);
    length += 65536u * (start[10] + 256u * start[11]);
    begin = 12;
  }
  constexpr std::size_t most = 1000000;
  std::string text(std::min(length, most), ' ');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!file || length > most)
    throw std::invalid_argument("its header is cut off; write the file again");
  NpyHeader header;
  header.dataBegin = begin + length;
  readType(after(text, "descr"), header);
  readShape(after(text, "shape"), header);
  if (after(text, "fortran_order").compare(0, 4, "True") == 0)
    throw std::invalid_argument("it is in Fortran order; save numpy.ascontiguousarray(image), which has the "
                                "same axes in C order");
  return header;
}

} // namespace Rhegma::Geometry
