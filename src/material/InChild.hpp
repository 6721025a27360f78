#pragma once
/// A function that runs in a process of its own, so that what it breaks is not this one.

#include <functional>
#include <string>

namespace Rhegma
{

/// What the other process sends to this one.
class ChildTalk
{
public:
  explicit ChildTalk(int file) : file_(file) {}
  /// Begins a stage. \param seconds that it may take at most, up to 255
  void stage(char name, int seconds);
  /// What the function found; once, at its end.
  void answer(const std::string& text);

private:
  int file_; ///< -1: nobody listens
};

/// How the function ended.
struct ChildEnd
{
  enum class How
  {
    Answered,
    Exited,    ///< the process ended before, by exit() or STOP
    Killed,    ///< by a signal
    Late,      ///< a stage took too long
    NotStarted ///< there is no process for it; it has not run
  };
  How how = How::NotStarted;
  int signal = 0;
  char stage = '\0';  ///< the last that began
  std::string answer; ///< of Answered
  std::string said;   ///< first line that it printed; may be empty
};

/// Runs a function in a copy of this process, which prints nothing, leaves no core file, and ends without
/// calling what is registered for the end of this one. It may load and call libraries, but not MPI nor
/// Kokkos. An exception of the function is a signal (abort).
ChildEnd inChild(const std::function<void(ChildTalk&)>& function);

} // namespace Rhegma
