#include "base/FileChecksum.hpp"

#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <zlib.h>

namespace Rhegma
{

namespace
{

std::map<std::string, std::string>& keptChecksums()
{
  static std::map<std::string, std::string> all;
  return all;
}

std::string checksumNow(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  if (!in)
    return {};
  uLong sum = crc32(0, nullptr, 0);
  std::array<char, 65536> bytes;
  while (in.read(bytes.data(), bytes.size()) || in.gcount() > 0)
    sum = crc32(sum, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(in.gcount()));
  char text[17];
  std::snprintf(text, sizeof text, "%08lx", static_cast<unsigned long>(sum));
  return text;
}

} // namespace

void keepChecksum(const std::string& file) { keptChecksums()[file] = checksumNow(file); }

std::string fileChecksum(const std::string& file)
{
  const auto found = keptChecksums().find(file);
  return found != keptChecksums().end() ? found->second : checksumNow(file);
}

} // namespace Rhegma
