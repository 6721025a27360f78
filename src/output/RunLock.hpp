#pragma once
/// One run in a folder at a time.

#include <string>

namespace Rhegma
{

/// Holds DIR/run.lock, in which host, process and start of the run are written, and removes it at its end.
///
/// The file is locked (flock), so that a lock of a run that has died is known as stale on the machine on
/// which it ran, also where another process has its number now. What a run on another machine left can't be
/// judged from here and is left alone.
class RunLock
{
public:
  /// Throws std::invalid_argument, with who runs there and what to do, where another run has the folder.
  explicit RunLock(const std::string& folder);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

private:
  std::string path_;
  int file_ = -1;
};

/// Throws as RunLock does where another run has the folder; makes nothing, and refuses no run that starts
/// meanwhile.
void refuseFolderInUse(const std::string& folder);

} // namespace Rhegma
