#include "program/ScenePicture.hpp"

#include <cstdlib>
#include <ostream>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

extern char** environ;

namespace Rhegma::program
{

namespace
{

const std::string tool = "rhegma-plot";

bool canRun(const std::string& path) { return access(path.c_str(), X_OK) == 0; }

/// Path of the running program; empty where the system does not say.
std::string ownPath()
{
  char path[4096];
  const ssize_t length = readlink("/proc/self/exe", path, sizeof path);
  return length > 0 && length < static_cast<ssize_t>(sizeof path) ? std::string(path, length) : std::string();
}

/// The tool; only its name where the PATH has to say where it is.
std::string findTool()
{
  if (const char* const folder = std::getenv("RHEGMA_TOOLS"); folder != nullptr)
    return std::string(folder) + "/" + tool;
  std::string folder = ownPath();
  for (std::size_t end = folder.rfind('/'); end != std::string::npos && end > 0; end = folder.rfind('/'))
  {
    folder.resize(end);
    for (const std::string& path : {folder + "/" + tool, folder + "/tools/" + tool})
      if (canRun(path))
        return path;
  }
  return tool;
}

} // namespace

int drawScene(const Options& options, const Ranks& ranks, std::ostream& err)
{
  if (ranks.many())
  {
    if (ranks.rank() == 0)
      err << "rhegma: --picture draws on one rank only; leave mpirun out\n";
    return exitWrongScene;
  }
  std::vector<std::string> words{findTool(), "--scene", options.scene, "--output", options.picture};
  if (const std::string own = ownPath(); !own.empty())
    words.insert(words.end(), {"--rhegma", own});
  if (!options.state.empty())
    words.insert(words.end(), {"--state", options.state});
  for (const std::string& one : options.overrides)
    words.insert(words.end(), {"--set", one});
  std::vector<char*> pointers;
  for (std::string& word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  pid_t child = 0;
  int status = 0;
  if (posix_spawnp(&child, pointers[0], nullptr, nullptr, pointers.data(), environ) != 0 ||
      waitpid(child, &status, 0) != child || !WIFEXITED(status) || WEXITSTATUS(status) == 127)
  {
    err << "rhegma: --picture needs the program " << tool
        << ", which is in the folder tools of the source; write that folder into RHEGMA_TOOLS, or leave "
           "--picture "
           "out\n";
    return exitWrongScene;
  }
  return WEXITSTATUS(status) == 0 ? exitFinished : exitWrongScene;
}

} // namespace Rhegma::program
