#include "program/StopSignal.hpp"

#include "base/StopRequest.hpp"

#include <csignal>

namespace Rhegma::program
{

namespace
{

constexpr int watched[] = {SIGINT, SIGTERM, SIGHUP};

volatile std::sig_atomic_t received = 0;

// A signal handler: it may do no more than this.
extern "C" void note(int signal)
{
  received = signal;
  requestStop();
}

void install(void (*handler)(int))
{
  for (const int signal : watched)
  {
    struct sigaction before = {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler == SIG_IGN) // as under nohup
      continue;
    struct sigaction action = {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART | SA_RESETHAND;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
  }
}

} // namespace

StopSignal::StopSignal()
{
  received = 0;
  clearStopRequest();
  install(note);
}

StopSignal::~StopSignal()
{
  install(SIG_DFL);
  clearStopRequest(); // what follows the run may solve as well
}

std::string StopSignal::name() const
{
  switch (received)
  {
  case SIGINT:
    return "SIGINT";
  case SIGTERM:
    return "SIGTERM";
  case SIGHUP:
    return "SIGHUP";
  default:
    return {};
  }
}

} // namespace Rhegma::program
