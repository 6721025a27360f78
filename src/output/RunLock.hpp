#pragma once
/// One run in a folder at a time.

#include <chrono>
#include <string>

namespace Rhegma
{

/// Holds DIR/run.lock, in which host, process and start of the run are written, and removes it at its end.
///
/// The file is locked (flock), so that a lock of a run that has died is known as stale on the machine on
/// which it ran, also where another process has its number now. What a run on another machine left can't be
/// judged from here and is left alone. A file that somebody removes during the run no longer keeps other runs
/// out: loss() finds that, and the file of another run is never removed.
class RunLock
{
public:
  /// Throws std::invalid_argument, with who runs there and what to do, where another run has the folder.
  explicit RunLock(const std::string& folder);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

  /// Whether the last call of loss(), or the start, is more than a second ago.
  bool isDue() const;
  /// Whether run.lock has been removed or replaced. A removed one is made again unless another run has the
  /// folder. \return why this run must stop; empty if nothing has changed
  std::string loss();
  /// Whether the folder was this run's when loss() was called last.
  bool holds() const { return holds_; }
  /// Removes the file, if it is this run's.
  void remove() const;

private:
  using Clock = std::chrono::steady_clock;

  /// Whether the path is still this run's file.
  bool isOwn() const;
  void writeOwner() const;
  /// Makes and locks the file again. \return false: another run has made one, or it can't be made
  bool takeAgain();

  std::string folder_, path_, start_;
  int file_ = -1;
  bool holds_ = true;
  Clock::time_point next_; ///< time of the next look
};

/// Removes the run.lock that this process holds, if it does: the process ends without destructors.
void removeRunLock();

/// Throws as RunLock does where another run has the folder; makes nothing, and refuses no run that starts
/// meanwhile.
void refuseFolderInUse(const std::string& folder);

} // namespace Rhegma
