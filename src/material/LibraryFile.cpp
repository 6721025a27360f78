#include "material/LibraryFile.hpp"

#include "base/FileChecksum.hpp"
#include "material/LoadedLaw.hpp"

#include <array>
#include <dlfcn.h>
#include <filesystem>
#include <fstream>
#ifdef __GLIBC__
#include <elf.h>
#include <link.h>
#endif

namespace Rhegma
{

namespace
{

/// The start of a file in the format ELF: width of an address, order of bytes and kind of processor.
struct ElfHead
{
  std::array<char, 20> bytes{};
  bool isElf = false;

  explicit ElfHead(const std::string& file)
  {
    std::ifstream in(file, std::ios::binary);
    in.read(bytes.data(), bytes.size());
    isElf = in && bytes[0] == '\x7f' && bytes[1] == 'E' && bytes[2] == 'L' && bytes[3] == 'F';
  }
  bool sameMachine(const ElfHead& other) const
  {
    return bytes[4] == other.bytes[4] && bytes[5] == other.bytes[5] && bytes[18] == other.bytes[18] &&
           bytes[19] == other.bytes[19];
  }
};

} // namespace

void checkLibraryFile(const std::string& file)
{
  const std::filesystem::path path = std::filesystem::absolute(file);
  const std::string remedy =
      "; give the path of a shared library, relative to the scene, as rhegma-law writes it.";
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path, ignored);
  if (!std::filesystem::exists(status))
    throw LawRefused("Library File", "there is no file " + path.string() + remedy);
  if (!std::filesystem::is_regular_file(status))
    throw LawRefused("Library File",
                     path.string() +
                         (std::filesystem::is_directory(status) ? " is a folder" : " is a pipe or a device") +
                         remedy);
  const ElfHead mine("/proc/self/exe"), its(path.string());
  if (mine.isElf && its.isElf && !its.sameMachine(mine))
    throw LawRefused("Library File", path.string() + " is for another kind of machine than this one; compile "
                                                     "the law again with rhegma-law on this machine.");
}

void* openLibrary(const std::string& file)
{
  checkLibraryFile(file);
  keepChecksum(file);
  if (void* library = dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL))
    return library;
  const char* why = dlerror();
  throw LawRefused("Library File", std::string("can't be loaded (") + (why != nullptr ? why : "no reason") +
                                       "); give a shared library for this machine, as rhegma-law writes it.");
}

bool isVariable([[maybe_unused]] void* symbol)
{
#ifdef __GLIBC__
  Dl_info info;
  const ElfW(Sym)* entry = nullptr;
  if (dladdr1(symbol, &info, reinterpret_cast<void**>(const_cast<ElfW(Sym)**>(&entry)), RTLD_DL_SYMENT) ==
          0 ||
      entry == nullptr || info.dli_saddr != symbol)
    return false;
  const int kind = ELF64_ST_TYPE(entry->st_info); // the same bits as ELF32_ST_TYPE
  return kind == STT_OBJECT || kind == STT_TLS || kind == STT_COMMON;
#else
  return false;
#endif
}

} // namespace Rhegma
