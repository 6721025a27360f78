#include "output/OutputFolder.hpp"

#include "files/Hdf5Handle.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
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

/// The beginning of a file; all of it where it is not large.
std::string beginningOf(const std::filesystem::path& path)
{
  std::ifstream in(path, std::ios::binary);
  std::string text(1 << 20, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

bool startsWith(const std::string& text, const std::string& start)
{
  return text.compare(0, start.size(), start) == 0;
}

/// Whether a file of HDF5 holds something, but no first frame.
bool holdsOtherThings(const std::string& path)
{
  const Silence silence;
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  H5G_info_t info{};
  const bool other = file >= 0 && H5Gget_info(file, &info) >= 0 && info.nlinks > 0 &&
                     H5Lexists(file, "t00000", H5P_DEFAULT) <= 0;
  if (file >= 0)
    H5Fclose(file);
  return other; // what a kill left need not open
}

/// Whether a run may have written a file. \param text its beginning
bool isOfRun(const std::string& path, const std::string& name, const std::string& text)
{
  if (text.empty()) // cut off at once
    return true;
  if (name == "history.csv")
    return startsWith(text, "time");
  if (name == "fields.h5")
    return startsWith(text, "\x89HDF\r\n") && !holdsOtherThings(path);
  if (name == "checkpoint.h5")
    return startsWith(text, "\x89RHEGMA");
  if (name == "run.lock")
    return startsWith(text, "host: ");
  const char* const mark = name == "fields.xdmf"    ? "<Xdmf"
                           : name == "summary.json" ? "\"effects\""
                                                    : "\"manifest_crc32\"";
  return text.find(mark) != std::string::npos;
}

void removeFrom(const std::string& folder, const std::string& name)
{
  std::error_code ignored; // a file that can't be removed can't be written either, which is reported
  std::filesystem::remove(std::filesystem::path(folder) / name, ignored);
}

} // namespace

const std::vector<std::string>& resultNames()
{
  static const std::vector<std::string> names = {"summary.json", "history.csv",   "fields.xdmf",
                                                 "fields.h5",    "checkpoint.h5", "manifest.json"};
  return names;
}

void refuseForeignFiles(const std::string& folder, const std::string& scene)
{
  std::vector<std::string> names = resultNames();
  names.push_back("run.lock");
  // Files of a folder that a run lists may be damaged; they are a run's all the same.
  const bool listed = isOfRun("", "manifest.json", beginningOf(folder + "/manifest.json") + " ");
  for (const std::string& name : names)
  {
    const std::string path = folder + "/" + name;
    std::error_code none;
    if (!std::filesystem::exists(path, none))
      continue;
    if (std::filesystem::equivalent(path, scene, none))
      refuse(folder, "the run would overwrite its own scene " + scene);
    if (!std::filesystem::is_regular_file(path, none) || !(listed || isOfRun(path, name, beginningOf(path))))
      refuse(folder, "it holds a " + name + " that no run wrote, and that a run would replace; move it away");
  }
}

void removeOldSummary(const std::string& folder)
{
  removeFrom(folder, "summary.json");
  removeFrom(folder, "manifest.json");
  for (const std::string& name : resultNames())
    removeFrom(folder, name + ".part");
}

void removeOldResults(const std::string& folder)
{
  removeOldSummary(folder);
  for (const std::string& name : resultNames())
    removeFrom(folder, name);
}

} // namespace Rhegma
