#include "base/StopRequest.hpp"

#include <csignal>

namespace Rhegma
{

namespace
{

volatile std::sig_atomic_t requested = 0;

} // namespace

void requestStop() { requested = 1; }

void clearStopRequest() { requested = 0; }

bool stopRequested() { return requested != 0; }

} // namespace Rhegma
