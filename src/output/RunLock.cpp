#include "output/RunLock.hpp"

#include "base/UtcTime.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <stdexcept>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace Rhegma
{

namespace
{

constexpr const char* name = "/run.lock";
constexpr std::chrono::seconds betweenLooks{1};

const RunLock* held = nullptr; // the last one

std::string thisHost()
{
  char host[256] = "";
  gethostname(host, sizeof host - 1);
  return host;
}

/// What a run wrote into its lock.
struct Owner
{
  std::string host, process, start;

  explicit Owner(int file)
  {
    char text[1024];
    const ssize_t length = pread(file, text, sizeof text, 0);
    const std::string all(text, length > 0 ? length : 0);
    host = entry(all, "host: ");
    process = entry(all, "process: ");
    start = entry(all, "started: ");
  }

  static std::string entry(const std::string& text, const std::string& key)
  {
    const std::size_t at = text.find(key);
    return at == std::string::npos ? std::string()
                                   : text.substr(at + key.size(), text.find('\n', at) - at - key.size());
  }
};

std::string asText(const Owner& owner)
{
  return "process " + (owner.process.empty() ? "?" : owner.process) + " on " +
         (owner.host.empty() ? "this machine" : owner.host) +
         (owner.start.empty() ? "" : " since " + owner.start);
}

[[noreturn]] void refuse(const std::string& folder, const Owner& owner, bool surely)
{
  const std::string who = asText(owner);
  throw std::invalid_argument(
      surely ? "the output folder " + folder + " is in use by another run (" + who +
                   "); wait for its end, or choose another folder with --output"
             : "the output folder " + folder + " was taken by a run on another machine (" + who +
                   "), and whether it still runs can't be seen from here; if it does not, remove " + folder +
                   name + ", else choose another folder with --output");
}

/// Where file systems have no locks, a process that lives decides.
bool isAlive(const std::string& process)
{
  const long number = std::strtol(process.c_str(), nullptr, 10);
  return number > 0 && number != getpid() && (kill(static_cast<pid_t>(number), 0) == 0 || errno == EPERM);
}

/// Locks an open file for a run. Whoever only asks shares the lock for a moment, in which no run may be
/// refused. \return as flock
int lockAlone(int file)
{
  constexpr int attempts = 2000;
  for (int k = 0;; ++k)
  {
    if (flock(file, LOCK_EX | LOCK_NB) == 0)
      return 0;
    if (errno != EWOULDBLOCK || k >= attempts)
      return -1;
    if (flock(file, LOCK_SH | LOCK_NB) != 0) // another run has it
      return -1;
    flock(file, LOCK_UN);
    usleep(1000);
  }
}

/// Locks an open file. Throws, and closes it, where another run has it.
/// \param shared only to see that no run has it
void lock(const std::string& folder, int file, bool shared)
{
  const bool locked = (shared ? flock(file, LOCK_SH | LOCK_NB) : lockAlone(file)) == 0;
  const bool taken = !locked && errno == EWOULDBLOCK;
  const Owner owner(file);
  const bool elsewhere = !owner.host.empty() && owner.host != thisHost();
  if (locked ? !elsewhere : !taken && !elsewhere && !isAlive(owner.process))
    return;
  close(file);
  refuse(folder, owner, !elsewhere || taken);
}

/// Whether a path still is the file that was opened: its run may have ended and removed it meanwhile.
bool isStill(const std::string& path, int file)
{
  struct stat named = {}, open = {};
  return stat(path.c_str(), &named) == 0 && fstat(file, &open) == 0 && named.st_ino == open.st_ino &&
         named.st_dev == open.st_dev;
}

} // namespace

RunLock::RunLock(const std::string& folder)
    : folder_(folder), path_(folder + name), start_(utcTime(std::time(nullptr)))
{
  for (;;)
  {
    file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644);
    if (file_ < 0)
      throw std::invalid_argument(path_ + " can't be written: " + std::strerror(errno) +
                                  "; remove it, or choose another folder with --output");
    lock(folder, file_, false);
    if (isStill(path_, file_))
      break;
    close(file_);
  }
  writeOwner();
  next_ = Clock::now() + betweenLooks;
  held = this;
}

void RunLock::writeOwner() const
{
  const std::string text =
      "host: " + thisHost() + "\nprocess: " + std::to_string(getpid()) + "\nstarted: " + start_ + "\n";
  // On a full disk the file stays empty; it is locked all the same.
  if (ftruncate(file_, 0) != 0 || pwrite(file_, text.data(), text.size(), 0) < 0)
    return;
}

RunLock::~RunLock()
{
  remove();
  close(file_);
  if (held == this)
    held = nullptr;
}

void RunLock::remove() const
{
  if (isOwn())
    unlink(path_.c_str());
}

bool RunLock::isDue() const { return Clock::now() >= next_; }

bool RunLock::isOwn() const
{
  struct stat any = {};
  if (stat(path_.c_str(), &any) != 0)
    return errno != ENOENT && errno != ENOTDIR; // a network that fails for a moment removes nothing
  if (isStill(path_, file_))
    return true;
  // Some file systems give a file another number when it is looked up again.
  const int file = open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (file < 0)
    return false;
  const Owner owner(file);
  close(file);
  return owner.host == thisHost() && owner.process == std::to_string(getpid()) && owner.start == start_;
}

bool RunLock::takeAgain()
{
  const int file = open(path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (file < 0)
    return false;
  if (lockAlone(file) != 0 && errno == EWOULDBLOCK)
  {
    close(file);
    return false;
  }
  close(file_);
  file_ = file;
  writeOwner();
  return isStill(path_, file_);
}

std::string RunLock::loss()
{
  next_ = Clock::now() + betweenLooks;
  if (isOwn())
    return {};
  const std::string me = "process " + std::to_string(getpid()) + " on " + thisHost() + " since " + start_;
  holds_ = takeAgain();
  if (holds_)
    return path_ + " of this run (" + me +
           ") was removed during the run, so that another run could have replaced its files";
  const int file = open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0)
    return path_ + " of this run (" + me +
           ") was removed during the run and can't be made again: " + std::strerror(errno) +
           "; nothing more is written";
  const std::string other = asText(Owner(file));
  close(file);
  return "another run (" + other + ") has taken the output folder " + folder_ + " of this run (" + me +
         "), after " + path_ + " had been removed; the files there are left to the other run";
}

void removeRunLock()
{
  if (held != nullptr)
    held->remove();
}

void refuseFolderInUse(const std::string& folder)
{
  const int file = open((folder + name).c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0)
    return;
  lock(folder, file, true);
  close(file);
}

} // namespace Rhegma
