#include "output/OutputFolder.hpp"

#include "base/OutputError.hpp"
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

/// Whether a file of HDF5 opens, and holds a first frame or nothing yet.
bool holdsFrames(const std::string& path)
{
  const Silence silence;
  const Handle access(accessWithoutLock(), H5Pclose, path);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
  H5G_info_t info{};
  const bool holds = file >= 0 && H5Gget_info(file, &info) >= 0 &&
                     (info.nlinks == 0 || H5Lexists(file, "t00000", H5P_DEFAULT) > 0);
  if (file >= 0)
    Silence::unlessDamaged(H5Fclose(file) >= 0);
  return holds;
}

/// Whether the first line of a text names the columns that each history has.
bool beginsLikeAHistory(const std::string& text)
{
  const std::string header = text.substr(0, text.find_first_of("\r\n")) + ",";
  return startsWith(header, "time,kinetic,strain,") && header.find(",external_work,") != std::string::npos &&
         header.find(",residual,") != std::string::npos;
}

/// Whether a run has written a file. \param text its beginning
bool isOfRun(const std::string& path, const std::string& name, const std::string& text)
{
  if (text.empty()) // cut off at once
    return true;
  if (name == "history.csv")
    return beginsLikeAHistory(text);
  if (name == "fronts.csv")
    return startsWith(text, "time,crack,front,node,s,");
  if (name == "fields.h5" || name == "fronts.h5")
    return startsWith(text, "\x89HDF\r\n") && holdsFrames(path);
  if (name == "watch.html")
    return text.find("<!-- a run of rhegma -->") != std::string::npos;
  if (name == "checkpoint.h5")
    return startsWith(text, "\x89RHEGMA");
  if (name == "run.lock")
    return startsWith(text, "host: ");
  if (name == comparisonName)
    return startsWith(text, "{") && text.find("\"answers\"") != std::string::npos &&
           text.find("\"verdict\"") != std::string::npos;
  const char* const mark = name == "fields.xdmf"    ? "<Xdmf"
                           : name == "summary.json" ? "\"effects\""
                                                    : "\"manifest_crc32\"";
  return text.find(mark) != std::string::npos;
}

/// Throws where a file that would be replaced is the scene or is none that a run wrote.
/// \param listed whether the folder's manifest says that a run wrote it
void refuseForeignFile(const std::string& folder, const std::string& scene, const std::string& name,
                       bool listed)
{
  const std::string path = folder + "/" + name;
  std::error_code none;
  for (const std::string& replaced : {path, path + ".part"})
    if (std::filesystem::equivalent(replaced, scene, none))
      refuse(folder, "the run would overwrite its own scene " + scene);
  if (std::filesystem::exists(path, none) &&
      !(std::filesystem::is_regular_file(path, none) && (listed || isOfRun(path, name, beginningOf(path)))))
    refuse(folder, "it holds a " + name + " that no run wrote, and that a run would replace; move it away");
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
                                                 "fields.h5",    "fronts.csv",    "watch.html",
                                                 "fronts.h5",    "checkpoint.h5", "manifest.json"};
  return names;
}

void refuseForeignFiles(const std::string& folder, const std::string& scene)
{
  // Files of a folder that a run lists may be damaged; they are a run's all the same.
  const bool listed = isOfRun("", "manifest.json", beginningOf(folder + "/manifest.json") + " ");
  for (const std::string& name : resultNames())
    refuseForeignFile(folder, scene, name, listed);
  refuseForeignFile(folder, scene, "run.lock", listed);
}

void refuseForeignComparison(const std::string& folder, const std::string& scene)
{
  refuseForeignFile(folder, scene, comparisonName, false);
  refuseForeignFile(folder, scene, "run.lock", false);
}

void removeOldComparison(const std::string& folder)
{
  removeFrom(folder, comparisonName);
  removeFrom(folder, std::string(comparisonName) + ".part");
}

std::string setAside(const std::string& path)
{
  const std::filesystem::path of(path);
  const std::string start = (of.parent_path() / of.stem()).string() + ".unread";
  for (int k = 1;; ++k)
  {
    const std::string name = start + (k > 1 ? "." + std::to_string(k) : "") + of.extension().string();
    std::error_code error;
    if (std::filesystem::symlink_status(name, error).type() != std::filesystem::file_type::not_found)
      continue;
    std::filesystem::rename(path, name, error);
    if (error)
      throw OutputError(path + " can't be renamed to " + name + ": " + error.message());
    return name;
  }
}

void removeOldSummary(const std::string& folder)
{
  removeFrom(folder, "summary.json");
  removeFrom(folder, "manifest.json");
  removeFrom(folder, "watch.html");
  // The files that are written to such a name first.
  for (const char* name : {"summary.json", "manifest.json", "fields.xdmf", "checkpoint.h5", "watch.html"})
    removeFrom(folder, std::string(name) + ".part");
}

void removeOldResults(const std::string& folder)
{
  removeOldSummary(folder);
  for (const std::string& name : resultNames())
    removeFrom(folder, name);
}

} // namespace Rhegma
