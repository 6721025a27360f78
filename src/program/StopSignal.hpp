#pragma once
/// Signals that stop a run.

#include <string>

namespace Rhegma::program
{

/// During its lifetime, the first SIGINT, SIGTERM or SIGHUP is only recorded (and base/StopRequest.hpp asked
/// to stop), so that the run can end after its step with complete files, and a load step of equilibrium,
/// which may take long, gives up; a second one ends the program.
class StopSignal
{
public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  /// Name of the received signal, such as "SIGTERM"; empty if none.
  std::string name() const;
};

} // namespace Rhegma::program
