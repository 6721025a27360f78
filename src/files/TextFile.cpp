#include "files/TextFile.hpp"

#include "base/OutputError.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace Rhegma
{

void replaceFile(const std::string& path, const std::string& text)
{
  const std::string temporary = path + ".part";
  std::FILE* file = std::fopen(temporary.c_str(), "wb");
  bool good = file != nullptr && std::fwrite(text.data(), 1, text.size(), file) == text.size();
  int reason = errno;
  if (file != nullptr && std::fclose(file) != 0)
  {
    reason = errno;
    good = false;
  }
  if (good && std::rename(temporary.c_str(), path.c_str()) != 0)
  {
    reason = errno;
    good = false;
  }
  if (good)
    return;
  if (file != nullptr)
    std::remove(temporary.c_str());
  throw OutputError(path + " can't be written: " + std::strerror(reason));
}

} // namespace Rhegma
