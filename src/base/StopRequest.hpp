#pragma once
/// Whether the process has been asked to stop, for what takes long and can give up.

#include "base/RunError.hpp"

namespace Rhegma
{

/// Asks the process to stop, until `clearStopRequest`. A signal handler may call it.
void requestStop();
/// Takes the request back.
void clearStopRequest();
/// Whether this process has been asked to stop; without a handler that asks it never is.
bool stopRequested();

/// Thrown by a solution that gives up because the process was asked to stop.
class StopRequested : public RunError
{
public:
  using RunError::RunError;
};

} // namespace Rhegma
