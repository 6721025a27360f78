#pragma once
/// Signals that ask a run to stop.

#include <string>

namespace Rhegma::program
{

/// While it lives, the first SIGINT, SIGTERM or SIGHUP is only noted, so that the run can end after its step
/// with its files whole; a second one ends the program as ever.
class StopSignal
{
public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  /// Name of the signal that came, such as "SIGTERM"; empty while none has.
  std::string name() const;
};

} // namespace Rhegma::program
