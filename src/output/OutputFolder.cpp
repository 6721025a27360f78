#include "output/OutputFolder.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <unistd.h>
#include <vector>

namespace Rhegma
{

namespace
{

[[noreturn]] void refuse(const std::string& folder, const std::string& why)
{
  throw std::invalid_argument("the output folder " + folder + " can't be used: " + why +
                              "; choose another folder with --output");
}

/// Makes a file with a name of its own and removes it.
void tryToWrite(const std::string& folder)
{
  const std::string pattern = folder + "/.rhegma-XXXXXX";
  std::vector<char> name(pattern.begin(), pattern.end());
  name.push_back('\0');
  const int file = mkstemp(name.data());
  if (file < 0)
    refuse(folder, std::string("no file can be written there (") + std::strerror(errno) + ")");
  close(file);
  unlink(name.data());
}

} // namespace

std::string defaultOutputFolder(const std::string& scene)
{
  std::filesystem::path path(scene);
  if (path.extension() == ".xml")
    path.replace_extension();
  return path.string() + ".out";
}

std::string makeOutputFolder(const std::string& folder)
{
  if (folder.empty())
    throw std::invalid_argument("the output folder has no name; write one after --output");
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  std::error_code unreadable;
  if (!std::filesystem::is_directory(folder, unreadable))
    refuse(folder, error ? error.message() : "a file has that name");
  tryToWrite(folder);
  return folder;
}

namespace
{

const char* const results[] = {"summary.json", "history.csv", "fields.xdmf", "fields.h5", "checkpoint.h5"};

void removeFrom(const std::string& folder, const std::string& name)
{
  std::error_code ignored; // a file that can't be removed can't be written either, which is reported
  std::filesystem::remove(std::filesystem::path(folder) / name, ignored);
}

} // namespace

void removeOldSummary(const std::string& folder)
{
  removeFrom(folder, "summary.json");
  for (const char* name : results)
    removeFrom(folder, std::string(name) + ".part");
}

void removeOldResults(const std::string& folder)
{
  removeOldSummary(folder);
  for (const char* name : results)
    removeFrom(folder, name);
}

} // namespace Rhegma
